"""Which runs a folder of downloaded files makes, and what becomes of a file that is no recording."""

import gzip
import re

import pytest
import yaml
from downloaded import SOURCES, files, folder
from made_recording import content, recording

from pipeline.foreign.imported import read_mapping
from pipeline.foreign.origin import origin
from pipeline.ground.errors import BadInput
from pipeline.ground.names import run_name
from pipeline.real.bring import REFUSED, bring, usable
from pipeline.real.rigs import MAPPINGS, expected_of, read_rigs
from pipeline.real.runs_to_make import RealPlan, make_real_plan, plan_of
from pipeline.real.verdicts import ask


@pytest.fixture
def downloaded(tmp_path):
    """Files under the names that their sources give them."""

    def make(*names):
        for name in names:
            path = tmp_path / "downloads" / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(b"")
        return tmp_path / "downloads"

    return make


def test_the_committed_rigs_name_mappings_that_read():
    for rig in read_rigs().values():
        for kind in rig.files:
            assert read_mapping(MAPPINGS / f"{kind.mapping}.yaml")["channels"]["time_s"]
        assert all(re.match("https://(github.com|www.nonlinearbenchmark.org)/", rig.repository) for _ in rig.files)


def test_every_file_of_a_known_rig_becomes_its_runs(downloaded):
    folder = downloaded(
        "a/z_motion.csv.gz", "b/DATA_EMPS.mat", "b/DATA_EMPS_PULSES.MAT", "Tool_4_Maryland_R_5_00.TXT.gz",
        "Tool_4_Maryland_R_5_43.TXT", "Tool_9_Bowl_L.txt", "README.md", "a/.hidden.csv",
    )  # fmt: skip
    plan = make_real_plan(folder, read_rigs())
    assert plan.runs("tsa_haptic") == [f"tsa-haptic-{module}-z-motion" for module in (1, 2, 3)]
    assert plan["tsa-haptic-2-z-motion"].mapping.name == "tsa_haptic_2.yaml" and plan.groups("tsa_haptic") == {}
    tools = ["davinci-tool-4-maryland-r-5-00", "davinci-tool-4-maryland-r-5-43"]
    assert plan.groups("davinci_tool") == {"tool-4-maryland-r-5": tools}
    assert plan["davinci-tool-9-bowl-l"].group == "tool-9-bowl-l"
    assert plan["emps-data-emps"].mapping.name == "emps.yaml"
    assert plan["emps-data-emps-pulses"].mapping.name == "emps_pulses.yaml"
    assert plan.groups("emps") == {}, "their channels differ: together they would be refused"
    assert set(plan.passed_over) == {"README.md"} and "passed over 1 file" in plan.said
    assert plan.tables(None) == [f"processed/real/table/{rig}.csv" for rig in ("tsa_haptic", "davinci_tool", "emps")]


def test_the_nonlinear_benchmarks_are_no_files_of_the_haptic_device(downloaded):
    plan = make_real_plan(downloaded("tanks/dataBenchmark.csv", "dataBenchmark.csv.gz", "z_motion.csv"), read_rigs())
    assert plan.runs("tsa_haptic") == [f"tsa-haptic-{module}-z-motion" for module in (1, 2, 3)]
    assert {entry.mapping.stem for entry in plan.recordings if entry.rig == "cascaded_tanks"} == {
        "cascaded_tanks", "cascaded_tanks_validation",
    }  # fmt: skip
    assert plan.passed_over == ()


def test_the_names_of_the_surgical_tools_repository_are_known_as_they_stand(downloaded):
    names = [f"data/Tool_4_Maryland_{side}/{number}.TXT" for side in ("L_4", "R_5") for number in ("00", "43")]
    names += ["data/Tool_4_Maryland_L_Pitch_1/013.TXT", "data/Tool_4_Maryland_R_5/01.TXT.gz"]
    others = ["data/Tool_4_Maryland_L_4/SerialLog.txt", "data/Tool_4_Maryland_L_Pitch_1/ReadME.txt", "data/00.TXT"]
    plan = make_real_plan(downloaded(*names, *others), read_rigs())
    runs = [f"davinci-tool-4-maryland-{suffix}" for suffix in ("l-4-00", "l-4-43", "l-pitch-1-013")]
    runs += [f"davinci-tool-4-maryland-r-5-{suffix}" for suffix in ("00", "01", "43")]
    assert plan.runs("davinci_tool") == runs
    assert set(plan.groups("davinci_tool")) == {"tool-4-maryland-l-4", "tool-4-maryland-r-5"}
    assert set(plan.passed_over) == set(others) and all(name in plan.said for name in others)


def test_a_name_without_letters_or_without_end_becomes_a_runs_name(downloaded):
    names = ["$(touch PWNED).csv", "it's {x}.csv", "!!!.csv", "é" * 120 + ".csv"]
    names += [f"{'a' * 240}{number}.csv" for number in (1, 2)]
    names += ["0" * 40 + ".csv", "ab" * 25 + ".csv", "a" + "-a" * 19 + ".csv"]  # Snakemake plans no such repetition
    plan = make_real_plan(downloaded(*names), read_rigs())
    assert len({entry.run for entry in plan.recordings}) == 3 * len(names)
    for entry in plan.recordings:
        assert run_name(entry.run) and re.fullmatch("[a-z0-9-]+", entry.group)


def test_files_of_one_name_are_told_apart_by_their_folder_or_refused(downloaded):
    folder = downloaded("mon/DATA_EMPS.mat", "tue/DATA_EMPS.mat")
    assert make_real_plan(folder, read_rigs()).runs("emps") == ["emps-data-emps-mon", "emps-data-emps-tue"]
    with pytest.raises(BadInput, match=r"is there already as .*remove one"):
        make_real_plan(downloaded("mon/data_emps.mat"), read_rigs())


def test_a_folder_without_recordings_says_what_to_do(downloaded, tmp_path):
    with pytest.raises(BadInput, match=r"no recording of a known rig; passed over 1 file .*'notes.txt'"):
        make_real_plan(downloaded("notes.txt"), read_rigs())
    with pytest.raises(BadInput, match="--config recordings=DIR"):
        make_real_plan(tmp_path / "nowhere", read_rigs())
    assert plan_of({}) == RealPlan(())
    with pytest.raises(BadInput, match="--config recordings=DIR"):
        plan_of({}).tables(None)


@pytest.mark.parametrize(
    ("change", "says"),
    [
        ({"files": [{"pattern": "(", "mapping": "emps", "name": "x", "group": "x"}]}, "no regular expression"),
        ({"files": [{"pattern": "x", "mapping": "no_such", "name": "x", "group": "x"}]}, "no mapping 'no_such'"),
        ({"expcted": []}, "emps.expcted"),
    ],
)
def test_a_bad_list_of_rigs_is_named(tmp_path, change, says):
    whole = yaml.safe_load((MAPPINGS.parent / "config" / "real.yaml").read_text())
    path = tmp_path / "real.yaml"
    path.write_text(yaml.safe_dump({"emps": {**whole["emps"], **change}}))
    with pytest.raises(BadInput, match=says):
        read_rigs(path)


def test_the_first_expectation_that_matches_counts():
    rig = read_rigs()["tsa_haptic"]
    assert expected_of(rig, "tsa-haptic-1-cartesian-points-v1").names is None
    assert expected_of(rig, "tsa-haptic-1-z-motion").names == [["friction_hysteresis", "backlash"]]


@pytest.fixture
def imported(tmp_path):
    """Run folders imported from a logger's file, or refused."""
    mapping = tmp_path / "map.yaml"
    mapping.write_text(yaml.safe_dump(content("x", run=None)))

    def make(name, text=None):
        file = tmp_path / f"{name}.csv.gz"
        file.write_bytes(gzip.compress((recording(1).to_csv(index=False) if text is None else text).encode()))
        bring(file, mapping, tmp_path / "raw" / name)
        return tmp_path / "raw" / name

    return make


def test_a_file_that_cannot_be_imported_leaves_a_reason_in_place_of_a_verdict(imported, tmp_path):
    folder = imported("bad", "time_s,motor_turns\n1,2\n")
    assert not usable(folder) and "displacement_mm" in (folder / REFUSED).read_text()
    words = ask([folder], tmp_path / "verdict")
    assert "bad.csv.gz: not imported" in words and not (tmp_path / "verdict" / "diagnosis.json").exists()
    assert (tmp_path / "verdict" / "verdict.txt").read_text().strip() == words


def test_a_mapping_of_the_project_is_named_by_its_place_in_it_wherever_the_project_lies(tmp_path):
    (tmp_path / "log.csv").write_text("1,2\n")
    first, second = origin(tmp_path / "log.csv", MAPPINGS / "emps.yaml").splitlines()
    assert str(tmp_path) in first and "'pipeline/mappings/emps.yaml', sha256" in second


def test_a_run_that_cannot_be_decided_and_runs_too_few_to_go_together_say_why(imported, tmp_path):
    short = imported("short")
    assert usable(short)
    assert "not decided" in ask([short], tmp_path / "one") and "1 stroke" in ask([short], tmp_path / "one")
    words = ask([short, imported("bad", "")], tmp_path / "both")
    assert words == "both: not decided: of 2 recordings 1 could be imported"


def test_the_recordings_that_are_here_are_found_and_import(tmp_path):
    assert all(files(rig, "*") for rig in SOURCES)
    plan = make_real_plan(folder(), read_rigs())
    assert set(plan.rigs) == set(SOURCES)
    assert set(plan.groups("tsa_haptic")) == {"module-1", "module-2", "module-3"}
    for entry in plan.recordings:
        message = bring(entry.file, entry.mapping, tmp_path / entry.run)
        assert usable(tmp_path / entry.run), message
