"""Where jerks were seen they stand in each explanation: none is told twice, with them and without."""

import json

import pytest

from pipeline.diagnosis.facts.explanations import explanations
from pipeline.diagnosis.proposal.foretold import foretold, rivals
from pipeline.diagnosis.recording.recorded_run import RecordedRun
from pipeline.diagnosis.study.engine import make_problem, study
from pipeline.rig.authors import authors
from pipeline.rig.authors.interface import Asked
from pipeline.run.description import parse_run
from pipeline.run.table.recorded_table import to_samples


@pytest.mark.long
def test_each_explanation_holds_the_jerks_and_the_best_is_as_likely_as_it_is_with_them_and_without(tmp_path):
    authored_case = authors()["lattice"].make(Asked(900017, ("stick_slip",), (2.62,), "poor", ()))
    path = tmp_path / "jerky" / "run.yaml"
    run = parse_run({**authored_case.content, "run": "jerky"}, path)
    outcome = study(make_problem([RecordedRun.cut(run, to_samples(run, authored_case.table, path, path))]))
    assert outcome.random and outcome.verdict == "ambiguous"
    entries = {tuple(entry["ids"]): entry for entry in explanations(outcome, "mm", 1.0)}
    assert all("stick_slip" in ids for ids in entries if ids)
    best = outcome.sets[0].ids
    assert entries[best]["probability"] == max(entry["probability"] or 0.0 for entry in entries.values())
    alike = [share for ids, share in outcome.judged.likely.items() if {*ids, "stick_slip"} == {*best, "stick_slip"}]
    assert alike and entries[best]["probability"] == pytest.approx(sum(alike), abs=1e-3)
    assert entries[best]["standing"] == "named"
    assert len({explanation.ids for explanation in rivals(outcome)}) == len(rivals(outcome)) > 1
    assert all(json.dumps(entry) for entry in foretold(outcome, run, fixed_load=False))
