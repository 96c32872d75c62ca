"""What a string takes back in a break is no move of the zero: a sensor set to zero again is tared without it."""

from pathlib import Path

import numpy as np
import pandas as pd
import pytest
from made_recording import recording
from stages.nine_strokes import recorded, string

from pipeline.lifespan.words.sentences import zero
from pipeline.rig.kept_string import Standing
from pipeline.rig.setup import described, read_setup
from pipeline.run.strokes import segment
from pipeline.string.history import Recorded
from pipeline.string.recovered import measured_as, recovered_mm
from pipeline.string.rests import Rests
from pipeline.string.tare_notes import tare_notes
from pipeline.string.zero import change_mm, jumps_among, offsets_mm

SETUP = read_setup("paper").model_copy(update={"rate_hz": 25.0})
QUANTUM_MM = SETUP.sensors["displacement_mm"].quantum


def strings_runs(strokes: tuple[int, ...], zeroed: bool = True) -> tuple[list[Recorded], list[float]]:
    """Recordings of one string of the example rig, a minute apart, and where its sensor stood at each start in mm."""
    rig, runs, starts = Standing(SETUP, 1, zeroed=zeroed), [], []
    for number, count in enumerate(strokes):
        rig.setup = SETUP.model_copy(update={"motion": SETUP.motion.of_strokes(count)})
        simulated, name = rig.own(), f"a-{number + 1}"
        starts.append(float(simulated.truth["displacement_mm"][0]))
        columns = {
            "time_s": simulated.time_s + 1e4 * number,
            "motor_turns": simulated.truth["motor_turns"],
            "displacement_mm": simulated.samples["displacement_mm"] * QUANTUM_MM,
            "load_n": 20.0,
        }
        samples = pd.DataFrame(columns)
        run = described(SETUP, Path(f"raw/{name}/run.yaml")).model_copy(update={"tare": "run" if number else "string"})
        runs.append(Recorded(run, "", samples, segment(samples, "motor_turns", name)))
    return runs, starts


def test_a_sensor_that_was_set_to_zero_is_tared_without_what_the_string_took_back() -> None:
    runs, starts = strings_runs((9, 9, 5))
    errors = np.diff(offsets_mm(runs)) - np.diff(starts)
    assert np.abs(errors).max() < 0.03, "nearly the true zero"
    rests = [Rests.of(run) for run in runs]
    kept = np.array([-change_mm(*rests[at : at + 2]) for at in (0, 1)]) - np.diff(starts)
    assert np.abs(kept).min() > 0.05, "where the string rested before would be further off"


def test_too_few_strokes_tell_nothing() -> None:
    for strokes in ((1, 9), (9, 2)):
        assert recovered_mm(*map(Rests.of, strings_runs(strokes)[0])) == 0.0
    assert recovered_mm(*map(Rests.of, strings_runs((2, 3))[0])) > 0.03


def test_a_sensor_that_keeps_its_zero_shows_what_the_string_took_back() -> None:
    runs, _ = strings_runs((9, 9), zeroed=False)
    before, after = map(Rests.of, runs)
    assert 0.03 < change_mm(before, after) < 0.1
    assert not jumps_among([before, after]), "no jump: it reads what the string does"


def halves(cut_s: float = 121.0) -> list[pd.DataFrame]:
    """Two recordings of a string that takes nothing back."""
    whole = recording(8, rate_hz=20.0)
    return [whole[part].reset_index(drop=True) for part in (whole["time_s"] < cut_s, whole["time_s"] >= cut_s)]


def rests_of(parts: list[pd.DataFrame]) -> list[Rests]:
    return [
        Rests.of(recorded(name, samples=part, string=string(id="a"), tare=tare))
        for name, part, tare in zip(("a-1", "a-2"), parts, ("string", "run"), strict=True)
    ]


def test_wear_alone_is_not_taken_back_and_a_slip_counts_no_more_than_was_lost() -> None:
    first_half, two = halves()
    assert recovered_mm(*rests_of([first_half, two])) == 0.0
    late = two["time_s"] > 130.0  # amid the first stroke of the second run
    slipped = two.assign(displacement_mm=two["displacement_mm"] - 3.0 * late)
    assert recovered_mm(*rests_of([first_half, slipped])) == pytest.approx(0.4, abs=0.05), (
        "four strokes of 0.1 mm were lost"
    )


def test_rests_under_another_load_tell_nothing() -> None:
    first_half, two = halves()
    lost = two["time_s"] > 130.0
    dropped = two.assign(displacement_mm=two["displacement_mm"] - 0.2 * lost)
    assert recovered_mm(*rests_of([first_half, dropped])) > 0.15
    assert recovered_mm(*rests_of([first_half, dropped.assign(load_n=20.0 + 5.0 * lost)])) == 0.0


def test_what_is_left_in_is_said() -> None:
    ((name, note),) = tare_notes([Rests.of(run) for run in strings_runs((9, 9), zeroed=False)[0]])
    assert name == "a-2" and "and that is taken off, but for 0.0" in note
    assert note.endswith("back in the break, and later strokes may take more.")
    runs, _ = strings_runs((9, 9))
    (jump,) = jumps_among([Rests.of(run) for run in runs])
    assert "is taken off the displacement before the tables and models are made, but for 0.0" in jump.advice
    assert jump.moved_mm == pytest.approx(jump.jump_mm - jump.recovered_mm) and jump.recovered_mm > 0.03


def test_the_words_say_between_which_readings_and_at_which_twist_it_was_measured() -> None:
    """It was called all that the string took back: a string that took back 0.48 mm was said to have taken 0.17."""
    first_half, two = halves()
    fell = two["time_s"] > 130.0  # after the first stroke of the second run, and by half as much after its second
    second = two["time_s"] > 160.0
    slow = two.assign(displacement_mm=5.0 + two["displacement_mm"] - 0.2 * fell - 0.1 * second)
    rests = rests_of([first_half, slow])
    (jump,) = jumps_among(rests)
    assert 0.05 < jump.recovered_mm < 0.3 and jump.rest_turns == pytest.approx(rests[1].turns[0])
    less = f"{jump.recovered_mm:.2g} mm"
    measured = f"At rest, at {rests[1].turns[0]:.1g} turns, a-2 reads {less} less after its first stroke than before it"
    for words in (jump.advice, zero(jump)):
        assert measured in words and "later strokes may take more." in words, words
    assert f" {less} stay in. At rest" in zero(jump)


def test_a_twist_a_little_below_0_is_called_0() -> None:
    assert "at 0 turns," in measured_as("a-2", 0.2, -0.01)
