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
