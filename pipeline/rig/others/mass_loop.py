"""A carriage on a screw in closed loop, stepped in time: the controller's command and the carriage's place."""

import math
from typing import NamedTuple

import numpy as np

from ...ground.kinematics import Array
from ..effect import compiled

FINE = 10  # steps of the carriage in one of the controller


class Plant(NamedTuple):
    """The carriage, its effects and its encoder; an effect that is off has size 0."""

    mass_kg: float
    viscous: float  # N at 0.1 m/s
    viscous_power: float
    coulomb_n: float
    stiction: float  # of the Coulomb friction, more at rest
    stribeck_m_per_s: float
    bristle_m: float  # how far the friction's bristles bend
    rail_n: float
    rail_from_m: float
    rail_reach_m: float
    rail_power: float
    rail_bristle_m: float
    cogging_n: float
    pitch_m: float
    cogging_rad: float
    second: float  # harmonic of the cogging, as a share
    lag_s: float  # of the encoder: dead time and pole
    dead_share: float
    quantum_m: float
    force_quantum_n: float


class Controller(NamedTuple):
    """Position and speed loop: force = gain · (place · (reference − position) + reference speed − speed)."""

    gain_n_s_per_m: float = 6000.0
    place_per_s: float = 30.0
    filter_s: float = 0.003  # of the speed, which is the encoder's difference


@compiled
def ride(
    plant: Plant, control: Controller, reference: Array, strength: Array, outside_n: Array, step_s: float
) -> tuple[Array, Array]:
    """Ride the reference; logged values (6, samples): position m, late position m, encoder m, command N, and the
    true speed m/s and acceleration m/s²; and forces (4, samples) in N that viscous friction, friction, the rail and
    the cogging take. All are of the middle of the time for which a command holds.

    `reference` (2, samples) is position and speed, `strength` (4, samples) of those effects, `outside_n` (samples,)
    what else is against the motor. Each row of those has the shape (samples,).
    """
    samples = reference.shape[1]
    log, forces = np.zeros((6, samples)), np.zeros((4, samples))
    fine_s = step_s / FINE
    dead_steps = math.ceil(plant.lag_s * plant.dead_share / fine_s)
    line = np.zeros(dead_steps + 1)
    pole_s = plant.lag_s * (1.0 - plant.dead_share)
    share = 1.0 - math.exp(-fine_s / pole_s) if pole_s > 0.0 else 1.0
    at_m = speed = late_m = bristle = rail_bristle = read_before = speed_read = 0.0
    slot = 0
    keep = math.exp(-step_s / control.filter_s)
    for k in range(samples):
        read_m = late_m
        if plant.quantum_m > 0.0:
            read_m = round(late_m / plant.quantum_m) * plant.quantum_m
        speed_read = keep * speed_read + (1.0 - keep) * (read_m - read_before) / step_s
        read_before = read_m
        speed_wanted = control.place_per_s * (reference[0, k] - read_m) + reference[1, k] - speed_read
        command_n = control.gain_n_s_per_m * speed_wanted
        if plant.force_quantum_n > 0.0:
            command_n = round(command_n / plant.force_quantum_n) * plant.force_quantum_n
        log[3, k] = command_n
        for fine in range(FINE):
            quick = abs(speed)
            viscous_n = strength[0, k] * plant.viscous * math.copysign((10.0 * quick) ** plant.viscous_power, speed)
            limit = 1.0 + plant.stiction * math.exp(-((quick / plant.stribeck_m_per_s) ** 2))
            bristle = _bent(bristle, speed, limit, plant.bristle_m, fine_s)
            friction_n = strength[1, k] * plant.coulomb_n * bristle
            tight = max((at_m - plant.rail_from_m) / plant.rail_reach_m, 0.0) ** plant.rail_power
            rail_bristle = _bent(rail_bristle, speed, 1.0, plant.rail_bristle_m, fine_s)
            rail_n = strength[2, k] * plant.rail_n * tight * rail_bristle
            turn = 2.0 * math.pi * at_m / plant.pitch_m + plant.cogging_rad
            cogging_n = strength[3, k] * plant.cogging_n * (math.sin(turn) + plant.second * math.sin(2.0 * turn + 1.0))
            against_n = viscous_n + friction_n + rail_n + cogging_n + outside_n[k]
            pulled = (command_n - against_n) / plant.mass_kg
            if fine == FINE // 2:  # a command holds on to the next: any other moment would make the encoder late
                log[0, k], log[1, k], log[2, k], log[4, k], log[5, k] = at_m, late_m, late_m, speed, pulled
                if plant.quantum_m > 0.0:
                    log[2, k] = round(late_m / plant.quantum_m) * plant.quantum_m
                forces[0, k], forces[1, k], forces[2, k], forces[3, k] = viscous_n, friction_n, rail_n, cogging_n
            speed += pulled * fine_s
            at_m += speed * fine_s
            line[slot] = at_m
            slot = (slot + 1) % (dead_steps + 1)
            late_m += (line[slot] - late_m) * share
    return log, forces


@compiled
def _bent(bristle: float, speed: float, limit: float, reach_m: float, step_s: float) -> float:
    """Bristles after a step, −limit … limit: they follow the carriage and let go the more the further they bend."""
    towards = math.copysign(limit, speed)
    return towards + (bristle - towards) * math.exp(-abs(speed) * step_s / (reach_m * limit))
