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
    measured_drive = drive[::fine] + 1e-4 * random.standard_normal(rows)
    return pd.DataFrame({"V1": measured_drive.round(6), "V2": read.round(7)})


def servo(seed: int, rubs_nm: float = 0.0, seconds: float = 24.0) -> dict:
    """A servo's log: it chases a goal with a pendulum on its horn, through a motor that brakes itself."""
    random = np.random.default_rng(seed)
    tick = 2e-4
    clock = np.arange(0.0, seconds, tick)
    goal = 0.9 * np.sin(2.1 * clock + 0.6) + 0.5 * np.sin(3.3 * clock + random.uniform(0.0, 0.5)) + 0.25
    turned, speed, track = float(goal[0]), 0.0, np.empty(len(clock))
    for k in range(len(clock)):
        track[k] = turned
        amps = (15.0 * 32.0 * 0.158 * (goal[k] - turned) - 1.63 * speed) / 2.1
        pull = 1.63 * amps - 0.49 * 9.81 * 0.2 * math.sin(turned) - rubs_nm * math.tanh(speed / 0.01)
        speed += tick * pull / 0.031
        turned += tick * speed
    count = 2.0 * math.pi / 16384
    entries = [
        {"timestamp": float(clock[k]), "goal_position": float(goal[k]), "position": round(track[k] / count) * count}
        for k in range(round(1.0 / tick), len(clock), 50)
    ]
    return {"mass": 0.49, "length": 0.2, "kp": 32, "vin": 15.0, "entries": entries}


def axis(seed: int, coulomb_nm: float = 0.0, viscous_nm_s: float = 0.0, seconds: float = 20.0) -> pd.DataFrame:
    """Time, angle and torque of an upright axis on a finite Fourier path, as identification rides it."""
    random = np.random.default_rng(seed)
    clock = np.arange(0.0, seconds, 0.004)
    place, pace, push = np.zeros(len(clock)), np.zeros(len(clock)), np.zeros(len(clock))
    for cycles, size in ((2, 0.7), (4, 0.3), (7, 0.12), (11, 0.06)):
        turn = 2.0 * math.pi * cycles / seconds
        start = random.uniform(0.0, 6.2)
        place += size * np.sin(turn * clock + start)
        pace += size * turn * np.cos(turn * clock + start)
        push -= size * turn * turn * np.sin(turn * clock + start)
    torque = 31.5 * push + coulomb_nm * np.clip(pace / 0.004, -1.0, 1.0) + viscous_nm_s * pace
    torque += 0.8 * random.standard_normal(len(clock))
    place = np.round(place / 2e-6) * 2e-6
    return pd.DataFrame({"t": clock.round(4), "q1": place, "tau1": torque.round(3)})


def creeping_axis(seed: int, coulomb_nm: float, sticks_nm: float = 0.0, drags_nm_s: float = 0.0) -> pd.DataFrame:
    """Time, angle and torque of an upright axis that strokes fast and creeps; sticking adds to sliding friction."""
    random = np.random.default_rng(seed)
    seconds = 40.0
    clock = np.arange(0.0, seconds, 0.004)
    paces = np.array([1.0, -1.0, 0.5, -0.5, 0.09, -0.09, 0.03, -0.03, 1.0, -1.0, 0.06, -0.06, 0.02, -0.02])
    knots = np.linspace(0.0, seconds, len(paces) + 1)
    commanded_pace = paces[np.minimum(np.searchsorted(knots, clock, "right") - 1, len(paces) - 1)]
    window = np.hanning(101)
    pace = np.convolve(np.pad(commanded_pace, 50, "edge"), window / window.sum(), "valid")
    place = np.cumsum(pace) * 0.004
    grip = coulomb_nm + sticks_nm / (1.0 + (pace / 0.05) ** 2)
    torque = (
        31.5 * np.gradient(pace, clock)
        + grip * np.clip(pace / 0.002, -1.0, 1.0)
        + 0.8 * random.standard_normal(len(clock))
    )
    return pd.DataFrame({"t": clock.round(4), "q1": np.round(place / 2e-6) * 2e-6, "tau1": torque.round(3)})


def sheath(seed: int, grips_mm: float = 0.0, seconds: float = 40.0) -> pd.DataFrame:
    """Pull and tip of a tendon whose sections follow the pull when it has moved by their own grip on the sheath."""
    random = np.random.default_rng(seed)
    clock = np.arange(0.0, seconds, 0.02)
    pull = 14.0 * np.sin(0.55 * clock) + 6.0 * np.sin(0.31 * clock * (1.0 + clock / 90.0)) + 2.0
    parts = np.full((12, len(clock)), pull[0])  # sections that let go one after the other
    for part, grip in zip(parts, grips_mm * np.linspace(0.04, 0.96, 12) ** 1.5, strict=True):
        at = pull[0]
        for k, ahead in enumerate(pull.tolist()):
            if ahead - at > grip:
                at = ahead - grip
            elif at - ahead > grip:
                at = ahead + grip
            part[k] = at
    mean_pull = parts.mean(axis=0)
    tip = mean_pull / 12.3 * 180.0 / math.pi + 31.0 + 0.15 * random.standard_normal(len(clock))
    return pd.DataFrame({"time": clock.round(3), "pull": pull.round(4), "tip": tip.round(3)})


def cylinder(seed: int, seal_n: float = 0.0, seal_n_per_bar: float = 0.0, seconds: float = 30.0) -> pd.DataFrame:
    """Position, pressure and force of a cylinder of 25 mm that a crank moves at three pressures, in SI units."""
    random = np.random.default_rng(seed)
    clock = np.arange(0.0, seconds, 0.005)
    crank = 2.0 * math.pi * np.cumsum(np.interp(clock, [0.0, seconds], [0.25, 0.6])) * 0.005
    place = 0.08 + 0.05 * np.cos(crank) + 0.004 * np.cos(2.0 * crank)
    pace = np.gradient(place, clock)
    pascal = 1e5 * (4.0 + 2.0 * np.sin(0.23 * clock + 1.0) + 0.4 * np.cos(crank + 1.0))
    area_m2 = math.pi * (0.0251 / 2.0) ** 2
    newton = pascal * area_m2 - 0.36 * np.gradient(pace, clock)
    newton -= (seal_n + seal_n_per_bar * pascal / 1e5) * np.tanh(pace / 0.002)
    newton += 0.4 * random.standard_normal(len(clock))
    place = np.round(place / 1e-7) * 1e-7
    return pd.DataFrame({"t": clock.round(4), "x": place, "p": pascal.round(0), "F": newton.round(3)})
