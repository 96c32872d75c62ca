"""The verdict's own rules, each on both sides of its number, on a simulator of which every residual is known."""

from dataclasses import dataclass, replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from pipeline.diagnosis.choice import judged, outcome
from pipeline.diagnosis.choice.judged import Judged
from pipeline.diagnosis.choice.outcome import decide
from pipeline.diagnosis.choice.search import Explanation
from pipeline.diagnosis.fit.problem import Act, State
from pipeline.diagnosis.numerics.noise import Noise

FLOOR = 2.0
SEEN, UNSEEN = 400, 100
SIGN = np.resize([1.0, -1.0], SEEN + UNSEEN)  # rms and spread 1
WAVES = {  # of an rms of 1 in what is seen; the halves differ from the sign, so that effects can be told apart
    "creep": np.resize([1.0, 1.0, -1.0, -1.0], SEEN + UNSEEN),
    "jam": np.resize([1.0, 1.0, -1.0, -1.0], SEEN + UNSEEN),
    "x_wave": np.resize([1.0, 1.0, 1.0, 1.0, -1.0, -1.0, -1.0, -1.0], SEEN + UNSEEN),
    "stick_slip": SIGN,
}


@dataclass(frozen=True)
class Bench:
    """A simulator that reads what a state's values say, and its acts add their waves."""

    measured: np.ndarray
    rows: int = SEEN
    included: tuple[Act, ...] = ()
    beside: tuple[Act, ...] = ()

    @property
    def drivers(self) -> SimpleNamespace:
        """Those of a string."""
        return SimpleNamespace(levered=True)

    @property
    def record(self) -> SimpleNamespace:
        """A sample each tenth of a second."""
        return SimpleNamespace(time_s=np.arange(SEEN + UNSEEN) * 0.1)

    @property
    def adopted(self) -> tuple[Act, ...]:
        """What comes of run.yaml: all that is included."""
        return self.included

    def simulate(self, state: State) -> np.ndarray:
        """The reading of a state."""
        return state.values + sum(act.coefficients[0] * WAVES[act.id] for act in state.acts if act.coefficients[0])

    def terms(self, mechanism: object, shape: object) -> list[str]:
        """One term of each mechanism, whatever it is."""
        return ["one"]


def act(id_: str, strength: float) -> Act:
    """A mechanism at work."""
    return Act(id_, ({},), (strength,))


def missing(beyond: float) -> np.ndarray:
    """A reading that errs by its noise and by so many noise floors beyond it; in what no fit sees, by far more."""
    reading = FLOOR * np.hypot(1.0, beyond) * SIGN
    reading[SEEN:] *= 50.0
    return reading


def explanation(ids: str) -> Explanation:
    """An explanation that names these."""
    return Explanation(tuple(ids.split()), (), None, 0.0, 0.0)  # type: ignore[arg-type]


NOTHING = explanation("")


def decided(
    base: float, best: float | None = None, sets: tuple[str, ...] = (), none: float = 0.0, **options: Any
) -> outcome.Study:
    """The verdict where calibration leaves `base` noise floors beyond the noise, and the best explanation `best`."""
    problem = Bench(np.zeros(SEEN + UNSEEN), included=options.get("included", ()))
    acts = options.get("acts", ())
    best_values = missing(base if best is None else best) - sum(
        effect.coefficients[0] * WAVES[effect.id] for effect in acts
    )
    return decide(
        problem,  # type: ignore[arg-type]
        State(missing(options.get("nominal", base)), np.zeros(1), problem.included),
        State(missing(base), np.zeros(1), problem.included),
        Noise(FLOOR, np.zeros(0), FLOOR, options.get("swallowed", 0.0)),
        State(best_values, np.zeros(1), acts),
        Judged([explanation(ids) for ids in sets], {}, none),
        SimpleNamespace(nothing=NOTHING),  # type: ignore[arg-type]
        options.get("random", {}),
    )


@pytest.mark.parametrize(("samples", "verdict"), [(5, "consistent"), (7, "unknown")])
def test_a_reading_that_is_off_for_half_a_second_is_unknown_however_loud_the_noise_is_told(samples, verdict):
    reading = np.random.default_rng(0).normal(0.0, FLOOR, SEEN + UNSEEN)
    reading[100 : 100 + samples] = 6.0 * FLOOR
    state = State(reading, np.zeros(1))
    problem, noise = Bench(np.zeros(SEEN + UNSEEN)), Noise(2.0 * FLOOR, np.zeros(0), FLOOR)
    search = SimpleNamespace(nothing=NOTHING)
    study = decide(problem, state, state, noise, state, Judged([], {}, 1.0), search, {})  # type: ignore[arg-type]
    assert study.verdict == verdict


@pytest.mark.parametrize(("beyond", "verdict"), [(0.0, "consistent"), (0.34, "consistent"), (0.36, "unknown")])
def test_without_an_explanation_a_mismatch_of_a_third_of_the_noise_is_unknown(beyond, verdict):
    study = decided(beyond)
    assert study.verdict == verdict
    assert study.mismatch == pytest.approx(FLOOR * beyond, abs=1e-6) and study.floor == FLOOR
    assert study.state is study.base and study.random_rms == 0.0
    assert study.share == pytest.approx(0.0 if beyond else 1.0, abs=1e-6)  # of nothing, all is taken


@pytest.mark.parametrize(("swallowed", "verdict"), [(0.1, "unknown"), (0.2, "unknown"), (0.5, "consistent")])
def test_where_the_noise_is_known_badly_more_is_taken_for_noise(swallowed, verdict):
    assert decided(0.6, swallowed=swallowed).verdict == verdict
    limit = outcome.surely(Noise(1.0, np.zeros(0), 1.0, swallowed))
    assert limit == pytest.approx({0.1: 0.35, 0.2: 0.48057, 0.5: 0.76570}[swallowed], abs=1e-5)


@pytest.mark.parametrize(("better", "verdict"), [(0.14, "consistent"), (0.16, "parameters")])
def test_parameters_that_moved_are_a_verdict_where_that_helped_by_a_seventh_of_the_noise(better, verdict):
    nominal = float(np.hypot(0.1, better))
    assert decided(0.1, nominal=nominal).verdict == verdict
    assert decided(0.3, 0.0, ("x_wave",), nominal=float(np.hypot(0.3, better))).verdict == verdict  # unknown, but small
    assert decided(2.0, nominal=float(np.hypot(2.0, better))).verdict == "unknown"


@pytest.mark.parametrize(("sets", "verdict"), [(("creep",), "explained"), (("creep", "jam wear"), "ambiguous")])
def test_one_explanation_explains_and_several_are_ambiguous(sets, verdict):
    study = decided(3.0, 0.1, sets, acts=(act("creep", 1.0),))
    assert study.verdict == verdict and study.state is study.best and study.best_ids == ("creep",)
    assert study.share == pytest.approx(1.0 - 0.1**2 / 3.0**2) and study.sets[0].ids == ("creep",)


@pytest.mark.parametrize(("none", "verdict"), [(0.39, "explained"), (0.4, "unknown")])
def test_none_of_them_likely_enough_is_unknown(none, verdict):
    study = decided(3.0, 0.1, ("creep",), none, acts=(act("creep", 1.0),))
    assert study.verdict == verdict and (study.state is study.best) == (verdict == "explained")


@pytest.mark.parametrize(
    ("base", "best", "verdict"),
    [(3.0, 0.9, "explained"), (3.0, 1.0, "unknown"), (0.5, 0.19, "explained"), (0.5, 0.21, "unknown")],
)
def test_an_explanation_takes_nine_tenths_of_the_energy_or_leaves_next_to_nothing(base, best, verdict):
    assert decided(base, best, ("creep",), acts=(act("creep", 1.0),)).verdict == verdict


def test_an_explanation_without_physics_is_unknown_unless_the_mismatch_is_small():
    assert decided(3.0, 0.1, ("x_wave",)).verdict == "unknown"
    assert decided(0.36, 0.0, ("x_wave",)).verdict == "unknown"
    assert decided(0.34, 0.0, ("x_wave",)).verdict == "consistent"
    assert decided(3.0, 0.1, ("creep x_wave",), acts=(act("creep", 1.0),)).verdict == "explained"


@pytest.mark.parametrize(("net_strength", "verdict"), [(1.1, "explained"), (0.9, "unknown")])
def test_effects_far_larger_than_what_they_do_together_are_no_explanation(net_strength, verdict):
    balance = (act("creep", 8.0), act("jam", net_strength - 8.0))  # together `net_strength`; the larger is 8 alone
    study = decided(3.0, 0.1, ("creep jam",), acts=balance)
    assert study.verdict == verdict
    problem = study.problem
    assert outcome.cancels(problem, study.best) == (verdict == "unknown")
    assert not outcome.cancels(problem, replace(study.best, acts=balance[:1]))  # one alone is no balance
    assert not outcome.cancels(problem, replace(study.best, acts=()))
    own = replace(problem, included=balance[1:])  # what run.yaml adopted is no part of it
    assert not outcome.cancels(own, study.best)


@pytest.mark.parametrize(("share", "verdict"), [(0.69, "explained"), (0.71, "unknown")])
def test_a_helper_that_takes_most_of_the_mismatch_is_the_explanation(share, verdict):
    acts = (act("creep", 9.0), act("x_wave", share * 3.0 * FLOOR))
    study = decided(3.0, 0.1, ("creep x_wave",), acts=acts)
    assert study.verdict == verdict
    own = replace(study.problem, included=acts[1:])
    assert not outcome.helped(own, study.best, study.mismatch)
    assert not outcome.helped(study.problem, replace(study.best, acts=acts[:1]), study.mismatch)  # creep is physics


def test_only_what_a_fit_sees_tells_how_much_a_helper_takes(monkeypatch):
    late = np.where(np.arange(SEEN + UNSEEN) < SEEN, 0.1, 50.0) * SIGN
    monkeypatch.setitem(WAVES, "x_wave", late)
    study = decided(3.0, 0.1, ("creep x_wave",), acts=(act("creep", 9.0), act("x_wave", 1.0)))
    assert study.verdict == "explained"


@pytest.mark.parametrize(("bare", "verdict"), [(9.4, "unknown"), (9.6, "consistent")])
def test_what_an_adopted_explanation_may_leave_is_nothing_unknown(monkeypatch, bare, verdict):
    adopted = (act("creep", 1.0),)

    def calibrate(problem, noise):
        assert problem.included == () and noise.floor == FLOOR
        return State(missing(bare), np.zeros(1))

    monkeypatch.setattr(outcome, "calibrate", calibrate)
    noise = Noise(FLOOR, np.zeros(0), FLOOR)
    problem = Bench(np.zeros(SEEN + UNSEEN), included=adopted)
    assert outcome.bare(problem, noise) == pytest.approx(FLOOR * bare)  # type: ignore[arg-type]
    values = missing(3.0) - WAVES["creep"]
    measured = replace(problem, measured=np.zeros(SEEN + UNSEEN))
    state = State(values, np.zeros(1), adopted)
    study = decide(measured, state, state, noise, state, Judged([], {}, 1.0), SimpleNamespace(nothing=NOTHING), {})  # type: ignore[arg-type]
    assert study.verdict == verdict and study.best_ids == ()


QUIET = 0.5 * FLOOR  # the noise at rest, where jerks were taken for noise in motion
SLIP = {"reach_mm": 0.5 * QUIET}  # jerks of up to ten times as much may be its own


def jerky(monkeypatch, jerks, sets=(), none=0.0, acts=(), included=(), likely=None):
    """The verdict on jerks of so many floors at rest, on top of what was explained but for them."""

    def floor_at_rest(problem, state, otherwise):
        assert otherwise == FLOOR and state.acts == acts
        return QUIET

    monkeypatch.setattr(outcome.chance, "floor_at_rest", floor_at_rest)
    problem = Bench(np.zeros(SEEN + UNSEEN), included=included)
    reading = np.hypot(1.0, jerks) * QUIET * SIGN
    base = State(reading, np.zeros(1), included)
    best = State(reading - sum(effect.coefficients[0] * WAVES[effect.id] for effect in acts), np.zeros(1), acts)
    weighed = Judged([explanation(ids) for ids in sets], likely or {}, none)
    search = SimpleNamespace(nothing=NOTHING)
    return decide(problem, base, base, Noise(FLOOR, np.zeros(0), FLOOR), best, weighed, search, {"stick_slip": SLIP})


def test_random_jerks_are_named_where_they_stand_out_of_the_noise_at_rest(monkeypatch):
    study = jerky(monkeypatch, 0.21)
    assert study.verdict == "explained" and [candidate.ids for candidate in study.sets] == [("stick_slip",)]
    assert study.floor == QUIET and study.random == {"stick_slip": SLIP}
    assert study.random_rms == pytest.approx(0.21 * QUIET) and study.mismatch == pytest.approx(0.21 * QUIET)
    assert study.best.acts == (Act("stick_slip", (SLIP,), (0.0,)),)  # there, and silent


def test_jerks_alone_are_named_where_the_judge_had_nothing_to_weigh(monkeypatch):
    study = jerky(monkeypatch, 0.21, none=judged.NOTHING.none)
    assert study.verdict == "explained" and [candidate.ids for candidate in study.sets] == [("stick_slip",)]


def test_smaller_jerks_are_noise(monkeypatch):
    study = jerky(monkeypatch, 0.19)
    assert study.verdict == "consistent" and not study.sets and not study.random
    assert study.floor == FLOOR and study.random_rms == 0.0 and not study.best.acts


def test_what_no_jerk_is_large_enough_for_is_not_named_after_jerks(monkeypatch):
    """A load read as the displacement was 'explained by stick_slip' of 0.003 mm, which left all of 6.5 mm."""
    assert jerky(monkeypatch, 4.9).verdict == "explained"
    study = jerky(monkeypatch, 5.1)
    assert study.verdict == "unknown" and not study.sets and not study.random and study.floor == FLOOR


def test_jerks_join_every_explanation_and_excuse_what_it_leaves(monkeypatch):
    study = jerky(monkeypatch, 3.0, ("creep", "jam"))
    assert [candidate.ids for candidate in study.sets] == [("creep", "stick_slip"), ("jam", "stick_slip")]
    assert study.verdict == "ambiguous" and study.mismatch == pytest.approx(3.0 * QUIET)
    assert jerky(monkeypatch, 3.0, ("creep",), none=0.4).verdict == "unknown"


def test_with_the_jerks_and_without_them_an_explanation_is_one_and_as_likely_as_both(monkeypatch):
    likely = {("creep",): 0.5, ("creep", "stick_slip"): 0.3, ("stick_slip",): 0.1, ("x_wave",): 0.02}
    study = jerky(monkeypatch, 3.0, ("creep", "creep stick_slip"), likely=likely)
    assert [candidate.ids for candidate in study.sets] == [("creep", "stick_slip")] and study.verdict == "explained"
    assert study.judged.likely == {("creep", "stick_slip"): 0.8, ("stick_slip",): 0.1, ("x_wave",): 0.02}


def test_an_explanation_that_holds_the_jerks_needs_no_second_silent_one(monkeypatch):
    own = (act("stick_slip", 0.5),)
    study = jerky(monkeypatch, 1.0, ("stick_slip",), acts=own)
    assert study.best.acts == own and [candidate.ids for candidate in study.sets] == [("stick_slip",)]


def test_jerks_that_were_adopted_are_named_no_second_time_and_are_no_mismatch(monkeypatch):
    own = (act("stick_slip", 0.0),)
    study = jerky(monkeypatch, 1.0, acts=own, included=own)
    assert study.verdict == "consistent" and not study.sets and not study.random
    assert study.random_rms == 0.0 and study.floor == QUIET and study.best.acts == own


@pytest.mark.parametrize(("better", "verdict"), [(0.14, "consistent"), (0.16, "parameters")])
def test_an_unknown_too_small_to_be_one_is_what_calibration_made_of_it(better, verdict):
    study = decided(0.349, 0.3, ("creep",), none=0.5, nominal=float(np.hypot(0.349, better)))
    assert study.verdict == verdict and study.sets and study.state is study.base
