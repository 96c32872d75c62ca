"""The house's nevers: who may import whom, who may write, and what a rule may do."""

import ast
import re
import subprocess
import sys
from functools import cache
from pathlib import Path

import pytest
from imported import imported

ROOT = Path(__file__).parents[2]
MODULES = {
    ".".join(path.relative_to(ROOT).with_suffix("").parts).removesuffix(".__init__"): path
    for path in sorted((ROOT / "pipeline").rglob("*.py"))
}


@cache
def imports(module):
    """Modules of ours that a module imports."""
    return {name for name in imported(MODULES[module]) if name in MODULES} - {"pipeline", module}


@cache
def reach(module):
    """Modules of ours that a module imports, directly or not."""
    reached, waiting = set(), [module]
    while waiting:
        for name in imports(waiting.pop()) - reached:
            reached.add(name)
            waiting.append(name)
    return reached


def part(module):
    return module.split(".")[1] if "." in module else ""


# the proof's only modules that may use the diagnosis; of them `twins` and `teach` alone see both hands
BESIDE_THE_DIAGNOSIS = ("pipeline.proof.baselines", "pipeline.proof.twins", "pipeline.proof.teach")
# the one model, with its parts, that may use the diagnosis: it is what the diagnosis finds
DIAGNOSED = ("pipeline.models.diagnosed", "pipeline.models.parts.diagnosed")
# every room, from the ground up, and the rooms that it stands on
ROOMS = {
    "ground": "",
    "wire": "",
    "systems": "ground",
    "formats": "ground",
    "run": "ground wire systems formats",
    "string": "ground run",
    "foreign": "ground systems formats run",
    "capture": "ground wire run string",
    "rig": "ground wire run",
    "diagnosis": "ground systems run",
    "models": "ground formats run diagnosis",
    "stages": "ground run string models",
    "export": "ground models",
    "notebook": "ground systems run string diagnosis models stages",
    "lifespan": "ground run string",
    "settle": "ground wire run foreign capture notebook",
    "watch": "ground wire run capture settle",
    "proof": "ground run rig diagnosis",
    "real": "ground run string foreign diagnosis notebook",
    "report": "ground stages real",
    "workflow": "ground run",
    "pack": "ground workflow",
}
PROGRAMS = {
    "__main__",
    "adopt",
    "dataset",
    "diagnose",
    "fit_model",
    "import_run",
    "mend",
    "new_run",
    "predict",
    "simulate",
}


def test_a_room_stands_on_the_rooms_below_it_and_on_no_other():
    assert {part(module) for module in MODULES} - {""} == set(ROOMS) | PROGRAMS
    for room, below in ROOMS.items():
        used = {part(name) for module in MODULES if part(module) == room for name in imports(module)}
        assert used - {room} == set(below.split()), room
        assert set(below.split()) <= set(list(ROOMS)[: list(ROOMS).index(room)]), room


def test_the_hall_holds_programs_and_no_room_builds_on_them():
    for module in MODULES:
        if part(module) in PROGRAMS:
            text = MODULES[module].read_text()
            assert "def main(" in text and 'if __name__ == "__main__":' in text, module
        assert not {part(name) for name in imports(module)} & PROGRAMS, module


def test_the_ground_knows_no_room():
    for bottom in ("errors", "kinematics"):
        assert not imports(f"pipeline.ground.{bottom}") - {"pipeline.ground"}
    assert imports("pipeline.ground.stored.files") - {"pipeline.ground"} == {"pipeline.ground.errors"}


@pytest.mark.parametrize(
    ("package", "others"),
    [
        ("rig", {"models", "diagnosis", "report", "stages"}),
        ("models", {"rig", "diagnosis", "report", "capture"}),
        ("report", {"models", "rig", "diagnosis"}),
        ("capture", {"rig", "models", "report"}),
        ("diagnosis", {"rig", "models", "report", "proof"}),
        ("proof", {"diagnosis", "models", "report", "stages"}),
        ("lifespan", {"rig", "proof", "diagnosis", "models", "report", "capture", "stages"}),
    ],
)
def test_neighbours_do_not_reach_into_each_other(package, others):
    for module in MODULES:
        if part(module) == package:
            allowed = module.startswith((*BESIDE_THE_DIAGNOSIS, *DIAGNOSED))
            never = others - {"diagnosis"} if allowed else others
            assert not {part(name) for name in reach(module)} & never, module
        assert part(module) != "report" or "pipeline.stages.train" not in reach(module), module
    for module in MODULES:
        if not module.startswith(BESIDE_THE_DIAGNOSIS):
            assert not [name for name in reach(module) if name.startswith(BESIDE_THE_DIAGNOSIS)], module


def test_only_the_diagnosed_model_reaches_the_diagnosis_and_nobody_reaches_it():
    assert DIAGNOSED[0] in MODULES and "pipeline.diagnosis.study.engine" in reach(DIAGNOSED[0])
    for module in MODULES:
        if not module.startswith(DIAGNOSED):
            assert not [name for name in reach(module) if name.startswith(DIAGNOSED)], module


# every room of the diagnosis, from the ground up, and the rooms of it that it stands on; at its top is what ties them
DIAGNOSIS = "pipeline.diagnosis"
ROOMS_OF_DIAGNOSIS = {
    "document": "",
    "numerics": "",
    "recording": "document numerics",
    "mechanisms": "numerics recording",
    "fit": "document numerics recording mechanisms",
    "signature": "fit",
    "choice": "document numerics mechanisms fit signature",
    "study": "document numerics recording mechanisms fit choice",
    "facts": "document numerics recording mechanisms fit choice",
    "proposal": "document numerics recording mechanisms fit choice study facts",
    "prediction": "document recording mechanisms fit choice study",
    "words": "document recording mechanisms fit choice study facts proposal prediction",
    "drawing": "document recording choice prediction words",
    "adoption": "document recording mechanisms fit choice study facts prediction words",
}
# the same of the words; at their top are the two programs that make a page of docs/ from sources
WORDS = f"{DIAGNOSIS}.words"
ROOMS_OF_WORDS = {
    "language": "",
    "held_out": "language",
    "measured": "language held_out",
    "explanations": "language held_out measured",
    "named": "language held_out measured explanations",
    "foretold": "language held_out explanations",
    "next_run": "language held_out measured explanations named foretold",
    "pages": "language held_out measured explanations named foretold next_run",
}
# the same of the ground; at its top is what each of its rooms may use
GROUND = "pipeline.ground"
ROOMS_OF_GROUND = {
    "numbers": "",
    "stored": "numbers",
    "input": "stored",
    "code": "stored",
    "words": "stored",
}
# the same of the reports; at their top are the programs, one a rule
REPORT = "pipeline.report"
ROOMS_OF_REPORT = {
    "layout": "",
    "web": "layout",
    "shown": "",
    "model_to_take": "layout web shown",
    "drawn": "layout shown",
    "parts": "layout web shown model_to_take",
    "end_of_job": "layout model_to_take parts",
    "campaign": "layout web drawn",
    "real": "layout web",
}
# the same of a string's life
LIFESPAN = "pipeline.lifespan"
ROOMS_OF_LIFESPAN = {
    "stroke_health": "",
    "forecast": "stroke_health",
    "words": "stroke_health forecast",
    "score": "stroke_health forecast",
}
LARGER = {"mechanisms", "words"}  # a file for each mechanism; rooms of its own


def in_rooms(house):
    """The modules under a package, by its rooms; "" holds what stands at its top."""
    rooms = {}
    for module in MODULES:
        if module.startswith(f"{house}."):
            room, *inside = MODULES[module].relative_to(ROOT.joinpath(*house.split("."))).parts
            rooms.setdefault(room if inside else "", set()).add(module)
    return rooms


@pytest.mark.parametrize(
    ("house", "below", "listed"),
    [
        (GROUND, ROOMS_OF_GROUND, "ground/"),
        (DIAGNOSIS, ROOMS_OF_DIAGNOSIS, ""),
        (WORDS, ROOMS_OF_WORDS, "words/"),
        (REPORT, ROOMS_OF_REPORT, "report/"),
        (LIFESPAN, ROOMS_OF_LIFESPAN, "lifespan/"),
    ],
)
def test_a_room_of_a_large_room_stands_on_rooms_below_it_and_is_no_heap(house, below, listed):
    rooms = in_rooms(house)
    assert set(rooms) == {*below, ""}
    room_of = {module: room for room, modules in rooms.items() for module in modules}
    for room, lower in below.items():
        used = {room_of[name] for module in rooms[room] for name in imports(module) if name in room_of}
        used -= {""} if house == GROUND else set()
        assert used - {room} == set(lower.split()), room
        assert set(lower.split()) <= set(list(below)[: list(below).index(room)]), room
    rows = re.findall(rf"^\| `{listed}(\w+)` \|", (ROOT / "docs" / "source.md").read_text("utf-8"), re.M)
    assert rows == list(below), "docs/source.md lists them in this order"
    for room in set(rooms) - LARGER:
        assert len(rooms[room]) <= 16, f"{room}: part it"


def test_each_module_that_says_something_stands_in_a_room_of_the_words():
    assert in_rooms(WORDS)[""] == {f"{WORDS}.numbers_page", f"{WORDS}.physics_page"}


# what the rig and the diagnosis share beside ground, systems and wire: what a run folder is, and nothing that reads one
SHARED = {
    "pipeline.run", "pipeline.run.capture_json", "pipeline.run.description", "pipeline.run.folder",
    "pipeline.run.run_yaml",
}  # fmt: skip


def test_who_conceals_and_who_diagnoses_share_nothing_but_the_ground():
    concealing = {name for name in MODULES if part(name) in ("rig", "proof")}
    opening = "pipeline.proof.score"  # which cuts recordings into strokes as every stage does
    concealing = {name for name in concealing if not name.startswith((*BESIDE_THE_DIAGNOSIS, opening))}
    diagnosing = {name for name in MODULES if part(name) in ("diagnosis", "diagnose", "simulate")}
    common = concealing.union(*map(reach, concealing)) & diagnosing.union(*map(reach, diagnosing))
    assert common <= SHARED | {name for name in MODULES if part(name) in ("ground", "systems", "wire")}, common
    for module in MODULES:
        if module.startswith("pipeline.proof.baselines"):
            assert not reach(module) & concealing, module


def test_nobody_outside_the_rig_knows_its_effects():
    for module in MODULES:
        if part(module) not in ("rig", "proof"):
            assert not [name for name in imports(module) if name.startswith("pipeline.rig")], module


AUTHORS = "pipeline.rig.authors"
INTERFACE = f"{AUTHORS}.interface"


def author_of(module):
    """Name of the author whose package a module belongs to, or nothing."""
    name = module.removeprefix(f"{AUTHORS}.").split(".")[0]
    path = ROOT / "pipeline" / "rig" / "authors" / name / "__init__.py"
    return name if module.startswith(f"{AUTHORS}.") and path.is_file() else ""


def test_an_author_of_concealed_physics_knows_nobody_of_us():
    shared = {"pipeline.ground", "pipeline.ground.kinematics", "pipeline.ground.errors", INTERFACE}
    for module in filter(author_of, MODULES):
        own = {name for name in imports(module) if author_of(name) == author_of(module)}
        assert imports(module) - own <= shared, module
        tree = ast.parse(MODULES[module].read_text())
        assert not [node for node in ast.walk(tree) if isinstance(node, ast.ImportFrom) and node.level], module
        assert not {"importlib", "runpy", "__import__"} & set(re.findall(r"\w+", MODULES[module].read_text())), module
    ours = {name for name in imports(INTERFACE) | imports(AUTHORS)}
    assert ours == {INTERFACE}, "an author would reach more of us through what it shares"


def test_one_author_alone_uses_mujoco_and_nobody_imports_it_before_it_is_needed():
    users = {
        module for module, path in MODULES.items() if re.search(r"^\s*(from|import) mujoco", path.read_text(), re.M)
    }
    assert users == {f"{AUTHORS}.mechanics.engine"}
    program = f"import sys, {AUTHORS}; {AUTHORS}.authors(); sys.exit('mujoco' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", program], cwd=ROOT).returncode == 0


def test_nobody_but_the_proof_imports_an_author():
    for module in MODULES:
        if part(module) != "proof" and not module.startswith(AUTHORS):
            assert not [name for name in reach(module) if name.startswith(AUTHORS)], module
        if not author_of(module):
            assert not [name for name in imports(module) if author_of(name)], module


def test_imports_have_no_loops():
    for module in MODULES:
        assert module not in reach(module), module


def test_what_needs_no_torch_does_not_import_it():
    stages = [
        module for module in MODULES if part(module) in ("stages", "workflow") and module != "pipeline.stages.leak"
    ]
    shown = (
        "import_run",
        "new_run",
        "mend",
        "diagnose",
        "simulate",
        "adopt",
        "predict",
        "dataset",
        "fit_model",
        "capture",
        "export",
    )
    programs = [f"pipeline.{name}" for name in shown] + ["pipeline.export.__main__", "pipeline.export.onnx_model"]
    report = [module for module in MODULES if part(module) in ("report", "lifespan")]
    wanted = stages + programs + report + ["pipeline.models.traditional", DIAGNOSED[0]]
    program = f"import sys, {', '.join(wanted)}; sys.exit('torch' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", program], cwd=ROOT).returncode == 0


def test_wire_does_no_io_and_has_no_clock():
    for module, path in MODULES.items():
        if part(module) == "wire":
            names = {node.id for node in ast.walk(ast.parse(path.read_text())) if isinstance(node, ast.Name)}
            assert not names & {"open", "os", "time", "serial", "Path", "print"}, module


WRITERS = {"write_bytes", "write_text", "to_parquet", "to_csv", "write_table", "savefig", "copyfile"}
WRITERS |= {"save", "savez", "savez_compressed", "savetxt", "savemat", "to_excel", "to_hdf", "tofile"}


def careless_writes(tree):
    """Calls that write to a path directly, not into a temporary file or memory and not through `files`."""
    memory = {
        ast.unparse(node.targets[0])
        for node in ast.walk(tree)
        if isinstance(node, ast.Assign) and ast.unparse(node.value) == "io.BytesIO()"
    }
    for call in (node for node in ast.walk(tree) if isinstance(node, ast.Call)):
        if not isinstance(call.func, ast.Attribute) or call.func.attr not in WRITERS:
            continue
        owner, arguments = ast.unparse(call.func.value), {ast.unparse(argument) for argument in call.args}
        harmless = (
            "temporary" in owner or any("temporary" in argument for argument in arguments) or bool(arguments & memory)
        )
        harmless |= call.func.attr == "to_csv" and not call.args
        harmless |= call.func.attr == "write_text" and owner.endswith("files")
        harmless |= call.func.attr == "save" and owner in ("model", "self")  # ours, looked at where it writes
        if not harmless:
            yield ast.unparse(call)


MODE = re.compile(r"[rwaxbt+]+")
FLAGS = re.compile(r"\bO_(WRONLY|RDWR|CREAT|APPEND|TRUNC)\b")


def open_writes(tree):
    """Calls that open a file to write it, unless it is temporary or lies in a file that is.

    A mode may be the second word, or the first of a path's own `open`; one that is no literal might be any.
    """
    for call in ast.walk(tree):
        if not isinstance(call, ast.Call) or ast.unparse(call.func).rpartition(".")[2] not in ("open", "fdopen"):
            continue
        named = {keyword.arg: keyword.value for keyword in call.keywords}
        is_function = ast.unparse(call.func) in ("open", "io.open", "os.fdopen")
        modes = [named["mode"]] if "mode" in named else call.args[1:2] if is_function else call.args[:2]
        texts = [mode.value for mode in modes if isinstance(mode, ast.Constant) and isinstance(mode.value, str)]
        writes = any(MODE.fullmatch(text) and set(text) & set("wax+") for text in texts)
        writes |= (is_function or "mode" in named) and len(texts) < len(modes)
        writes |= ast.unparse(call.func) == "os.open" and bool(FLAGS.search(ast.unparse(call)))
        if writes and "temporary" not in ast.unparse(call):
            yield ast.unparse(call)


@pytest.mark.parametrize(
    ("code", "is_write"),
    [
        ("open(path)", False),
        ("open(path, 'rb')", False),
        ("open(path, 'wb')", True),
        ("open(path, mode='w')", True),
        ("open(path, encoding='utf-8', mode='a')", True),
        ("open(path, way)", True),
        ("open(temporary, 'wb')", False),
        ("path.open()", False),
        ("path.open(encoding='utf-8')", False),
        ("path.open('rb')", False),
        ("path.open('wb')", True),
        ("(folder / name).open(mode='x')", True),
        ("path.open(mode=way)", True),
        ("temporary.open('wb')", False),
        ("io.open(path, 'r+')", True),
        ("os.fdopen(descriptor, 'wb')", True),
        ("os.open(path, os.O_RDONLY)", False),
        ("os.open(path, os.O_RDWR | os.O_CREAT)", True),
        ("zipped.open(about, 'w')", True),
        ("zipped.open(name)", False),
    ],
)
def test_a_file_that_is_opened_to_be_written_is_seen(code, is_write):
    """Only `open` with the mode as its second word was seen."""
    assert bool(list(open_writes(ast.parse(code)))) == is_write


@pytest.mark.parametrize(
    ("code", "is_careless"),
    [
        ("figure.savefig(path)", True),
        ("drawn.savefig(temporary, dpi=160)", False),
        ("torch.save(content, path)", True),
        ("packed = io.BytesIO()\ntorch.save(content, packed)", False),
        ("np.savez(path, content)", True),
        ("table.to_csv(path)", True),
        ("table.to_csv(index=False)", False),
        ("path.write_text(text)", True),
        ("files.write_text(path, text)", False),
        ("model.save(asked.out_model)", False),
    ],
)
def test_a_direct_write_is_seen(code, is_careless):
    assert bool(list(careless_writes(ast.parse(code)))) == is_careless


OPENERS = {  # modules that open a file to write it, and why none is half a file of ours
    "pipeline.ground.errors": "the null device, in place of a terminal that is gone",
    "pipeline.settle.loop_lock": "a lock, which holds nothing",
    "pipeline.formats.matlab_child": "the standard output",
    "pipeline.pack.__main__": "a part of an archive that is temporary",
}


def test_no_stage_writes_to_its_final_path():
    """Only `files` writes, and `seal` into its temporary file; run folders are made beside their place and renamed,
    recordings are appended to."""
    opened = {}
    for module, path in MODULES.items():
        tree = ast.parse(path.read_text())
        if part(module) != "capture" and module not in OPENERS:
            assert not list(open_writes(tree)), module
        elif part(module) != "capture":
            opened[module] = list(open_writes(tree))
        if part(module) != "capture" and module != "pipeline.ground.stored.files":
            assert not list(careless_writes(tree)), module
    assert all(opened[module] for module in OPENERS), "opens nothing to write it any more: take it off the list"


def test_modules_are_short():
    for module, path in MODULES.items():
        assert len(path.read_text().splitlines()) <= 200, module


def test_every_public_function_and_class_says_what_it_is():
    for module, path in MODULES.items():
        tree = ast.parse(path.read_text())
        assert ast.get_docstring(tree) or not path.read_text(), module
        for node in tree.body:
            if isinstance(node, ast.FunctionDef | ast.ClassDef) and not node.name.startswith("_"):
                assert ast.get_docstring(node), f"{module}.{node.name}"


def test_rules_hold_no_logic_and_only_record_makes_raw():
    rules = {path.stem: path.read_text() for path in (ROOT / "pipeline" / "rules").glob("*.smk")}
    for name, text in rules.items():
        assert not re.search(r"^    (run|script):|^checkpoint|lambda", text, re.M), name
        for output in re.findall(r"output:\n((?: {8,}.*\n)+)", text):
            assert not re.search(r'["(]raw/', output) or name == "record", name
    assert "exec python -m pipeline.rig.record" in rules["record"]
    for name, text in rules.items():
        assert text.count("\nrule ") + text.startswith("rule ") == text.count("code=") == text.count("    log:\n"), name


def test_the_snakefile_is_thin():
    assert len((ROOT / "Snakefile").read_text().splitlines()) <= 80


# folders of tests that are no room of pipeline/, and what they test
NO_ROOMS = {
    "cluster": "the workflow on a SLURM, and which files its jobs open",
    "data": "recordings that tests read",
    "env": "the launcher, env/",
    "faults": "docs/faults.md, played over a pseudo-terminal",
    "firmware": "firmware/",
    "golden": "what was published, and whether tables agree with it",
    "house": "all rooms at once: walls, style, hostile input, other systems",
    "package": "what pip installs",
    "pages": "pages of docs/ and CONTRIBUTING.md, executed",
    "rigs": "docs/rigs.md, each rig recorded by another hand",
}


# who cuts a motion into strokes: the door, and what makes a motion that came through none
CUTTERS = {
    "run.samples": "every recording, at its door",
    "notebook.recording": "a recording that was made in memory, without the door",
    "diagnosis.recording.recorded_run": "offers it as `RecordedRun.cut`",
    "diagnosis.prediction.planned_motion": "a planned motion, alone or behind a recording",
    "proof.twins": "a bench without noise, which lies in no folder",
}


def test_who_cuts_a_motion_into_strokes_says_why():
    """Whatever else needs strokes is given them: a recording is cut once in a process."""
    cutters = set()
    for module, path in MODULES.items():
        tree = ast.parse(path.read_text(encoding="utf-8"))
        taken = {
            alias.name
            for node in ast.walk(tree)
            if isinstance(node, ast.ImportFrom) and (node.module or "").endswith("strokes")
            for alias in node.names
        }
        calls = {ast.unparse(node.func) for node in ast.walk(tree) if isinstance(node, ast.Call)}
        if taken & {"label", "segment"} or "RecordedRun.cut" in calls:
            cutters.add(module.removeprefix("pipeline."))
    assert cutters == set(CUTTERS)


def test_tests_mirror_the_rooms():
    tests = ROOT / "tests"
    folders = {path.relative_to(tests).parts[0] for path in tests.rglob("*.py") if path.parent != tests} | {"data"}
    assert not folders - set(ROOMS) - set(NO_ROOMS), "a folder of tests is a room's, or NO_ROOMS says what it tests"
    assert set(NO_ROOMS) <= folders - set(ROOMS), "NO_ROOMS names a folder that is a room or is not there"
    assert not set(ROOMS) - folders, "a room without tests"
    of_programs = {path.stem.removeprefix("test_") for path in tests.glob("test_*.py")}
    assert of_programs <= PROGRAMS, "a test beside the folders is a program's"


def test_no_two_test_files_have_one_name():
    """Test folders are no packages: pytest imports a file by its bare name, and helpers by theirs."""
    names = [path.stem for path in (ROOT / "tests").rglob("*.py") if path.stem != "conftest"]
    assert not {name for name in names if names.count(name) > 1}
