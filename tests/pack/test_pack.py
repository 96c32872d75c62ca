"""A finished material goes to another folder, where Snakemake has nothing to do; what is hostile writes nothing."""

import hashlib
import json
import os
import shutil
import stat
import subprocess
import sys
import tempfile
import zipfile
from pathlib import Path

import made_recording
import programs
import pytest
import yaml

from pipeline.ground.errors import BadInput
from pipeline.pack.contents import synthetic_runs
from pipeline.pack.manifest import NAME, PROVENANCE
from pipeline.pack.provenance import note_of

SNAKEFILE = """
rule all:
    default_target: True
    input: "reports/nylon/table.csv", "reports/diagnosis/nylon-01", "reports/index.html"

rule samples:
    input: ancient("raw/nylon-01/recording.csv")
    output: "processed/nylon-01/samples.parquet"
    log: "processed/logs/samples.log"
    params: code="1"
    shell: "cp {input} {output}; echo {params.code} > {log}"

rule table:
    input: "processed/nylon-01/samples.parquet"
    output: "reports/nylon/table.csv"
    shell: "cp {input} {output}"

rule diagnose:
    input: "processed/nylon-01/samples.parquet"
    output: directory("reports/diagnosis/nylon-01")
    shell: "mkdir {output}; cp {input} {output}/verdict.txt; touch '{output}/.hidden' '{output}/my notes'"

rule index:
    input: "reports/nylon/table.csv"
    output: "reports/index.html"
    shell: "cp {input} {output}"
"""


def snakemake(folder, *words):
    command = [sys.executable, "-m", "snakemake", "--cores", "1", *words]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return done.stdout + done.stderr


def bare(folder):
    """A project of a few rules and no run."""
    (folder / "pipeline" / "config").mkdir(parents=True)
    (folder / "pipeline" / "config" / "default.yaml").write_text("synthetic: {}\n")
    (folder / "Snakefile").write_text(SNAKEFILE)
    return folder


@pytest.fixture(scope="module")
def finished(tmp_path_factory):
    """A project whose only material is made. Tests leave it as it is."""
    folder = bare(tmp_path_factory.mktemp("finished"))
    run = folder / "raw" / "nylon-01"
    run.mkdir(parents=True)
    described = made_recording.content("nylon-01")
    described["string"]["material"] = "nylon"
    (run / "run.yaml").write_text(yaml.safe_dump(described))
    (run / "notes.txt").write_text("a person's own")
    made_recording.recording(2).to_csv(run / "recording.csv", index=False)
    snakemake(folder)
    return folder


@pytest.fixture(scope="module")
def archive(finished, tmp_path_factory):
    """The archive of that project, with all that is made of all materials."""
    path = tmp_path_factory.mktemp("archive") / "all.zip"
    done = programs.run("pipeline.pack", "--all", "--out", path, cwd=finished)
    assert done.returncode == 0 and "nylon, 1 run," in done.stdout, done.stderr
    return path


def unpacked(path, folder):
    return programs.run("pipeline.pack.unpack", path, cwd=folder)


def state(folder):
    """Every file and link below a folder, with its content and its time."""
    entries = {}
    for path in sorted(folder.rglob("*")):
        content = os.readlink(path) if path.is_symlink() else path.read_bytes() if path.is_file() else b""
        entries[str(path.relative_to(folder))] = content, path.lstat().st_mtime_ns if path.is_file() else 0
    return entries


@pytest.mark.long
def test_another_folder_has_nothing_to_do_and_what_changes_there_is_made_again(finished, archive, tmp_path):
    lab = bare(tmp_path / "lab")
    done = unpacked(archive, lab)
    assert done.returncode == 0 and "nylon: " in done.stdout and "packed by other code" not in done.stdout, done.stderr
    assert "Nothing to be done" in snakemake(lab, "--dry-run")
    for name in ("processed", "reports", "raw"):
        for path in (finished / name).rglob("*"):
            counterpart = lab / path.relative_to(finished)
            own = path.name in ("notes.txt", ".hidden", "my notes")
            assert own or path.is_dir() or counterpart.read_bytes() == path.read_bytes(), path
    assert not (lab / "raw/nylon-01/notes.txt").exists() and not (lab / "reports/diagnosis/nylon-01/.hidden").exists()
    assert stat.S_IMODE((lab / "raw/nylon-01/recording.csv").stat().st_mode) == 0o444
    changed = SNAKEFILE.replace('code="1"', 'code="2"')
    (lab / "Snakefile").write_text(changed)
    assert "samples" in snakemake(lab, "--dry-run")  # its provenance came with it


@pytest.mark.long
def test_a_material_alone_leaves_what_is_made_of_all_and_the_same_gives_the_same_bytes(finished, archive, tmp_path):
    for name in ("a.zip", "b.zip"):
        assert programs.run("pipeline.pack", "nylon", "--out", tmp_path / name, cwd=finished).returncode == 0
    assert (tmp_path / "a.zip").read_bytes() == (tmp_path / "b.zip").read_bytes()
    names = zipfile.ZipFile(tmp_path / "a.zip").namelist()
    assert "reports/index.html" not in names and "reports/index.html" in zipfile.ZipFile(archive).namelist()
    assert "processed/logs/samples.log" in names and "reports/diagnosis/nylon-01/.snakemake_timestamp" in names
    lab = bare(tmp_path / "lab")
    assert unpacked(tmp_path / "a.zip", lab).returncode == 0
    dry_run = snakemake(lab, "--dry-run")
    assert "rule index" in dry_run and "rule samples" not in dry_run and "rule table" not in dry_run


@pytest.mark.long
def test_unpacking_again_brings_nothing_and_goes_on_where_it_was_killed(archive, tmp_path):
    lab = bare(tmp_path / "lab")
    assert unpacked(archive, lab).returncode == 0
    before = state(lab)
    done = unpacked(archive, lab)
    assert done.returncode == 0 and "0 files unpacked" in done.stdout
    assert state(lab) == before
    (lab / "reports" / "nylon" / "table.csv").unlink()
    note_of(lab, "reports/nylon/table.csv").write_text("{}")
    assert "2 files unpacked" in unpacked(archive, lab).stdout and state(lab) == before


@pytest.fixture
def other_disk():
    """A folder on another disk than the tests': that of the memory."""
    memory = Path("/dev/shm")
    if not memory.is_dir() or memory.stat().st_dev == Path.cwd().stat().st_dev:
        pytest.skip("there is no second disk")
    with tempfile.TemporaryDirectory(dir=memory) as name:
        yield Path(name)


@pytest.mark.long
def test_raw_and_processed_may_lie_on_another_disk(archive, other_disk, tmp_path):
    lab, plain_lab = bare(tmp_path / "lab"), bare(tmp_path / "here")
    assert unpacked(archive, plain_lab).returncode == 0
    for name in ("raw", "processed"):
        (other_disk / name).mkdir()
        (lab / name).symlink_to(other_disk / name)
    done = unpacked(archive, lab)
    assert done.returncode == 0, done.stderr
    for name in ("raw", "processed", "reports"):
        assert state((lab / name).resolve()) == state(plain_lab / name)
    assert stat.S_IMODE((lab / "raw/nylon-01/recording.csv").stat().st_mode) == 0o444
    assert "Nothing to be done" in snakemake(lab, "--dry-run")


@pytest.mark.long
def test_recordings_may_stay_away_and_must_then_be_there(finished, tmp_path):
    path, lab = tmp_path / "small.zip", bare(tmp_path / "lab")
    done = programs.run("pipeline.pack", "nylon", "--without-recordings", "--out", path, cwd=finished)
    assert done.returncode == 0 and not [name for name in zipfile.ZipFile(path).namelist() if name.startswith("raw/")]
    before = state(lab)
    done = unpacked(path, lab)
    assert done.returncode == 2 and "raw/nylon-01/recording.csv" in done.stderr and state(lab) == before
    shutil.copytree(finished / "raw", lab / "raw")
    recording = state(lab / "raw")
    assert unpacked(path, lab).returncode == 0 and state(lab / "raw") == recording
    assert "reports/nylon/table.csv" not in snakemake(lab, "--dry-run", "reports/nylon/table.csv").partition("rule ")[2]


@pytest.mark.long
def test_what_is_not_finished_or_not_there_is_not_packed(finished, tmp_path):
    folder = tmp_path / "project"
    shutil.copytree(finished, folder, symlinks=True)
    out = tmp_path / "x.zip"
    done = programs.run("pipeline.pack", "silk", "--out", out, cwd=folder)
    assert done.returncode == 2 and "no run in raw/ is of this material. Mend: give some of nylon" in done.stderr
    assert programs.run("pipeline.pack", "--out", out, cwd=folder).returncode == 2
    (folder / "reports" / "nylon" / "table.csv").unlink()
    done = programs.run("pipeline.pack", "nylon", "--out", out, cwd=folder)
    assert done.returncode == 2 and "reports/nylon/table.csv" in done.stderr and "run snakemake" in done.stderr
    assert not out.exists()


@pytest.mark.parametrize("name", ["raw/nylon-01/recording.csv", "reports/nylon/table.csv"])
def test_nothing_that_is_there_is_replaced(archive, tmp_path, name):
    lab = bare(tmp_path / "lab")
    (lab / name).parent.mkdir(parents=True)
    (lab / name).write_text("mine")
    before = state(lab)
    done = unpacked(archive, lab)
    assert done.returncode == 2 and name.split("/")[1] in done.stderr and "Mend: " in done.stderr
    assert state(lab) == before


def test_a_folder_that_is_a_file_or_a_link_out_is_in_the_way(archive, tmp_path):
    lab, outside = bare(tmp_path / "lab"), tmp_path / "outside"
    (lab / "processed").write_text("mine")
    before = state(lab)
    assert "is in the way of" in unpacked(archive, lab).stderr and state(lab) == before
    (lab / "processed").unlink()
    (lab / "reports" / "nylon").mkdir(parents=True)
    (lab / "reports" / "nylon" / "table.csv").symlink_to(outside)
    before = state(lab)
    assert "is in the way of" in unpacked(archive, lab).stderr and state(lab) == before and not outside.exists()


def rewritten(archive, target, manifest=None, files=None, link=""):
    """An archive with another manifest, with other or more files, or with a file that is a link."""
    with zipfile.ZipFile(archive) as old, zipfile.ZipFile(target, "w") as new:
        content = json.loads(old.read(NAME))
        every = {name: old.read(name) for name in old.namelist()[1:]}
        if manifest:
            manifest(content)
        every |= files or {}
        new.writestr(NAME, json.dumps(content))
        for name, text in every.items():
            about = zipfile.ZipInfo(name)
            if name == link:
                about.external_attr = (stat.S_IFLNK | 0o777) << 16
            new.writestr(about, text)
    return target


def said_of(text):
    return {"bytes": len(text), "sha256": hashlib.sha256(text).hexdigest(), "time_ns": 1, "brought": True}


OUTSIDE = [
    "../evil", "reports/../../evil", "/tmp/evil", "reports//evil", "reports/./evil", "C:/evil", "reports\\evil", "evil",
    "Snakefile",
    "pipeline/evil.py", "env/evil", ".snakemake/evil", "raw/evil", "raw/nylon-01/a/b", "raw/NYLON/run.yaml",
    "reports/.evil", "reports/a b", "reports/a\nb", "reports/" + "a" * 1000, "reports/$(touch PWNED)", "",
]  # fmt: skip


@pytest.mark.parametrize("name", OUTSIDE)
def test_a_name_that_leads_out_of_its_place_is_refused(archive, tmp_path, name):
    lab = bare(tmp_path / "lab")
    added = {name: b"evil"} if name else {}
    path = rewritten(
        archive, tmp_path / "x.zip", lambda manifest: manifest["files"].update({name: said_of(b"evil")}), added
    )
    before, around = state(lab), state(tmp_path)
    done = unpacked(path, lab)
    assert done.returncode == 2 and "error: " in done.stderr and len(done.stderr.splitlines()) == 1, done.stderr
    assert state(lab) == before and state(tmp_path) == around and not Path("/tmp/evil").exists()


TABLE = "reports/nylon/table.csv"
FORGED = {
    "no manifest of ours": lambda manifest: manifest.update(format=2),
    "a manifest of other things": lambda manifest: manifest.update(evil=1),
    "a missing list": lambda manifest: manifest.pop("files"),
    "a file more than there is": lambda manifest: manifest["files"].update({"reports/more": said_of(b"")}),
    "a file that is not named": lambda manifest: manifest["files"].pop(TABLE),
    "a wrong digest": lambda manifest: manifest["files"][TABLE].update(sha256="0" * 64),
    "a digest that is none": lambda manifest: manifest["files"][TABLE].update(sha256="evil"),
    "too few bytes": lambda manifest: manifest["files"][TABLE].update(bytes=3),
    "too many bytes": lambda manifest: manifest["files"][TABLE].update(bytes=10**6),
    "more than the disk holds": lambda manifest: manifest["files"][TABLE].update(bytes=1 << 60),
    "a time that is none": lambda manifest: manifest["files"][TABLE].update(time_ns=-1),
    "a time without end": lambda manifest: manifest["files"][TABLE].update(time_ns=1 << 80),
    "a number that is a text": lambda manifest: manifest["files"][TABLE].update(bytes="3"),
    "runs that are numbers": lambda manifest: manifest["materials"].update(nylon=[1]),
    "a configuration of two lines": lambda manifest: manifest.update(configuration=["a\nb"]),
}


@pytest.mark.parametrize("what", FORGED)
def test_a_forged_manifest_is_refused(archive, tmp_path, what):
    lab, path = bare(tmp_path / "lab"), rewritten(archive, tmp_path / "x.zip", FORGED[what])
    before = state(lab)
    done = unpacked(path, lab)
    assert done.returncode == 2 and "error: " in done.stderr and "Mend: " in done.stderr, done.stderr
    assert state(lab) == before


def test_a_link_a_file_below_a_file_and_a_file_that_comes_twice_are_refused(archive, tmp_path):
    lab = bare(tmp_path / "lab")
    before = state(lab)
    link = rewritten(archive, tmp_path / "link.zip", files={TABLE: b"/etc/passwd"}, link=TABLE)
    assert "is a link" in unpacked(link, lab).stderr
    name = f"{TABLE}/x"
    below = rewritten(
        archive, tmp_path / "below.zip", lambda manifest: manifest["files"].update({name: said_of(b"x")}), {name: b"x"}
    )
    assert "lies below a file" in unpacked(below, lab).stderr
    twice = shutil.copy(archive, tmp_path / "twice.zip")
    with zipfile.ZipFile(twice, "a") as more, pytest.warns(UserWarning, match="Duplicate"):
        more.writestr(TABLE, "evil")
    assert "not in both" in unpacked(twice, lab).stderr
    assert state(lab) == before


def test_an_archive_that_is_cut_off_or_hurt_anywhere_writes_nothing_or_what_was_packed(archive, tmp_path):
    lab, whole = bare(tmp_path / "lab"), archive.read_bytes()
    before, path = state(lab), tmp_path / "hurt.zip"
    for at in range(0, len(whole), len(whole) // 25):
        path.write_bytes(whole[:at])
        done = unpacked(path, lab)
        assert done.returncode == 2 and state(lab) == before, (at, done.stderr)
        path.write_bytes(whole[:at] + bytes([whole[at] ^ 255]) + whole[at + 1 :])
        done = unpacked(path, tmp_path / "lab")
        if done.returncode == 0:  # a byte that carries nothing, such as a date
            assert (lab / TABLE).is_file()
            shutil.rmtree(lab)
            bare(lab)
            before = state(lab)
        assert state(lab) == before, at


def test_a_configuration_that_is_a_pipe_is_refused_at_once(tmp_path, monkeypatch):
    monkeypatch.chdir(programs.ROOT)
    os.mkfifo(tmp_path / "pipe")
    with pytest.raises(BadInput, match="is a pipe, not a file"):
        synthetic_runs([str(tmp_path / "pipe")])


def test_the_notes_of_a_long_name_are_where_snakemake_looks_for_them(tmp_path):
    name = "reports/" + "/".join(["a" * 100] * 5)
    (tmp_path / "Snakefile").write_text(f'rule one:\n    output: "{name}"\n    shell: "touch {{output}}"\n')
    snakemake(tmp_path)
    assert json.loads(note_of(tmp_path, name).read_text())["rule"] == "one"
    assert PROVENANCE not in os.listdir(tmp_path)
