"""`snakemake proof`: the answers stay sealed until the last verdict is written, and its small version works."""

import re
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

import pandas as pd
import pytest

ROOT = Path(__file__).parents[2]
SMALL = ("--configfile", str(ROOT / "pipeline" / "config" / "ci.yaml"))


def snakemake(place, *words):
    command = [sys.executable, "-m", "snakemake", "--snakefile", str(ROOT / "Snakefile"), "--directory", str(place)]
    done = subprocess.run([*command, "--cores", "1", *words, *SMALL], capture_output=True, text=True, timeout=900)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


@dataclass(frozen=True)
class Rule:
    """A rule as the graph of files shows it; batches are all called {batch}."""

    inputs: frozenset[str]
    outputs: frozenset[str]


@pytest.fixture(scope="module")
def rules(tmp_path_factory):
    graph = snakemake(tmp_path_factory.mktemp("graph"), "proof", "--filegraph")
    rules_by_name = {}
    for node in re.findall(r"^\d+ \[(.*?)>\]", graph, re.M | re.S):
        plain = re.sub(r"<[^>]*>", "\n", node)
        text = re.sub(r"\{batch,[^}]*\}|(?:batch|by_[a-z_]+)-\d+|without-[a-z_]+", "{batch}", plain)
        inputs, outputs = [*text.split("output &rarr;"), ""][:2]
        paths = [frozenset(re.findall(r"(?:processed|reports)/\S+", side)) for side in (inputs, outputs)]
        rules_by_name[re.search(r"\b(?!shape|none|margin|label)([a-z_]+)\n", text)[1]] = Rule(*paths)
    return rules_by_name


def ancestors(rules, files):
    """Rules that some files are made by, at any distance."""
    reached, waiting = set(), {*files}
    while waiting:
        name = waiting.pop()
        for rule, has in rules.items():
            if name in has.outputs and rule not in reached:
                reached.add(rule)
                waiting |= has.inputs
    return reached


ASKING = ("verdicts", "settle")


@pytest.mark.long
def test_nothing_before_a_verdict_opens_an_answer(rules):
    before = ancestors(rules, {name for rule in ASKING for name in rules[rule].outputs})
    assert before == {"conceal_batch", "verdicts", "carry_on", "settle"}
    for rule in before:
        assert not [name for name in rules[rule].inputs if "sealed" in name], rule
        assert rule == "conceal_batch" or not [name for name in rules[rule].outputs if "sealed" in name], rule


def test_answers_are_opened_by_the_score_alone_and_after_all_verdicts(rules):
    sealed = "processed/proof/sealed/{batch}.json"
    assert sealed in rules["conceal_batch"].outputs
    assert [rule for rule, has in rules.items() if sealed in has.inputs] == ["score"]
    assert {name for rule in ASKING for name in rules[rule].outputs} <= rules["score"].inputs


def test_a_diagnosis_is_told_the_recordings_and_nothing_else(tmp_path):
    text = snakemake(tmp_path, "--dry-run", "--printshellcmds", "proof")
    commands = re.findall(r"exec python -m pipeline\.proof\.(?:verdicts|settle) .*", text)
    assert len(commands) == 8
    for command in commands:
        assert not re.search(r"sealed|--cases|stratum|kappa|answers", command)


@pytest.mark.long
def test_the_small_proof(tmp_path):
    """Nine cases on one core, ties and baselines included: two to three minutes."""
    snakemake(tmp_path, "proof")
    reports = tmp_path / "reports" / "proof"
    cases = pd.read_csv(reports / "cases.csv", keep_default_na=False)
    assert len(cases) == 9 and (cases["skipped"] != "").sum() == 1  # elasticity shows nothing under one load
    made_cases = cases[cases["skipped"] == ""]
    assert set(made_cases["outcome"]) - {"refused", "false alarm", "wrong"} and (made_cases["outcome"] != "").all()
    clear = made_cases[(made_cases["stratum"] == "single") | made_cases["stratum"].isin(["none", "parameters"])]
    assert clear["right"].astype(str).eq("True").mean() >= 0.8, clear[["run", "effects", "verdict", "named"]]
    hands = pd.read_csv(reports / "authors.csv")
    assert set(hands["author"]) == {"all", "rig", "lattice"} and pd.read_csv(reports / "laws.csv")["of"].sum() == 3
    scores = pd.read_csv(reports / "scores.csv")
    assert ((scores["low"] <= scores["value"]) & (scores["value"] <= scores["high"])).all()
    assert "false alarm" in set(scores["metric"])
    for name in ("confusion.png", "confusion.pdf", "dose_response.png", "dose_response.pdf", "sizes.png"):
        assert (reports / name).stat().st_size > 5_000 and b"CreationDate" not in (reports / name).read_bytes()
    beside = pd.read_csv(reports / "beside.csv", keep_default_na=False)
    assert set(beside["method"]) >= {"diagnosis", "residual_sindy", "gaussian_process"} and len(set(beside["run"])) == 2
    assert set(beside["effects"]) == {"creep", "backlash"}
    page = (reports / "proof.md").read_text()
    assert "leaves no 3 noise floors" in page and "| creep | 8.9 %" in page and "Goals and what was reached" in page
    recordings = tmp_path / "processed" / "proof" / "concealed"
    words = ("backlash", "creep", "stratum", "kappa", "floor_sway")
    for path in recordings.rglob("run.yaml"):
        assert not [word for word in words if word in path.read_text()]
