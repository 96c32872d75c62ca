"""What the package says of itself holds: its parts, what it needs, its version; the checkout is not asked for more."""

import re
import sys
import tomllib
from pathlib import Path

import yaml
from imported import imported
from packaging.requirements import Requirement

from pipeline import __version__
from pipeline.__main__ import PROGRAMS
from pipeline.ground.errors import EXTRAS

ROOT = Path(__file__).resolve().parents[2]
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text())
SHIPPED = {name.replace("twistbench", "pipeline", 1) for name in PROJECT["tool"]["setuptools"]["packages"]}
# rooms that need the checkout: configurations, rules, other people's recordings, or what the diagnosis must not see
LEFT_BEHIND = {"pack", "proof", "real", "report", "stages.campaign", "workflow"}
OF_THE_RIG = {"pipeline.rig", "pipeline.rig.effects"}
NAMED = {"yaml": "pyyaml", "serial": "pyserial", "sklearn": "scikit-learn"}  # what a package is called where it is not


def package(path: Path) -> str:
    return ".".join(path.relative_to(ROOT).parent.parts)


SOURCES = [path for path in sorted((ROOT / "pipeline").rglob("*.py")) if package(path) in SHIPPED]


def requirements(lines: list[str]) -> dict[str, Requirement]:
    parsed = [Requirement(line) for line in lines]
    return {requirement.name.lower().replace("_", "-"): requirement for requirement in parsed}


def test_the_list_holds_every_package_of_the_rooms_that_are_shipped() -> None:
    packages = {package(path) for path in (ROOT / "pipeline").rglob("__init__.py")}
    behind = tuple(f"pipeline.{room}." for room in {"rig", *LEFT_BEHIND})
    rooms = {name for name in packages if not f"{name}.".startswith(behind)}
    assert rooms | OF_THE_RIG == SHIPPED


def test_what_is_shipped_imports_nothing_that_is_left_behind() -> None:
    every = {".".join(path.relative_to(ROOT).with_suffix("").parts) for path in (ROOT / "pipeline").rglob("*.py")}
    shipped_modules = {".".join(path.relative_to(ROOT).with_suffix("").parts) for path in SOURCES}
    for path in SOURCES:
        wanted = {name for name in imported(path) if name in every or f"{name}.__init__" in every}
        assert not {
            name for name in wanted if name not in shipped_modules and f"{name}.__init__" not in shipped_modules
        }, path


def test_what_is_shipped_names_its_own_modules_by_leading_dots() -> None:
    absolute = re.compile(r"^\s*(from|import) pipeline\b", re.M)
    assert not [path for path in SOURCES if absolute.search(path.read_text())]


def test_every_package_of_others_is_named_and_those_of_an_extra_are_not_needed_without_it() -> None:
    project = PROJECT["project"]
    base = set(requirements(project["dependencies"]))
    extras = {name: set(requirements(project["optional-dependencies"][name])) for name in EXTRAS.values()}
    assert {name: extra for extra, names in extras.items() for name in names} == EXTRAS
    tops = {name.split(".")[0] for path in SOURCES for name in imported(path)} - set(sys.stdlib_module_names)
    distributions = {NAMED.get(name, name.replace("_", "-")) for name in tops - {"pipeline", ""}}
    assert distributions == base | set(EXTRAS)


def test_every_bound_holds_what_the_lock_pins() -> None:
    project = PROJECT["project"]
    lines = (ROOT / "env" / "requirements.lock").read_text().splitlines()
    pins = dict(line.lower().replace("_", "-").split("==") for line in lines if "==" in line and line[0] != "#")
    named = [*project["dependencies"], *PROJECT["build-system"]["requires"]]
    named += [line for name in set(EXTRAS.values()) for line in project["optional-dependencies"][name]]
    for name, requirement in requirements(named).items():
        assert requirement.specifier and requirement.specifier.contains(pins[name]), requirement


def test_the_version_stands_in_one_place_and_is_told_elsewhere() -> None:
    citation = yaml.safe_load((ROOT / "CITATION.cff").read_text())
    assert PROJECT["tool"]["setuptools"]["dynamic"]["version"] == {"attr": "pipeline.__version__"}
    assert citation["version"] == __version__ and citation["license"] == PROJECT["project"]["license"]
    first = re.search(r"^## \[(.+?)\] - (\S+)$", (ROOT / "CHANGELOG.md").read_text(), re.M)
    assert first and first[1] == __version__ and first[2] == str(citation["date-released"])


def test_every_program_of_the_command_is_there_and_fits_its_line() -> None:
    for name, what in PROGRAMS.items():
        path = ROOT / "pipeline" / name.replace("-", "_")
        assert path.with_suffix(".py").is_file() or (path / "__main__.py").is_file(), name
        assert len(what) <= 84
