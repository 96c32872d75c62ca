"""What the numbers of an adopted effect multiply, in words."""

import re
from dataclasses import replace

import numpy as np
import pytest

from pipeline.diagnosis.adoption.number_sizes import sizes
from pipeline.diagnosis.choice.outcome import rms
from pipeline.diagnosis.facts.mechanism_entries import effect_of, unit_of_nonlinear
from pipeline.diagnosis.fit.problem import Act
from pipeline.diagnosis.mechanisms.library import mechanisms
from pipeline.diagnosis.mechanisms.shared_meanings import MEANINGS
from pipeline.diagnosis.recording.system_units import Units
from pipeline.diagnosis.words.language.vocabulary import Vocabulary
from pipeline.diagnosis.words.measured import moved_reading
from pipeline.diagnosis.words.named import coefficients, formulas
from pipeline.diagnosis.words.named.coefficients import factors
from pipeline.diagnosis.words.named.nonlinear_parameters import CHOSEN, measurable, on_this_rig, unit_of_parameter
from pipeline.ground.units import unit_of
from pipeline.systems import systems

NO_LETTERS = set(["sum", "max", "min", "sin", "tan", "ln", "exp", "sign", "or", "of", "a", "sag", "such", "pi", "dt"])
NAMES = {"twist": "a", "steep_twist": "b", "load": "c", "dry_*_twist": "d"}


def test_of_two_words_at_one_place_the_longer_one_is_meant() -> None:
    assert factors(NAMES, "steep_twist_60_s_mm_per_10_n") == {"steep_twist": "b"}
    assert factors(NAMES, "twist_60_s_mm") == {"twist": "a"} and factors(NAMES, "load_4_s_mm") == {"load": "c"}


def test_a_share_within_a_name_is_any_number() -> None:
    assert factors(NAMES, "dry_0.02_twist_mm_per_10_n") == {"dry_*_twist": "d"}


def test_each_number_has_a_sentence_with_its_unit_and_what_it_does_at_full_twist(problem) -> None:
    words = Vocabulary.of(problem.system)
    shape = {"critical_turns": 0.5 * float(problem.record.motion.max()), "softness_turns": 0.1}
    state = replace(problem.nominal(), acts=(Act("jam", (shape,), (0.4, 0.0)),))
    ((whole, share),) = own = sizes(problem, state)
    assert whole == share, "the other coefficient is 0, and has no line"
    effect = problem.simulate(state) - problem.simulate(problem.nominal())
    assert whole.rms == pytest.approx(rms(effect_of(problem, state, state.acts[0]))), "the size that a verdict gives"
    assert whole.rms == pytest.approx(rms(effect)) and whole.at_top < 0.0
    top = problem.record.motion >= 0.999 * problem.record.motion.max()
    assert whole.at_top == pytest.approx(np.mean(effect[top]), rel=0.1), "beyond the critical twist it contracts less"
    _, first, head, number, does, critical, place, softness, _, formula, *table = coefficients.lines(
        state.acts, problem.drivers, words, own
    )
    assert first.startswith("  jam: ") and "In all it moves the reading by " in first and " rms, and by -" in first
    assert head.startswith("    number ") and "reading moved, rms   change from " in head and " to " in head
    assert number.split()[:2] == ["share", "0.4"] and does == "      how strong it is; acts on the twist"
    moved, way = (float(number.split()[at]) for at in (2, 4))
    assert moved == pytest.approx(whole.rms, rel=0.05) and way == pytest.approx(whole.at_top, rel=0.05)
    assert number.split()[3] == number.split()[5] == "mm", "one unit in a column"
    assert critical.split()[0] == "critical_turns" and place == "      the twist from which on it acts"
    assert softness.split()[0] == "softness_turns" and formula == f"    Its formula: {mechanisms()['jam'].equation}"
    head, *rows, signs = [line.split() for line in table]
    assert head == ["letter", "value", "what", "it", "is"] and signs[:2] == ["Signs:", "max:"]
    of_letter = {row[0]: row[1:] for row in rows}
    assert list(of_letter) == ["theta_s", "theta", "s", "theta_c"], "each letter of the formula has its row"
    assert of_letter["s"][0] == "0.4" and of_letter["theta_c"][:2] == critical.split()[1:3], "value and unit"
    assert of_letter["theta"][1] == "to" and of_letter["theta"][3] == "turns", "the range in the recording"


def test_what_an_effect_does_in_the_recording_stands_first(problem) -> None:
    """The first lines of `--explain` were of `share` and `multiplies stop`; nobody learnt what the loop is."""
    words = Vocabulary.of(problem.system)
    shape = {"play_turns": 0.04, "usual_load": float(np.median(problem.drivers.load))}
    state = replace(problem.nominal(), acts=(Act("friction_hysteresis", (shape,), (0.42, 0.65)),))
    own, does = sizes(problem, state), {"friction_hysteresis": "Half the width of the loop is 0.026 turns."}
    lines = coefficients.lines(state.acts, problem.drivers, words, own, does)
    assert lines[1].startswith("  friction_hysteresis: Half the width of the loop is 0.026 turns. In all it moves ")
    assert lines[2] == (
        "    It is made of 2 elements: the first 2 rows. 0.42 and 0.65 are weights, which need not add up to 1."
    )
    lines = [line for line in lines if not line.startswith("    The rows of the last column add up to ")]
    first_letter = next(at for at, line in enumerate(lines) if line.startswith("    Its formula: "))
    assert lines[first_letter - 1].startswith("    To measure at the rig: half the width of the loop is ")
    rows = lines[4 : first_letter - 1]
    assert len(rows) % 2 == 0 and all(row.startswith("      ") for row in rows[1::2]), "each row has its meaning"
    assert rows[-2].split()[:3] == ["usual_load", f"{10.0 * shape['usual_load']:.3g}", "N"]
    assert f"run.yaml has it as {shape['usual_load']:.3g}, in 10 N" in rows[-1] and "where – stands" in lines[0]
    assert lines[first_letter].endswith(mechanisms()["friction_hysteresis"].variants["play_turns"])
    values = {row.split()[0]: row.split("   ")[1:] for row in lines[first_letter + 2 : -1]}
    assert any("0.04 turns" in cell for cell in values["w"]) and any("1 and 0.4" in cell for cell in values["b_i"])


def test_a_column_that_says_nothing_is_left_out(problem) -> None:
    """`change from 0.2 to 19.2 turns` stood over a column of nothing but –."""
    words, act = (
        Vocabulary.of(problem.system),
        Act("jam", ({"critical_turns": 1.0, "softness_turns": 0.1},), (0.4, 0.0)),
    )
    still = coefficients.Size(0.1, 0.0, (0.0, 20.0))
    lines = coefficients.lines([act], problem.drivers, words, [[still, still]])
    assert lines[2].split() == ["number", "value", "reading", "moved,", "rms"]
    moving = coefficients.Size(0.1, 0.1, (0.0, 20.0))
    lines = coefficients.lines([act], problem.drivers, words, [[moving, moving]])
    assert lines[2].endswith(" change from 0 to 20 turns")


def test_the_rest_of_an_equation_says_what_its_letters_are(problem) -> None:
    friction = mechanisms()["friction_hysteresis"]
    shown, letter_meanings = formulas.split(friction.plain_equation)
    assert (
        shown == "h s"
        and letter_meanings["h"] == "half the loop"
        and letter_meanings["s"].endswith("to 1, rounded where it turns")
    )
    backlash = mechanisms()["backlash"].equation
    assert formulas.split(backlash) == (backlash, {}), "half the play is no letter"


def test_each_kind_of_an_effect_has_its_own_equation_where_nothing_is_twisted_too() -> None:
    stiffening, drive = mechanisms()["stiffening"], Vocabulary.of(systems()["cable_drive"])
    over_time = formulas.formula(stiffening, drive, ["whole_s", "from_load"])
    assert "g(t)" in over_time and "g(c)" in formulas.formula(stiffening, drive, ["work", "from_load"])


def test_sizes_of_one_table_have_one_unit(problem) -> None:
    """0.30 µm stood in a column of mm."""
    words = Vocabulary.of(problem.system)
    cells = moved_reading.cells(coefficients.Size(0.0003, -0.0002, (0.0, 20.0)), words, 0.0268)
    assert cells[0] == "0.0003 mm"
    assert moved_reading.cells(coefficients.Size(0.0002, 0.0, (0.0, 20.0)), words, 0.11)[0] == "less than 0.001 mm"


def test_numbers_that_cancel_are_said_to_and_what_rounding_leaves_is_not(problem) -> None:
    """Rows of 0.67 and 0.31 mm stood under an effect of 0.11 mm, and a sentence excused 0.001 mm of rounding."""
    words, ends = Vocabulary.of(problem.system), (0.0, 20.0)
    whole = moved_reading.Size(0.11, 0.003, ends)
    parts = [moved_reading.Size(0.668, 0.135, ends), moved_reading.Size(0.305, -0.1324, ends)]
    (sentence,) = moved_reading.not_added_up(whole, parts, words)
    assert sentence == (
        "    The numbers cancel each other in part: up to 0.67 mm rms each, where the whole effect is 0.11 mm."
    )
    alike = [moved_reading.Size(0.06, 0.002, ends), moved_reading.Size(0.05, 0.0004, ends)]
    assert moved_reading.not_added_up(whole, alike, words) == []
    (sentence,) = moved_reading.not_added_up(whole, [moved_reading.Size(0.1, 0.05, ends)], words)
    assert sentence.endswith("+0.050 mm, not to +0.003 mm: what each number does depends on the others.")


def test_half_a_play_is_said_as_what_a_person_measures_at_the_rig(problem) -> None:
    """A row sent the reader to another page for the one number that he can measure."""
    words = Vocabulary.of(problem.system)
    act = Act("backlash", ({"half_width_turns": 0.0256},), (0.487, 0.673))
    advice = measurable(act, problem.drivers, words)
    assert advice == ["    To measure at the rig: half the play is 0.0211 turns."]
    shape = {"play_turns": 0.0504, "usual_load": 2.0}
    act = Act("friction_hysteresis", (shape,), (0.0, 1.047))
    (advice,) = measurable(act, problem.drivers, words)
    assert advice.startswith("    To measure at the rig: half the width of the loop is ") and advice.endswith(
        " under 20 N."
    )


@pytest.mark.parametrize("id_", list(mechanisms()))
def test_each_letter_of_a_formula_has_a_row_with_value_and_meaning(problem, id_: str) -> None:
    mechanism, words = mechanisms()[id_], Vocabulary.of(problem.system)
    numbers = formulas.Numbers(("0.1 mm", "0.2 mm"), {"load_power": "1"}, 0.1)
    for equation in (mechanism.equation, *mechanism.variants.values()):
        formula = re.split(r", (?:s_i: stop|theta' the|e: any|s sticks)|; half|: any| where ", equation)[0]
        lines = formulas.lines(equation, mechanism, words, problem.drivers, numbers)
        rows = {line.split()[0]: line.split()[1:] for line in lines}
        for letter in set(formulas.LETTER.findall(formula)) - NO_LETTERS:
            bare = letter if letter in rows else re.sub("'+$|^d", "", letter)
            assert bare in rows and len(rows[bare]) > 1, letter
        signs = lines[-1] if lines[-1].startswith("Signs: ") else ""
        assert all(f" {name}: " in signs for name in formulas.FUNCTIONS if name in formulas.LETTER.findall(equation))


def test_a_factor_with_a_share_in_the_names_is_said_once_above_the_table(problem) -> None:
    """Eight rows said "the state of a stop, from -1 to 1, as wide as that share of the range", and not which share."""
    names = ["stop_0.08_load_mm_per_10_n", "stop_0.2_load_mm_per_10_n", "dry_0.1_twist_mm_per_10_n"]
    stop, dry = coefficients._shares(mechanisms()["friction_hysteresis"], names)
    assert stop.startswith(
        "    stop: the state of a stop, from -1 to 1, as wide as a share of the range. In stop_0.08_"
    )
    assert stop.endswith(" the share is 0.08.") and dry.endswith(" In dry_0.1_twist_mm_per_10_n the share is 0.1.")
    what = coefficients._what(mechanisms()["friction_hysteresis"], names[0], "is lost")
    assert what == "is lost; it multiplies the stop 0.08 (above) and the load"


def candidates(mechanism, problem) -> list[dict[str, float]]:
    """What a mechanism tries on a string, and on a drive that twists nothing."""
    return [*mechanism.candidates(problem.drivers), *mechanism.candidates(replace(problem.drivers, levered=False))]


def test_every_number_in_a_formula_has_its_meaning(problem) -> None:
    words = Vocabulary.of(problem.system)
    for mechanism in mechanisms().values():
        keys = {key for nonlinear in candidates(mechanism, problem) for key in nonlinear}
        for key in keys | set(mechanism.units) | set(mechanism.optional):
            meaning = on_this_rig(key, mechanism, words)
            assert CHOSEN not in meaning and "{" not in meaning, (mechanism.id, key)
        assert CHOSEN in on_this_rig("of_your_own", mechanism, words)


def test_a_mechanism_says_in_its_own_file_what_its_nonlinear_parameters_mean(problem) -> None:
    words = Vocabulary.of(problem.system)
    own = replace(mechanisms()["x_wave"], id="x_mine", meanings={"edge_turns": "the {motion} at which it starts"})
    assert on_this_rig("edge_turns", own, words) == "the twist at which it starts"
    for mechanism in mechanisms().values():
        assert not set(mechanism.meanings) & set(MEANINGS), f"{mechanism.id}: several have it"


def test_a_number_in_a_formula_has_the_unit_of_its_names_whole_ending(problem) -> None:
    words, rigs = Vocabulary.of(problem.system), systems()
    keys = {
        key for mechanism in mechanisms().values() for shape in mechanism.candidates(problem.drivers) for key in shape
    }
    per_s = sorted(key for key in keys if key.endswith("_per_s"))
    assert "fastest_turns_per_s" in per_s
    for key in per_s:
        assert unit_of_parameter(key, key) == "turns/s", key
    assert unit_of_parameter("fastest_s", "fastest_s") == "s"
    assert on_this_rig("fastest_s", mechanisms()["creep"], words).startswith("the shortest time constant")
    drive = rigs["cable_drive"]
    own = Units.of(drive).name("slow_turns_per_s")
    assert unit_of_parameter("slow_turns_per_s", own) == "deg/s", own
    for key in keys:
        assert unit_of_nonlinear(key) in ("1", unit_of(key)), key


@pytest.mark.parametrize("id_", [id_ for id_, mechanism in mechanisms().items() if mechanism.names])
def test_every_word_that_is_explained_stands_in_a_name_of_its_mechanism(problem, id_: str) -> None:
    mechanism, kinds = mechanisms()[id_], [problem.drivers, replace(problem.drivers, levered=False)]
    named = [
        f"_{term.name}_"
        for drivers in kinds
        for nonlinear in mechanism.candidates(drivers)
        for term in mechanism.terms(drivers, nonlinear | ({"loaded": 1.0} if "loaded" in nonlinear else {}))
    ]
    for word in mechanism.names:
        pattern = re.compile(f"_{re.escape(word)}_".replace(r"\*", "[0-9.]+"))
        assert any(pattern.search(name) for name in named), word


def explained(problem, act: Act, dimensions: dict | None = None) -> dict[str, str]:
    """The lines that `--explain` has of an act, by their first word; each with the line below it."""
    words, size = Vocabulary.of(problem.system), moved_reading.Size(0.1, 0.1, (0.0, 20.0))
    count = sum(value != 0.0 for value in act.coefficients)
    lines = coefficients.lines([act], problem.drivers, words, [[size] * (1 + count)], {}, dimensions or {})
    return {
        line.split()[0]: f"{line.strip()} {below.strip()}" for line, below in zip(lines, [*lines[1:], ""], strict=True)
    }


def with_all(problem, id_: str, nonlinear: dict[str, float]) -> Act:
    """An act of a mechanism all of whose coefficients are at work."""
    return Act(id_, (nonlinear,), (0.1,) * len(mechanisms()[id_].terms(problem.drivers, nonlinear)))


def test_each_coefficient_of_a_radius_that_falls_says_what_it_multiplies(problem) -> None:
    """Five rows said no more than "changes the radius, as a share of it"."""
    shape = {"loaded": 0.0, "steepest": 0.4, "highest_pressure": 0.517}
    sentences = explained(problem, with_all(problem, "radius_compaction", shape), {"radius_mm": (0.428, 0.4)})
    names = [term.name for term in mechanisms()["radius_compaction"].terms(problem.drivers, shape)]
    assert len(names) > 10 and all("; it multiplies " in sentences[name] for name in names)
    assert "minus tan(helix angle) to the power in its name" in sentences["tangent_2"]
    assert sentences["highest_pressure"].startswith("highest_pressure") and " 5.17 N " in sentences["highest_pressure"]
    assert "run.yaml has it as 0.517, in 10 N" in sentences["highest_pressure"]
    assert (
        f"rows 1 to {len(names)} above" in sentences["k"] and "not used here: the load did not vary" in sentences["s"]
    )
    assert "0.428 mm, as adopted (measured 0.4)" in sentences["r"]
    varied = explained(problem, with_all(problem, "radius_compaction", shape | {"loaded": 1.0}))
    assert f"0.1, row {len(names) + 3} above" in varied["s"] and f"rows 1 to {len(names) + 2} above" in varied["k"]
    assert "see run.yaml" in varied["r"]


def test_a_letter_has_the_rows_of_its_own_strengths_alone(problem) -> None:
    """`P_L: rows 1 to 6` and `k: rows 1 to 6` stood above, and only row 6 grew with the tension."""
    shape = {"load_power": 1.0, "work": 5.0, "loaded": 0.0}
    act = with_all(problem, "plastic_elongation", shape)
    sentences, last = explained(problem, act), len(act.coefficients)
    assert f"rows 1 to {last - 1} above" in sentences["P_L"] and f", row {last} above" in sentences["k"]
    two = explained(problem, Act(act.id, act.nonlinear, (*act.coefficients[:2], *(0.0,) * (last - 2))))
    assert "rows 1 and 2 above" in two["P_L"] and "not in this one" in two["k"]


def test_what_usually_heats_says_which_heat_it_is_with_its_unit(problem) -> None:
    """Five numbers without a unit had one sentence: "how much of what heats there usually is"."""
    shape = next(each for each in mechanisms()["thermal"].candidates(problem.drivers) if not each["measured"])
    shape |= {"usual_friction": 2.0, "usual_speed": 3.0}
    sentences = explained(problem, Act("thermal", (shape,), with_all(problem, "thermal", shape).coefficients))
    assert (
        " 20 N turns/s " in sentences["usual_friction"] and "the mean of speed x load, " in sentences["usual_friction"]
    )
    assert "run.yaml has it as 2, in 10 N turns/s" in sentences["usual_friction"]
    assert " 3 turns²/s² " in sentences["usual_speed"] and "speed squared" in sentences["usual_speed"]
    meanings = {sentences[f"usual_{heat}"].partition(" the ")[2] for heat in ("friction", "speed", "current", "torque")}
    assert len(meanings) == 4


def test_of_a_loop_both_ends_of_the_motion_are_not_compared(problem) -> None:
    """A loop closes: `by -0.0706 mm from 0 to 27.2 turns` told nothing of friction."""
    words, moved = Vocabulary.of(problem.system), moved_reading.Size(0.1, 0.1, (0.0, 20.0))
    shape = {"play_turns": 0.04, "usual_load": 2.0}
    (_, loop, *_), (_, jam, *_) = (
        coefficients.lines([act], problem.drivers, words, [[moved, moved]])
        for act in (
            Act("friction_hysteresis", (shape,), (0.42, 0.0)),
            Act("jam", ({"critical_turns": 1.0, "softness_turns": 0.1},), (0.4, 0.0)),
        )
    )
    assert loop.endswith("In all it moves the reading by 0.10 mm rms.")
    assert ", and by +0.100 mm from 0 to 20 turns." in jam


@pytest.mark.parametrize(("id_", "strength"), [("clamp_slip", 0.3), ("count_slip", 0.2)])
def test_an_effect_that_acts_several_times_is_said_once_and_each_time_by_its_own_size(problem, id_, strength) -> None:
    """`worth 0.27 mm rms` stood four times, each with `In all` another size, of one slip; no order of time."""
    words, times_s = Vocabulary.of(problem.system), (20.0, 60.0, 40.0)
    slips = [Act(id_, ({"at_s": at_s, "within_s": 0.0},), (strength,)) for at_s in times_s]
    play = Act("friction_hysteresis", ({"play_turns": 0.04, "usual_load": 2.0},), (0.42, 0.0))
    acts = (slips[0], play, *slips[1:])
    own = sizes(problem, replace(problem.nominal(), acts=acts))
    lines = coefficients.lines(acts, problem.drivers, words, own, {id_: "It slipped, worth 9 mm rms."})
    heads = [line for line in lines if line.startswith(f"  {id_}")]
    of_slip = {slip.nonlinear[0]["at_s"]: size for slip, (size, *_) in zip((*slips,), (own[0], *own[2:]), strict=True)}
    assert heads == [
        f"  {id_}: It slipped, worth 9 mm rms.",
        *(
            f"  {id_}, {place} of 3: This one {moved_reading.moves(of_slip[at_s], words)}."
            for place, at_s in enumerate(sorted(times_s), 1)
        ),
    ]
    assert len({line.partition(": ")[2] for line in heads}) == 4, "three times, three sizes"
    assert [line.split()[1] for line in lines if line.startswith("    at_s ")] == ["20", "40", "60"]
    assert sum("In all it moves" in line for line in lines) == 1, "of the effect that acts once"
