"""Between the encoder and the string: play under the feeler gauge, a shaft on the torsion bench, slips."""

import numpy as np

from pipeline.ground.kinematics import Array
from pipeline.rig.authors.workshop.bench import Bench, Law, Part, added
from pipeline.rig.authors.workshop.curves import drawn_curve, eased
from pipeline.rig.authors.workshop.events import strained_instants
from pipeline.rig.authors.workshop.memory import play

WIDEST_TURNS = 3.0


def feeler_gauge(bench: Bench, rng: np.random.Generator) -> Part:
    """Hard play as wide as the feeler gauge that fits."""
    start = float(rng.choice([-1.0, 0.0, 1.0]))
    return Part("twist", "half_play_turns", WIDEST_TURNS, lambda half, now: play(now, half, start), {"start": start})


def stack_of_feelers(bench: Bench, rng: np.random.Generator) -> Part:
    """Contacts of several clearances that take up one after another: play with a soft edge."""
    spread = rng.uniform(0.1, 0.3)
    gauges = 1.0 + spread * np.linspace(-1.0, 1.0, 4)

    def act(half: float, now: Array) -> Array:
        return np.mean([play(now, half * gauge) for gauge in gauges], axis=0)

    return Part("twist", "half_play_turns", WIDEST_TURNS, act, {"spread": spread})


def uneven_teeth(bench: Bench, rng: np.random.Generator) -> Part:
    """Play gauged at eight places of the wheel, not quite the same all round."""
    ratio = rng.uniform(0.02, 0.2)
    gauged = rng.uniform(0.9, 1.1, 8)
    place = (bench.turns * ratio) % 1.0 * 8.0
    wide = np.interp(place, np.arange(9), np.append(gauged, gauged[0]))
    return Part("twist", "half_play_turns", WIDEST_TURNS, lambda half, now: play(now, half * wide), {"ratio": ratio})


def torsion_bench_line(bench: Bench, rng: np.random.Generator) -> Part:
    """The shaft winds up in proportion to the torque."""
    bow = rng.uniform(-0.03, 0.03)
    return added("twist", "windup_turns", WIDEST_TURNS, -bench.torque * (1.0 + bow * bench.torque), bow=bow)


def rubber_jaw_curve(bench: Bench, rng: np.random.Generator) -> Part:
    """A rubber jaw gives easily at first, then stiffens, along the curve on its sheet."""
    bend = rng.uniform(1.5, 4.0)
    return added("twist", "windup_turns", WIDEST_TURNS, -drawn_curve(rng, bend)(bench.torque), bend=bend)


def bottoming_spring(bench: Bench, rng: np.random.Generator) -> Part:
    """A sprung hub turns until its coils bottom, then the bare shaft alone gives."""
    bottom, bare = rng.uniform(0.3, 0.7), rng.uniform(0.1, 0.3)
    give = np.minimum(bench.torque, bottom) + bare * np.maximum(bench.torque - bottom, 0.0)
    return added("twist", "windup_turns", WIDEST_TURNS, -give / give.max(), bottom=bottom, bare=bare)


def _lost(bench: Bench, instants_s: Array, amounts: Array, lasting_s: float) -> Part:
    lost = sum(amount * eased(bench.time_s, at, lasting_s) for amount, at in zip(amounts, instants_s, strict=True))
    numbers = {"instants_s": instants_s.tolist(), "shares": amounts.tolist(), "lasting_s": lasting_s}
    return added("twist", "lost_turns", WIDEST_TURNS, -np.asarray(lost), **numbers)


def sheared_steps(bench: Bench, rng: np.random.Generator) -> Part:
    """Twist is lost at once, once or a few times."""
    instants = strained_instants(bench, rng, int(rng.integers(1, 4)))
    shares = rng.uniform(0.4, 1.0, len(instants))
    return _lost(bench, instants, shares / shares.sum(), 0.0)


def turning_grub_screw(bench: Bench, rng: np.random.Generator) -> Part:
    """The hub turns under its screw, each time within a second."""
    instants = strained_instants(bench, rng, int(rng.integers(1, 4)))
    shares = rng.uniform(0.4, 1.0, len(instants))
    return _lost(bench, instants, shares / shares.sum(), float(rng.uniform(0.2, 0.9)))


def jumping_ratchet(bench: Bench, rng: np.random.Generator) -> Part:
    """A pawl jumps the same tooth in many strokes."""
    instants = strained_instants(bench, rng, int(rng.integers(3, 7)))
    return _lost(bench, instants, np.full(len(instants), 1.0 / len(instants)), 0.0)


BACKLASH: tuple[Law, ...] = (feeler_gauge, stack_of_feelers, uneven_teeth)
WINDUP: tuple[Law, ...] = (torsion_bench_line, rubber_jaw_curve, bottoming_spring)
COUNT_SLIP: tuple[Law, ...] = (sheared_steps, turning_grub_screw, jumping_ratchet)
