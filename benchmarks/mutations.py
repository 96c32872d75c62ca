"""How many small faults the tests notice: a sample of mutants of a module, each tried on the tests that guard it.

cosmic-ray makes the mutants (`pip install cosmic-ray`, in an environment of its own: `--cosmic-ray` is its program).
Run it in a clone: it changes files, and puts them back. `python benchmarks/mutations.py --cosmic-ray PATH --out DIR`
writes `mutations.md` there; docs/mutations.md has the last one.
"""

import argparse
import random
import sqlite3
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
SAMPLE, CPU_S, TIMEOUT_S = 45, 90, 1800  # a mutant without an end is killed by its processor time: machines are busy
WIRE = "tests/wire/test_wire_frames.py tests/wire/test_wire_recording.py tests/wire/test_wire_numbers.py"
DECISION = "tests/diagnosis/choice/test_judged.py tests/diagnosis/choice/test_recalibration.py"
VERDICT = "tests/diagnosis/choice/test_outcome.py tests/diagnosis/choice/test_compare.py"
WEIGHING = " ".join(f"tests/diagnosis/choice/test_{of}.py" for of in ("weigh", "kept", "judged"))
SEARCH = " ".join(
    f"tests/diagnosis/choice/test_{of}.py"
    for of in ("search_made", "three_instead", "candidates", "search", "cross_validation")
)
CHANCE = " ".join(f"tests/diagnosis/choice/test_{of}.py" for of in ("chance", "excursions", "closest"))
JUDGE = "tests/diagnosis/numerics/test_judge.py tests/diagnosis/numerics/test_recogniser.py"
TARGETS = {
    "strokes": (
        {"run/strokes.py", "run/standstills.py", "run/turning.py", "run/clean_motion.py"},
        " ".join(f"tests/run/test_{of}.py" for of in ("strokes", "coarse_strokes", "clean_motion", "row_groups")),
    ),
    "dataset": (
        {"stages/dataset.py", "stages/points.py", "stages/splits.py"},
        "tests/stages/test_dataset.py tests/stages/test_dataset_losses.py",
    ),
    "wire": ({"wire/frames.py", "wire/cobs.py", "wire/hello.py", "wire/growing_account.py", "wire/stamps.py"}, WIRE),
    "pieces": (
        {"wire/mending.py", "wire/in_order.py", "wire/decoded_recording.py"},
        "tests/wire/test_wire_mending.py tests/wire/test_wire_pieces.py tests/wire/test_wire_recording.py",
    ),
    "account": (
        {
            f"wire/{module}.py"
            for module in ("batch", "check", "counters", "frame_account", "possible_numbers", "timeline")
        },
        " ".join(
            f"tests/wire/test_wire_{of}.py" for of in ("account", "frames", "recording", "numbers", "pieces", "mending")
        ),
    ),
    "motion": ({"wire/motion.py"}, "tests/wire/test_wire_motion.py tests/wire/test_wire_frames.py"),
    "decision": ({"diagnosis/choice/judged.py", "diagnosis/choice/recalibration.py"}, DECISION),
    "verdict": ({"diagnosis/choice/outcome.py", "diagnosis/choice/compare.py"}, VERDICT),
    "weighing": ({"diagnosis/choice/weigh.py", "diagnosis/choice/kept.py"}, WEIGHING),
    "search": (
        {f"diagnosis/choice/{module}.py" for module in ("search", "three_instead", "candidates", "cross_validation")},
        SEARCH,
    ),
    "chance": ({f"diagnosis/choice/{module}.py" for module in ("chance", "excursions", "closest")}, CHANCE),
    "judge": ({"diagnosis/numerics/judge.py", "diagnosis/numerics/recogniser.py"}, JUDGE),
}
TYPES = "ReplaceBinaryOperator_BitOr_"  # `int | None` in a signature: no fault that a program could have


def cosmic_ray(program: Path, *words: str) -> str:
    """What cosmic-ray prints."""
    return subprocess.run([program, *words], cwd=ROOT, check=True, capture_output=True, text=True).stdout


def sample(sessions: list[Path], count: int, seed: int) -> None:
    """Leave so many mutants in all in the sessions, drawn at random, those of types in signatures aside."""
    drawn: list[tuple[Path, str]] = []
    for session in sessions:
        with sqlite3.connect(session) as base:
            told = base.execute(
                "SELECT job_id, operator_name FROM mutation_specs "
                "ORDER BY operator_name, start_pos_row, start_pos_col, occurrence"
            )
            drawn += [(session, job) for job, operator in told if TYPES not in operator]
    kept = {job for _, job in random.Random(seed).sample(drawn, min(count, len(drawn)))}
    for session in sessions:
        with sqlite3.connect(session) as base:
            for table in ("mutation_specs", "work_items"):
                jobs = [job for (job,) in base.execute(f"SELECT job_id FROM {table}") if job not in kept]
                base.executemany(f"DELETE FROM {table} WHERE job_id = ?", [(job,) for job in jobs])


def tried(program: Path, name: str, out: Path, count: int, seed: int) -> list[tuple[str, str, int, str]]:
    """Each mutant of a target: module, operator, line, and whether it was `killed` or `survived`."""
    modules, tests = TARGETS[name]
    sessions = []
    for module in sorted(modules):
        config, session = (out / f"{module.replace('/', '-')}.{ending}" for ending in ("toml", "sqlite"))
        command = f"prlimit --cpu={CPU_S} {sys.executable} -m pytest -x -q -n 0 -p no:cacheprovider {tests}"
        config.write_text(
            f'[cosmic-ray]\nmodule-path = "pipeline/{module}"\ntimeout = {TIMEOUT_S}\nexcluded-modules = []\n'
            f'test-command = "{command}"\n[cosmic-ray.distributor]\nname = "local"\n'
        )
        if not session.exists():
            cosmic_ray(program, "init", str(config), str(session))
        sessions.append(session)
    sample(sessions, count, seed)
    if subprocess.run(command.split(), cwd=ROOT, capture_output=True).returncode:
        sys.exit(f"{name}: its tests fail without a mutant, so that each one would be killed: {command}")
    results = []
    for module, session in zip(sorted(modules), sessions, strict=True):
        cosmic_ray(program, "exec", str(session.with_suffix(".toml")), str(session))
        with sqlite3.connect(session) as base:
            told = base.execute(
                "SELECT operator_name, start_pos_row, test_outcome FROM mutation_specs JOIN work_results USING (job_id)"
            )
            results += [(module, operator, line, outcome.lower()) for operator, line, outcome in told]
        print(f"{module}: {sum(one[0] == module for one in results)} mutants", flush=True)
    return results


def main() -> None:
    """Try the targets that are asked for, or all, and write the table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("targets", nargs="*", choices=[*TARGETS, []], default=[], help="default: all")
    parser.add_argument("--cosmic-ray", type=Path, required=True, help="the program")
    parser.add_argument("--out", type=Path, required=True, help="folder of sessions and table; sessions go on")
    parser.add_argument("--sample", type=int, default=SAMPLE, help="mutants of each target")
    parser.add_argument("--seed", type=int, default=1, help="of the draw; another one needs another folder")
    arguments = parser.parse_args()
    arguments.out.mkdir(parents=True, exist_ok=True)
    out = arguments.out.resolve()
    lines = ["| target | mutants | killed | survived |", "|---|---|---|---|"]
    survivors = []
    for name in arguments.targets or TARGETS:
        results = tried(arguments.cosmic_ray, name, out, arguments.sample, arguments.seed)
        lived = [one for one in results if "survived" in one[3]]
        share = 100 * (len(results) - len(lived)) / max(len(results), 1)
        lines.append(f"| {name} | {len(results)} | {len(results) - len(lived)} ({share:.0f} %) | {len(lived)} |")
        survivors += [f"- `{module}` line {line}: {operator}" for module, operator, line, _ in lived]
    (out / "mutations.md").write_text("\n".join([*lines, "", *survivors]) + "\n")


if __name__ == "__main__":
    main()
