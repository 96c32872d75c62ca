"""The workflow on a real SLURM of two nodes: stopped, resumed, robbed of a node, and once without shared files."""

import hashlib
import re
import signal
import subprocess
from contextlib import contextmanager

import pandas as pd
import pytest
from local_slurm import WITHIN_S, cluster, why_not
from small_project import ROOT, command

pytestmark = [pytest.mark.long, pytest.mark.skipif(bool(why_not()), reason=why_not() or "it can be")]
AT_WORK = re.compile(r"^(?:Job \d+: |rule \w+:)", re.MULTILINE)  # in SLURM's log of a submission: its rule has begun
OF_BESIDE = tuple(
    f"{kind}/{name}/" for kind in ("processed", "reports", "raw") for name in ("proof", "campaign", "real")
)
INDEX = "reports/index.html"  # it links whatever reports there are, which here are those of the jobs beside as well
OFTEN = ("--slurm-no-account", "--slurm-init-seconds-before-status-checks", "3")


BESIDE = ("proof", "campaign", "real")  # the three jobs beside the main one


def rules(*names):
    """Rules of files of rules."""
    texts = ((ROOT / "pipeline" / "rules" / f"{name}.smk").read_text() for name in names)
    return {rule for text in texts for rule in re.findall(r"^rule (\w+):", text, re.MULTILINE)}


RULES = rules(*BESIDE)
LOCAL = {"left_out"}  # it asks in a second, on the machine that submits
OF_MAIN = rules(*(path.stem for path in (ROOT / "pipeline" / "rules").glob("*.smk") if path.stem not in BESIDE))
SPENT = re.compile(rb"""("seconds": )(?:[0-9.]+|\{[^}]*\})|<tr>(?:(?!</tr>).)*seconds.*?</tr>""", re.DOTALL)


def untimed(path):
    """Content of a file of results without the CPU seconds that the proof tells of itself."""
    if path.name in ("cases.csv", "beside.csv"):
        return pd.read_csv(path).drop(columns="seconds").to_csv(index=False).encode()
    content = path.read_bytes()
    if path.suffix in (".json", ".html"):
        return SPENT.sub(rb"\1", content)
    if path.name in ("scores.csv", "proof.md"):
        return b"".join(line for line in content.splitlines(keepends=True) if b"seconds" not in line)
    return content


def results(folder):
    """Digest of every file of results, but for logs, and for capture.json, which says when it was."""
    return {
        str(path.relative_to(folder)): hashlib.sha256(untimed(path)).hexdigest()
        for kind in ("raw", "processed", "reports")
        for path in sorted((folder / kind).rglob("*"))
        if path.is_file() and "logs" not in path.parts and path.name not in (".snakemake_timestamp", "capture.json")
    }


@contextmanager
def started(folder, *words):
    """Snakemake at work, which does not outlive what is asked of it."""
    with open(folder / "said.txt", "ab") as log_file:
        heard = ["env", "--default-signal=INT", *command(*words, *OFTEN)]  # in the background a shell ignores Ctrl-C
        process = subprocess.Popen(heard, cwd=folder, stdout=log_file, stderr=subprocess.STDOUT)
    try:
        yield process
    finally:
        process.kill()
        process.wait()


def logs_of(folder):
    """SLURM's log of each submission, by its job."""
    return {path.stem: path.read_text() for path in (folder / "processed" / "logs" / "slurm").rglob("*.log")}


def at_work(folder, slurm, node):
    """Whether a rule of a job on a node has begun, so that files of it may be half written."""
    jobs = [job for job, where in slurm.running() if where == node]
    return any(AT_WORK.search(logs_of(folder).get(job, "")) for job in jobs)


def ends(process, folder):
    assert process.wait(1800) == 0, (folder / "said.txt").read_text()


def test_stopped_resumed_and_robbed_of_a_node_it_makes_what_one_machine_makes(local, copied, tmp_path):
    folder = copied()
    with cluster(tmp_path / "slurm") as slurm:
        arguments = ("--profile", "env/slurm", "all")
        with started(folder, *arguments) as first:
            slurm.wait(slurm.running, "job that runs")
            first.send_signal(signal.SIGINT)
            assert first.wait(WITHIN_S) != 0
            slurm.wait(lambda: not slurm.said("squeue", "-h").strip(), "end of the jobs")
        with started(folder, *arguments) as again:
            slurm.wait(lambda: at_work(folder, slurm, "n2") or again.poll() is not None, "job at work on n2")
            lost = [job for job, node in slurm.running() if node == "n2"]
            slurm.lose("n2")
            ends(again, folder)
    digests, meant = results(folder), results(local[0])
    assert digests.pop(INDEX) and meant.pop(INDEX)
    assert digests == {name: digest for name, digest in meant.items() if not name.startswith(OF_BESIDE)}
    logs = logs_of(folder)
    assert {rule for text in logs.values() for rule in re.findall(r"--allowed-rules (\w+) -", text)} == OF_MAIN - LOCAL
    nodes = {job: set(re.findall(r"^node: (\w+)$", text, re.MULTILINE)) for job, text in logs.items()}
    assert lost and all(nodes[job] == {"n1"} for job in lost), "what the lost node had ran on the other"
    assert set().union(*nodes.values()) <= {"n1", "n2"}
    main_log = (folder / "said.txt").read_text()
    assert "TABLE I: FORWARD" in main_log and "processed/logs/slurm/" in main_log


def test_proof_campaign_and_public_recordings_run_on_nodes(local, copied, tmp_path):
    folder = copied()
    with cluster(tmp_path / "slurm") as slurm:
        with started(folder, "--profile", "env/slurm", "proof", "campaign", "real") as process:
            ends(process, folder)
        assert not slurm.said("squeue", "-h").strip()
    digests = results(folder)
    assert digests == {name: digest for name, digest in results(local[0]).items() if name in digests}
    logs = logs_of(folder)
    assert {re.search(r"^node: (\w+)$", text, re.MULTILINE)[1] for text in logs.values()} == {"n1", "n2"}
    assert {rule for text in logs.values() for rule in re.findall(r"--allowed-rules (\w+) -", text)} == {*RULES}


def test_nodes_that_share_no_files_make_the_same_tables(local, copied, tmp_path):
    folder, storage, copy = copied(), tmp_path / "storage", tmp_path / "copy"
    storage.mkdir()
    hidden = [*(folder / name for name in ("raw", "processed", "reports", ".snakemake")), copy]
    with cluster(tmp_path / "slurm", hidden) as slurm:
        places = ("--local-storage-prefix", str(copy), "--remote-job-local-storage-prefix", str(copy))
        places += ("--slurm-logdir", str(tmp_path / "logs"))
        words = ("--profile", "env/slurm-unshared", "--default-storage-prefix", str(storage), *places, "tables")
        with started(folder, *words) as process:
            ends(process, folder)
        assert not slurm.said("squeue", "-h").strip()
    digests = results(storage)
    assert digests and digests == {name: digest for name, digest in results(local[0]).items() if name in digests}
    assert {f"reports/synthetic/table_{n}.csv" for n in (1, 2)} <= set(digests)
    assert not list((folder / "processed").rglob("*.parquet")), "nothing of it came here"
