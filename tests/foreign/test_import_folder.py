"""A folder of recordings goes through one mapping, each a run named after its file; what is passed over is listed."""

import gzip
import shutil
from pathlib import Path

import programs
import pytest
import yaml
from made_recording import content, recording

from pipeline.run.samples import read_samples


@pytest.fixture
def folder(tmp_path):
    """Two recordings as a public repository lays them out, one compressed, beside a licence and a page of text."""
    own = tmp_path / "data" / "Tool_4_Maryland_R_5"
    own.mkdir(parents=True)
    table = recording().to_csv(index=False).encode()
    (own / "00.TXT").write_bytes(table)
    (own / "03.TXT.gz").write_bytes(gzip.compress(table))
    (own / "LICENSE").write_text("Open Database License")
    (tmp_path / "data" / "README.md").write_text("# what it is")
    (tmp_path / "data" / ".hidden.csv").write_text("not asked")
    (tmp_path / "map.yaml").write_text(yaml.safe_dump(content("x", run=None)))
    return tmp_path / "data"


def imported(folder: Path, *words: object) -> programs.Done:
    """What the program says of a folder."""
    mapping, raw = folder.parent / "map.yaml", folder.parent / "raw"
    return programs.run("pipeline.import_run", folder, "--map", mapping, "--run", "tool", "--out", raw, *words)


def made(folder: Path) -> list[str]:
    """Names of the runs that are there."""
    raw = folder.parent / "raw"
    return sorted(path.name for path in raw.iterdir()) if raw.exists() else []


def test_each_recording_becomes_a_run_named_after_its_file_and_folder(folder):
    done = imported(folder)
    assert done.returncode == 0, done.stderr
    runs = ["tool-tool-4-maryland-r-5-00", "tool-tool-4-maryland-r-5-03"]
    assert made(folder) == runs
    for run in runs:
        _, samples = read_samples(folder.parent / "raw" / run)
        assert samples["motor_turns"].to_numpy() == pytest.approx(recording()["motor_turns"].to_numpy())
    assert done.stderr.count("note: this counts as another string than tool-tool-4-maryland-r-5-00") == 1
    assert "passed over 2 files: 'README.md', 'Tool_4_Maryland_R_5/LICENSE'\n" in done.stdout
    assert "2 of 2 files imported\n" in done.stdout and "tool-* --out reports/mine" in done.stdout


def test_the_folder_itself_names_shorter_runs(folder):
    shutil.copy(folder.parent / "map.yaml", folder / "map.yaml")
    own = folder / "Tool_4_Maryland_R_5"
    assert imported(own, "--out", folder.parent / "raw", "--map", folder / "map.yaml").returncode == 0
    assert made(folder) == ["tool-00", "tool-03"]


def test_a_file_that_is_none_costs_itself_alone_and_is_named(folder):
    (folder / "notes.txt").write_text("what was done that day\n")
    done = imported(folder)
    assert done.returncode == 2 and len(made(folder)) == 2
    assert "notes.txt" in done.stderr and "Mend: " in done.stderr
    assert "2 of 3 files imported, the others refused (above)\n" in done.stdout
    again = imported(folder)
    assert again.returncode == 2 and again.stderr.count("is there already") == 2 and "0 of 3 files" in again.stdout


def test_a_pattern_says_which_files_are_recordings(folder):
    (folder / "notes.txt").write_text("what was done that day\n")
    done = imported(folder, "--files", "*/0*.TXT*")
    assert done.returncode == 0 and len(made(folder)) == 2, done.stderr
    assert "passed over 3 files: 'README.md', 'Tool_4_Maryland_R_5/LICENSE', 'notes.txt'\n" in done.stdout
    nothing = imported(folder, "--files", "*.dat")
    assert nothing.returncode == 2 and "holds no file that matches *.dat; passed over 5 files: " in nothing.stderr
    single = imported(folder / "notes.txt", "--files", "*.txt", "--map", folder.parent / "map.yaml")
    assert single.returncode == 2 and "--files goes with a folder" in single.stderr


def test_a_folder_without_recordings_is_refused_with_what_is_in_it_and_the_mend(folder, tmp_path):
    for file in folder.rglob("0*"):
        file.unlink()
    done = imported(folder)
    assert done.returncode == 2 and made(folder) == []
    assert "holds no file whose name ends in .asc, .csv, " in done.stderr
    assert "passed over 2 files: 'README.md', 'Tool_4_Maryland_R_5/LICENSE'" in done.stderr
    assert "Mend: give a folder of recordings, or say which by --files '*.EXT'." in done.stderr


def test_a_wrong_mapping_is_said_once_and_nothing_is_made(folder):
    mapping = folder.parent / "map.yaml"
    mapping.write_text(mapping.read_text().replace("radius_mm", "radius_cm"))
    done = imported(folder)
    assert done.returncode == 2 and done.stderr.count("error: ") == 1 and "map.yaml: " in done.stderr
    assert made(folder) == []


def test_two_files_that_would_be_one_run_are_refused_before_any_is_made(folder):
    shutil.copy(folder / "Tool_4_Maryland_R_5" / "00.TXT", folder / "Tool_4_Maryland_R_5" / "00.csv")
    done = imported(folder)
    assert done.returncode == 2 and made(folder) == []
    assert "would be the run tool-tool-4-maryland-r-5-00, as " in done.stderr and "rename one of the two" in done.stderr
