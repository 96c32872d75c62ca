"""Recordings of the rigs of docs/rigs.md by another hand: other formulas, other integrators, no code of the package's.

Each bench integrates at many small plain steps what a text book on that very thing says, in its own units, and turns
it at the end into the columns that the public file of such a rig has.
"""

import math

import numpy as np
import pandas as pd


def tanks(seed: int, rim_cm: float = math.inf, rows: int = 1024, every_s: float = 0.1) -> pd.DataFrame:
    """Columns uEst, yEst of a file without a clock: water in cm over outlets in mm², a sensor of 2.5 cm a volt."""
    random = np.random.default_rng(seed)
    gravity, floor_cm2, outlet_cm2 = 981.0, 4.9, 0.314
    fine = 40
    clock = np.arange(rows * fine) * every_s / fine
    volts = np.full(len(clock), 2.9)
    for cycles, size in ((3, 0.5), (7, 0.9), (11, 1.0), (16, 0.45), (23, 0.25)):
        volts += size * np.cos(2.0 * math.pi * cycles * clock / clock[-1] + random.uniform(0.0, 6.2))
    volts = np.clip(volts, 0.2, None)
    water = [14.0, 13.2]  # cm, above and below
    read = np.empty(len(clock))
    for k, volt in enumerate(volts):
        read[k] = water[1]
        above = outlet_cm2 * math.sqrt(2.0 * gravity * water[0])
        below = outlet_cm2 * 0.98 * math.sqrt(2.0 * gravity * water[1])
        water[0] = max(water[0] + every_s / fine * (19.2 * volt - above) / floor_cm2, 0.0)
        water[1] = min(max(water[1] + every_s / fine * (above - below) / floor_cm2, 0.0), rim_cm)
    level = read[::fine] / 2.5 + 0.02 * random.standard_normal(rows)
    return pd.DataFrame({"uEst": volts[::fine].round(4), "yEst": level.round(4)})


def oscillator(seed: int, hardening: float = 0.0, rows: int = 4000) -> pd.DataFrame:
    """V1, V2 of an oscillator at 610.35 Hz: two integrators in a loop, and a multiplier for the hardening."""
    random = np.random.default_rng(seed)
    every_s, fine = 2.0**14 / 1e7, 24
    step = every_s / fine
    clock = np.arange(rows * fine) * step
    tones = np.arange(3, 330, 3) * 0.21 + random.uniform(0.0, 0.02, 109)  # Hz, up to 69
    drive = np.zeros(len(clock))
    for tone, start in zip(tones, random.uniform(0.0, 2.0 * math.pi, len(tones)), strict=True):
        drive += np.sin(2.0 * math.pi * tone * clock + start)
    drive *= 0.022 / np.std(drive)
    natural, quality, gain = 2.0 * math.pi * 30.0, 9.0, 0.97
    first = second = 0.0  # charges: of the rate over the natural one, and of the output
    output = np.empty(len(clock))

    def current(volt: float, first: float, second: float) -> float:
        return natural * (gain * volt - second - hardening * second * second * second - first / quality)

    for k in range(len(clock)):
        output[k] = second
        half = first + 0.5 * step * current(drive[k], first, second)
        middle = second + 0.5 * step * natural * first
        volt = 0.5 * (drive[k] + drive[min(k + 1, len(clock) - 1)])
        first, second = first + step * current(volt, half, middle), second + step * natural * half
    read = output[::fine] + 5e-6 * random.standard_normal(rows)
    asked = drive[::fine] + 1e-4 * random.standard_normal(rows)
    return pd.DataFrame({"V1": asked.round(6), "V2": read.round(7)})
