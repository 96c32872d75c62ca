"""A program of motion on the wire, and its check against a device's limits, by arithmetic that a person can follow."""

import struct
import zlib
from dataclasses import replace

import pytest

from pipeline.wire.motion import (
    AS_IT_HANGS,
    FURTHEST,
    LONGEST_MS,
    MOST_LEGS,
    PROGRAM,
    TAKEN,
    Answer,
    Leg,
    Limits,
    cruise,
    packed,
    refusal,
)

LIMITS = Limits(3, (-1.0, 20.0), 2.0, 4.0, 60.0, 1.0, 0.0, (5.0, 40.0))
WORDS = {
    "legs": 3, "turns": (-1.0, 20.0), "turns_per_s": 2.0, "turns_per_s2": 4.0, "seconds": 60.0, "silence_s": 1.0,
    "at_turns": 0.0, "load_n": (5.0, 40.0),
}  # fmt: skip


def test_the_numbers_of_the_protocol_are_those_of_its_page():
    """docs/protocol.md has them, and firmware in C is written by it."""
    assert [answer.value for answer in Answer] == list(range(9))
    assert [answer.name for answer in Answer][1:] == [
        "BROKEN", "LEGS", "TURNS", "SPEED", "ACCELERATION", "LOAD", "SECONDS", "BUSY",
    ]  # fmt: skip
    assert (MOST_LEGS, LONGEST_MS, FURTHEST, AS_IT_HANGS) == (4096, 4_294_967_295, 2_000_000.0, -2_147_483_648)
    assert (PROGRAM.size, TAKEN.size) == (6, 9)


@pytest.mark.parametrize("leg", [Leg(2.5, 10.25, 20.5), Leg(0.001, -3.0), Leg(60.0, 0.0, 0.0), Leg(0.25, -0.5, -1.5)])
def test_a_leg_comes_back_from_its_bytes(leg):
    load = AS_IT_HANGS if leg.load_n is None else round(1000 * leg.load_n)
    assert leg.pack(7) == struct.pack("<HIii", 7, round(1000 * leg.seconds), round(1000 * leg.turns), load)
    assert Leg.unpack(leg.pack(7)) == leg


def test_what_does_not_fit_the_numbers_of_the_protocol_is_refused_by_the_leg():
    longest, furthest = LONGEST_MS / 1000, 2.0e6
    for leg in (Leg(longest, furthest, -furthest), Leg(1e-6, -furthest)):
        assert Leg.unpack(leg.pack(0)).turns == leg.turns
    assert Leg.unpack(Leg(1e-6, 0.0).pack(0)).seconds == 0.001, "a way of no time takes the shortest"
    for leg in (Leg(0.0, 1.0), Leg(longest + 0.001, 1.0), Leg(1.0, furthest + 1.0), Leg(1.0, 0.0, -furthest - 1.0)):
        with pytest.raises(ValueError, match=r"^leg 5: cannot be written"):
            leg.pack(4)


def test_a_programs_check_is_over_all_its_legs_in_order():
    legs = [Leg(1.0, 2.0), Leg(2.0, 0.0, 10.0)]
    payloads, check = packed(legs)
    assert payloads == [leg.pack(number) for number, leg in enumerate(legs)]
    assert check == zlib.crc32(payloads[0] + payloads[1])


def test_limits_come_from_a_hello_and_go_back_into_one():
    assert Limits.of(WORDS) == LIMITS and LIMITS.content == WORDS
    fixed = replace(LIMITS, load_n=None)
    assert Limits.of({key: value for key, value in WORDS.items() if key != "load_n"}) == fixed
    assert "load_n" not in fixed.content


@pytest.mark.parametrize(
    ("key", "good", "bad"),
    [
        ("legs", [1, 4096], [0, 4097, True, "3", None]),
        ("turns", [[0, 0], [-2e6, 2e6]], [[1, 0], [0], [0, 1, 2], [0, 2_000_001], 3, None]),
        ("turns_per_s", [0.001, 2e6], [0, -1, 2_000_001]),
        ("turns_per_s2", [0.001, 2e6], [0, -1, 2_000_001]),
        ("seconds", [0.001, LONGEST_MS / 1000], [0, -1, LONGEST_MS / 1000 + 1]),
        ("silence_s", [0.001, 60], [0, -1, 60.1]),
        ("at_turns", [-2e6, 2e6], [-2_000_001, 2_000_001]),
        ("load_n", [[20, 20], [-2e6, 2e6], None], [[1, 0], [0, 2_000_001], 20]),
    ],
)
def test_each_limit_has_ends_of_its_own(key, good, bad):
    for value in good:
        own = Limits.of({**WORDS, key: value}).content.get(key)
        assert (list(own) if isinstance(own, tuple) else own) == value
    for value in bad:
        with pytest.raises(ValueError, match=f"^program.*{key}"):
            Limits.of({**WORDS, key: value})


def test_a_way_takes_the_time_of_its_ramps_and_of_full_speed_between_them():
    """At 2 turns/s and 4 turns/s2 the ramps take 0.5 s and half a turn each."""
    assert LIMITS.way_s(0.0) == 0.0
    assert LIMITS.way_s(0.25) == LIMITS.way_s(-0.25) == pytest.approx(0.5), "a quarter: 0.125 turns up, as many down"
    assert LIMITS.way_s(1.0) == pytest.approx(1.0), "two ramps"
    assert LIMITS.way_s(5.0) == pytest.approx(1.0 + 4.0 / 2.0), "two ramps, and four turns between them"
    quick = replace(LIMITS, turns_per_s2=0.5)
    assert quick.way_s(8.0) == pytest.approx(8.0) and quick.way_s(2.0) == pytest.approx(4.0)


def test_the_speed_between_the_ramps_is_what_fills_the_time():
    assert cruise(5.0, 3.0, 4.0) == cruise(-5.0, 3.0, 4.0) == pytest.approx(2.0)
    assert cruise(1.0, 1.0, 4.0) == pytest.approx(2.0), "nothing is left between them"
    assert cruise(1.0, 0.99, 4.0) is None and cruise(0.0, 1.0, 4.0) == 0.0


@pytest.mark.parametrize(
    ("legs", "reason", "number", "words"),
    [
        ([], Answer.LEGS, 0, "it has 0 legs, and the device takes 1 to 3"),
        ([Leg(5.0, 1.0)] * 4, Answer.LEGS, 0, "it has 4 legs, and the device takes 1 to 3"),
        ([Leg(20.0, 20.1)], Answer.TURNS, 1, "goes to 20.1 turns, and the rig goes from -1 to 20"),
        ([Leg(5.0, 1.0), Leg(5.0, -1.1)], Answer.TURNS, 2, "goes to -1.1 turns, and the rig goes from -1 to 20"),
        ([Leg(5.0, 1.0, 4.9)], Answer.LOAD, 1, "asks for 4.9 N, and the rig hangs 5 to 40 N"),
        ([Leg(5.0, 1.0, 40.1)], Answer.LOAD, 1, "asks for 40.1 N, and the rig hangs 5 to 40 N"),
        ([Leg(0.99, 1.0)], Answer.ACCELERATION, 1, "ramps of 4 turns/s2 do not go 1 turns in 0.99 s"),
        ([Leg(3.0, 5.0), Leg(2.9, 0.0)], Answer.SPEED, 2, "needs 2.107 turns/s, and the rig makes 2"),
        ([Leg(30.0, 1.0), Leg(30.1, 0.0)], Answer.SECONDS, 0, "it takes 60.1 s, and the device takes 60 s"),
    ],
)
def test_a_program_beyond_a_limit_is_refused_by_leg_and_reason(legs, reason, number, words):
    assert refusal(legs, LIMITS) == (reason, number, words)


def test_a_program_at_its_limits_is_taken():
    assert refusal([Leg(3.0, 5.0, 5.0), Leg(3.0, 0.0, 40.0), Leg(54.0, -1.0)], LIMITS) is None
    assert refusal([Leg(10.5, 20.0)], LIMITS) is None
    assert refusal([Leg(3.0, 12.0)], replace(LIMITS, at_turns=7.0)) is None, "from where it stands"


def test_a_rig_of_one_load_says_which_or_that_it_cannot_change_it():
    one_load = replace(LIMITS, load_n=(20.0, 20.0))
    assert refusal([Leg(5.0, 1.0, 20.0)], one_load) is None
    assert refusal([Leg(5.0, 1.0, 21.0)], one_load) == (Answer.LOAD, 1, "asks for 21 N, and the rig hangs 20 N")
    fixed = replace(LIMITS, load_n=None)
    assert refusal([Leg(5.0, 1.0)], fixed) is None
    assert refusal([Leg(5.0, 1.0, 20.0)], fixed) == (
        Answer.LOAD, 1, "asks for 20 N, and the rig cannot change its load",
    )  # fmt: skip
