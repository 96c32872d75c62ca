"""Random numbers: one stream for each thing, so that switching one effect off changes no other."""

import zlib

import numpy as np
from scipy.signal import lfilter

from ...ground.kinematics import Array


def stream(seed: int, *names: object) -> np.random.Generator:
    """Random numbers of one named thing; the same seed and names give the same."""
    return np.random.default_rng([seed, *(zlib.crc32(str(name).encode()) for name in names)])


def wander(rng: np.random.Generator, time_s: Array) -> Array:
    """Strength of an effect over a recording: three slow waves, 1 to 4 % rms, about a mean of 1; (samples,).

    The shape is that of `time_s`, in s; the answer is a factor.
    """
    rms, shares, phases = rng.uniform(0.01, 0.04), rng.uniform(0.4, 1.0, 3), rng.uniform(0.0, 2 * np.pi, 3)
    periods_s = np.exp(rng.uniform(np.log(3.0), np.log(40.0), 3))
    waves = zip(shares, periods_s, phases, strict=True)
    sum_ = np.sum([share * np.sin(2 * np.pi * time_s / period_s + phase) for share, period_s, phase in waves], axis=0)
    return np.asarray(1.0 + rms * (sum_ - sum_.mean()) / sum_.std())


def coloured(rng: np.random.Generator, samples: int, step_s: float, taus_s: Array, shares: Array) -> Array:
    """Noise of unit rms whose parts forget within `taus_s`, 0 for a white one; `shares` of the power; (samples,).

    `taus_s` and `shares` have the shape (parts,): in s, and shares of 1.
    """
    out = np.zeros(samples)
    for tau_s, share in zip(taus_s, shares, strict=True):
        kept = np.exp(-step_s / tau_s) if tau_s > 0 else 0.0
        white = rng.standard_normal(samples)
        white[0] /= np.sqrt(1.0 - kept**2)  # as if it had always been going on
        out += np.sqrt(share) * lfilter([np.sqrt(1.0 - kept**2)], [1.0, -kept], white)
    return np.asarray(out / np.sqrt(np.sum(shares)))


def counted(values: Array, quantum: float) -> Array:
    """Whole numbers of a sensor's quantum, or the values themselves where it is 0.

    Values and quantum in one unit; shape (samples,), the answer as counts.
    """
    return np.rint(values / quantum) * quantum if quantum else np.array(values)
