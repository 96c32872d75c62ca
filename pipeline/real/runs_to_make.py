"""A folder of downloaded files → the runs to make: the rig of each, and which runs belong together."""

import re
from collections import Counter
from dataclasses import dataclass
from pathlib import Path
from typing import TypedDict

from ..ground.errors import BadInput
from ..ground.names import slug
from .rigs import MAPPINGS, Rig, read_rigs

LEAST_TOGETHER = 2
MOST_LISTED = 500  # of them on a page
SHOWN = 8  # files that a sentence names
ALL_OTHERS = "all others"  # where a method learnt from every other run of the group
NONE_GIVEN = "give the folder with the downloaded files: --config recordings=DIR; docs/real.md says where to get them"


class RealConfig(TypedDict, total=False):
    """The configuration of public recordings: the folder where a person put them."""

    recordings: str | None


@dataclass(frozen=True)
class Recording:
    """One run to make: a file, the mapping that reads it, and the group of runs that show the same thing."""

    run: str
    rig: str
    group: str
    file: Path
    mapping: Path


@dataclass(frozen=True)
class RealPlan:
    """All runs, in order of rig and name."""

    recordings: tuple[Recording, ...]
    passed_over: tuple[str, ...] = ()  # names of files that no pattern knows, from the folder on

    def __getitem__(self, run: str) -> Recording:
        """The recording of a run; raises KeyError."""
        return {recording.run: recording for recording in self.recordings}[run]

    @property
    def rigs(self) -> list[str]:
        """Rigs of which there is a file."""
        return list(dict.fromkeys(recording.rig for recording in self.recordings))

    def runs(self, rig: str) -> list[str]:
        """Names of a rig's runs."""
        return [recording.run for recording in self.recordings if recording.rig == rig]

    def groups(self, rig: str) -> dict[str, list[str]]:
        """Names of the runs of each group of a rig that has more than one."""
        runs_by_group: dict[str, list[str]] = {}
        for recording in self.recordings:
            if recording.rig == rig:
                runs_by_group.setdefault(recording.group, []).append(recording.run)
        return {group: runs for group, runs in runs_by_group.items() if len(runs) >= LEAST_TOGETHER}

    @property
    def said(self) -> str:
        """The files that were passed over and the reasons, in one sentence; empty where there were none."""
        if not self.passed_over:
            return ""
        first = ", ".join(map(ascii, self.passed_over[:SHOWN]))
        more = f" and {len(self.passed_over) - SHOWN} more" if len(self.passed_over) > SHOWN else ""
        files = f"{len(self.passed_over)} file{'s' * (len(self.passed_over) > 1)}"
        return f"passed over {files} whose names no pattern of pipeline/config/real.yaml knows: {first}{more}"

    @property
    def shown(self) -> list[str]:
        """The passed-over files for a page, in a form that no command takes for an option."""
        more = len(self.passed_over) - MOST_LISTED
        return [f"./{name}" for name in self.passed_over[:MOST_LISTED]] + [f"and {more} more"] * (more > 0)

    def tables(self, _: object) -> list[str]:
        """The sources of the page over all rigs; raises BadInput without recordings."""
        if not self.recordings:
            raise BadInput("configuration", "recordings", "is not given", NONE_GIVEN)
        return [f"processed/real/table/{rig}.csv" for rig in self.rigs]


def _known(pattern: str, file: Path) -> re.Match[str] | None:
    """How a pattern matches the name of a file without .gz, or that name with its folder's."""
    plain = re.sub(r"\.gz$", "", file.name, flags=re.I)
    names = (plain, f"{file.parent.name}/{plain}")
    return next((match for name in names if (match := re.fullmatch(pattern, name, re.I))), None)


def make_real_plan(folder: Path, rigs: dict[str, Rig]) -> RealPlan:
    """The plan for every file below a folder whose name fits a rig's pattern.

    Raises BadInput when the folder is not there, holds no such file, or holds one twice.
    """
    if not folder.is_dir():
        raise BadInput(folder, "recordings", "is no folder", NONE_GIVEN)
    files = sorted(path for path in folder.rglob("*") if path.is_file() and not path.name.startswith("."))
    listed: list[tuple[str, str, str, Path, Path]] = []
    for rig, described in rigs.items():
        for kind in described.files:
            for file in files:
                match = _known(kind.pattern, file)
                if match:
                    run = f"{kind.name}-{slug(match[0].rsplit('.', 1)[0])}"
                    mapping = MAPPINGS / f"{kind.mapping}.yaml"
                    listed.append((run, rig, slug(match.expand(kind.group)), file, mapping))
    taken = {file for *_, file, _ in listed}
    passed_over = tuple(str(file.relative_to(folder)) for file in files if file not in taken)
    if not listed:
        mend = "docs/real.md says where to get the files; leave their names and folders as they are"
        passed_text = RealPlan((), passed_over).said
        problem = "holds no recording of a known rig" + (f"; {passed_text}" if passed_text else "")
        raise BadInput(folder, "recordings", problem, mend)
    times = Counter(run for run, *_ in listed)
    recordings: dict[str, Recording] = {}
    for run, rig, group, file, mapping in listed:
        name = run if times[run] == 1 else f"{run}-{slug(file.parent.name)}"
        if name in recordings:
            raise BadInput(file, "recordings", f"is there already as {recordings[name].file}", "remove one of the two")
        recordings[name] = Recording(name, rig, group, file, mapping)
    order = list(rigs)
    ordered = sorted(recordings.values(), key=lambda recording: (order.index(recording.rig), recording.run))
    return RealPlan(tuple(ordered), passed_over)


def plan_of(config: RealConfig) -> RealPlan:
    """The plan for `recordings` of the configuration, empty when that is not given; raises BadInput."""
    folder = config.get("recordings")
    return make_real_plan(Path(folder), read_rigs()) if folder else RealPlan(())
