"""The page of a run whose effects are adopted already."""

import pytest
from made_content import SYSTEMS, adopted, content, full, page, told

from pipeline.diagnosis.words.pages import adoption
from pipeline.diagnosis.words.pages.spoken import spoken


def test_where_effects_are_adopted_no_verdict_says_that_no_physics_is_missing():
    for verdict in ("consistent", "parameters"):
        text = adopted(verdict)
        assert (
            "no physics is missing" not in text.partition("What the words mean")[0]
            and "creep was adopted and still holds: with it the sim" in text
        )
        assert "run.yaml has adopted creep: this verdict is on the simulator with it." in text
        assert "the dimensions alone explain" not in text and "None is proposed: beside what" in text
        assert "if it is this one, the error on its last strokes below is no test" in " ".join(text.split())
        assert "can also cover another one that is really there" in text
        assert (
            "Adopted effects bend dimensions as well (creep). Do not copy calibrated values into run.yaml: measure"
            in text
        )
    bare = content(verdict="parameters", mechanisms=[], alternatives=[], next_run=None)
    details = " ".join(told(bare).split())
    assert "no physics is missing" in details and "adopted" not in details.lower()


def test_what_tied_with_what_was_adopted_is_said_once_and_at_once():
    adopted_verdict = {"effects": ["creep"], "verdict": "ambiguous", "tied": [["thermal"], ["wear", "slack"], ["jam"]]}
    text = " ".join(adopted(adopted=[adopted_verdict]).split())
    told_ = "this may be right, for it was likely as well: thermal or wear + slack, or one of 1 more (`adopted` in run"
    assert (
        f"Instead of what was adopted (creep) {told_}.yaml)." in text and "Whether another explanation fits" not in text
    )
    text = " ".join(adopted(adopted=[adopted_verdict | {"tied": [], "verdict": "explained"}]).split())
    assert "No other explanation was as likely as what was adopted (creep)." in text
    assert "Whether another explanation fits as well stands in the verdict that was adopted" in " ".join(
        adopted().split()
    )


def second(**changes):
    """The words on a run whose own verdict was adopted, and named creep and what tied with it."""
    adopted_verdict = {"effects": ["creep"], "verdict": "ambiguous", "tied": [["thermal"]], "runs": ["nylon-3"]}
    return " ".join(adopted(adopted=[adopted_verdict | changes]).split())


def test_strokes_that_adopted_effects_have_seen_are_nowhere_called_unseen():
    for runs, expected in ((["nylon-3"], "seen before"), (None, "perhaps seen before")):
        text = second(runs=runs)
        assert f" last 30 % of strokes ({expected}) nominal – 1.9 mm" in text
        assert "unseen" not in text and "no fit has seen" not in text
    assert "It was fitted to this very recording, all its strokes included" in second()
    again = content(adopted=[{"effects": ["creep"], "verdict": "explained", "tied": [], "runs": ["nylon-3"]}])
    again["simulation"] = [{"id": "creep", "parameters": {}}]
    assert "(seen before)" in told(again), "creep, which is adopted, is named once more"
    elsewhere = second(runs=["nylon-2"])
    assert "last 30 % of strokes (seen by no fit)" in elsewhere and "very recording" not in elsewhere
    error_fields = {
        "fit__heldout__calibrated_mm": 3.0,
        "fit__heldout__explained_mm": 3.0,
        "evidence__calibrated_mm": 0.031,
    }
    adopted_verdict = {"effects": ["creep"], "verdict": "explained", "tied": [], "runs": ["nylon-3"]}
    doubts = " ".join(adopted(adopted=[adopted_verdict], **error_fields).split())
    assert "On the last strokes the calibrated simulator is worse" in doubts and "unseen" not in doubts
    assert (
        "Something systematic is still missing: the last strokes are missed by 96 times the noise (1.3 is the limit). "
        in doubts
    )


def test_the_run_that_decides_between_what_was_adopted_and_what_tied_stays_proposed_with_its_steps_and_commands():
    experiment = spoken(content(next_run__title="one stroke under half the load"), SYSTEMS["mm"])["next_experiment"]
    adopted_verdict = {"effects": ["creep"], "verdict": "ambiguous", "tied": [["thermal"]], "runs": ["nylon-3"]}
    text = adopted(adopted=[adopted_verdict | {"next_experiment": experiment}])
    run = text.partition("\nThe run to make next\n")[2].partition("\n\n")[0].splitlines()
    still = "Others were likely beside what was adopted. The run that decides is still that of the adopted verdict:"
    assert run[:2] == [f"  {still}", "  One stroke under half the load: 3.5 min in all."]
    assert [line.strip()[:2] for line in run[2:7]] == ["1.", "2.", "3.", "4.", "5."]
    assert run[3] == "    2. Wind to 30.7 turns in 16 s (1.9 turns/s)." and run[6] == "    5. Hold 2 min at 0 turns."
    assert run[7].startswith("  If your rig cannot change its load, leave this run out") and "`--together`" not in text
    told_ = [line.strip() for line in run if "python -m" in line]
    assert [line.split()[2].removeprefix("pipeline.") for line in told_] == ["adopt", "new_run", "capture", "diagnose"]
    assert told_[0] == "python -m pipeline.adopt --remove raw/nylon-3"
    assert told_[3] == "python -m pipeline.diagnose raw/nylon-3 raw/nylon-3-next --together --out DIR"
    assert "nothing is missing" not in text and "None is proposed" not in text
    lost = second()
    assert "The run that decides stands in the adopted verdict, under the same heading." in lost
    assert "None is proposed" in second(tied=[], verdict="explained")


def test_a_run_that_does_not_decide_is_not_proposed_once_more_after_adopting():
    experiment = spoken(content(next_run__gap_now=9.0, next_run__gap_then=9.0), SYSTEMS["mm"])["next_experiment"]
    assert "Hardly worth making" in experiment
    text = second(next_experiment=experiment)
    assert "found no run that decides between them" in text and "pipeline.new_run" not in text
    assert "nothing further can be named; what was adopted is one of 2 likely explanations" in " ".join(text.split())
    assert "The run that decides is still" not in text


def test_dimensions_at_their_bounds_take_trust_from_the_first_line_after_adopting():
    far = adopted(evidence__moved_sigma={"radius_mm": 3.0})
    assert "some by three times their tolerance: measure them again before you trust it; nothing" in " ".join(
        far.split()
    )
    assert "before you trust it" not in adopted(evidence__moved_sigma={"radius_mm": 2.0})


def test_the_first_line_says_by_how_much_a_run_with_adopted_effects_errs_and_when_not_to_predict_with_it():
    bad = adopted(evidence__nominal_mm=1.0, evidence__calibrated_mm=0.034).partition("\n\n")[0]
    advice = "fits no more with the dimensions of run.yaml: "
    advice += "do not predict with run.yaml as it stands: it errs by 1.0 mm rms, and by 0.034 mm once"
    assert advice in " ".join(bad.split())
    fair = " ".join(adopted(evidence__nominal_mm=0.05, evidence__calibrated_mm=0.034).partition("\n\n")[0].split())
    assert (
        "run.yaml as it stands errs by 0.050 mm rms, calibrated by 0.034 mm." in fair and "do not predict" not in fair
    )
    assert "as it stands" not in told(content(evidence__nominal_mm=1.0, evidence__calibrated_mm=0.034))


def test_what_is_adopted_already_is_not_listed_among_what_would_have_been_seen():
    text = adopted()
    listed = text.partition("\nWhat would have been seen\n")[2].partition("\n\n")[0]
    assert "backlash   0.0040 mm\n" in listed and "creep   0.020" not in listed
    assert "Not listed, for run.yaml has adopted it: creep." in listed
    bare = told(content(verdict="consistent", mismatch=None, mechanisms=[], alternatives=[], next_run=None))
    assert "creep   0.020 mm" in bare and "run.yaml has adopted" not in bare
    cannot = "Not listed, for this recording cannot show them, or calibration takes them up: "
    not_listed = " ".join(bare.split()).partition(cannot)[2].partition(".")[0].split(", ")
    assert "axial_elasticity" in not_listed and "creep" not in not_listed


@pytest.mark.parametrize(
    ("verdict", "means"),
    [
        ("parameters", "with creep in the simulator, and dimensions moved, nothing further can be named"),
        ("consistent", "with creep in the simulator nothing further can be named"),
    ],
)
def test_after_adopting_the_page_says_what_its_words_now_mean(verdict, means):
    adopted_verdict = {"effects": ["creep"], "verdict": "explained", "tied": [], "runs": ["nylon-3"]}
    text = " ".join(adopted(adopted=[adopted_verdict], verdict=verdict).split())
    assert "`nominal` now means the simulator with creep and the dimensions of run.yaml." in text
    assert "now means" not in told()
    assert f"`{verdict}` now means: {means}. That" in adoption.now_means(verdict, "creep", f"a {verdict} run")[0]


def test_only_words_that_the_page_uses_are_said_to_mean_something_else_now():
    """The page said what `parameters` and `nominal` now mean, and used neither word."""
    adopted_verdict = {"effects": ["creep"], "verdict": "explained", "tied": [], "runs": ["nylon-3"]}
    diagnosis = content(
        verdict="parameters", mechanisms=[], alternatives=[], next_run=None, mismatch=None, adopted=[adopted_verdict]
    )
    diagnosis["simulation"], diagnosis["evidence"]["explanations"] = [{"id": "creep", "parameters": {}}], []
    diagnosis["evidence"] |= {"adopted_mm": 0.03, "nominal_mm": 0.4, "calibrated_mm": 0.03}
    for shown in (page(diagnosis), told(diagnosis)):
        first, _, words = shown.partition("What to know first\n")[2].partition("\n\n")
        rest = words.partition("What the words mean")[0]
        for word in ("parameters", "nominal", "calibrated"):
            assert (f"`{word}` now means" in " ".join(first.split())) is (word in rest), word
    assert "nominal" not in page(diagnosis) and "`parameters`" not in page(diagnosis) + told(diagnosis)


def together(of_strokes, fitted=("kev-1", "kev-2"), **changes):
    """A joint verdict on three runs after adopting; the last strokes are of some, the effect was fitted to some."""
    verdict = content(
        verdict="parameters",
        mechanisms=[],
        alternatives=[],
        next_run=None,
        mismatch=None,
        fit__heldout__runs=list(of_strokes),
        **changes,
    )
    adoption = {"effects": ["creep"], "verdict": "explained", "tied": [], "runs": list(fitted)}
    own_zeros = [{"dimensions": {f"zero_{at}_mm": {"nominal": 0.0, "fitted": -1.0}}} for at in (1, 2)]
    verdict |= {"run": ["kev-1", "kev-2", "kev-3"], "simulation": [{"id": "creep", "parameters": {}}]}
    verdict["adopted"] = [adoption | own for own in own_zeros]
    verdict["evidence"] |= {"explanations": [], "nominal_mm": 0.033, "calibrated_mm": 0.031}
    return " ".join(full(verdict).split())


def test_strokes_of_a_run_that_adopted_effects_were_not_fitted_to_are_not_called_seen_before():
    """All of a joint verdict counted as seen where one of its runs was, though most last strokes were of a new run."""
    new = together(["kev-3"])
    assert "last 30 % of strokes (seen by no fit)" in new and "no test" not in new and "seen before" not in new
    assert new.startswith("kev-1, kev-2, kev-3: creep was adopted and still holds")
    assert "It was fitted to kev-1 and kev-2; the last strokes below are of kev-3, which no fit had seen." in new


def test_last_strokes_of_which_adopted_effects_were_fitted_to_some_are_said_to_be_both():
    both = together(["kev-2", "kev-3"])
    first = "creep was fitted to kev-1 and kev-2, and of the last strokes only those of kev-3 are a test of it; nothing"
    assert both.startswith(f"kev-1, kev-2, kev-3: {first} further can be named.")
    assert "last 30 % of strokes (partly seen)" in both and "seen before" not in both and "unseen" not in both
    assert "The adopted effects were fitted to those of kev-2 too. Those of kev-3 no fit had seen." in both
    assert "all their strokes included. Of the last strokes below only those of kev-3 are a test." in both


def test_last_strokes_that_adopted_effects_were_fitted_to_are_no_test_whichever_other_run_is_new():
    old = together(["kev-2"])
    assert "creep was fitted to kev-1 and kev-2, and so to the last strokes, which are no test of it;" in old
    assert "last 30 % of strokes (seen before)" in old
    every = together(["kev-2", "kev-3"], fitted=("kev-1", "kev-2", "kev-3"))
    assert "creep was fitted to these recordings, which are no test of it; nothing further" in every
    assert "It was fitted to these very recordings, all their strokes included: the error on the last strokes" in every


def test_what_two_runs_have_adopted_alike_is_said_once():
    assert together(["kev-3"]).count("No other explanation was as likely as what was adopted (creep).") == 1
