"""The smallest effect of each kind that a recording would have revealed: what `consistent` is worth."""

import numpy as np

from ..choice.search import LEAST_EFFECT, LEAST_GAIN, Search


def detectable(search: Search, floor: float) -> dict[str, float]:
    """Size (rms, in the channel's unit) by mechanism; a mechanism that the recording cannot show is left out."""
    linear = search.linear
    dimensions = linear.calibration
    needed = LEAST_GAIN + 2.0 * search.penalty
    gram = np.linalg.inv(linear.gram[np.ix_(dimensions, dimensions)])
    calibration = linear.table[dimensions]
    plain = calibration @ calibration.T + np.diag(linear.raw_prior[dimensions])
    size_by_id = {}
    for id_, options in linear.catalogue.items():
        sizes = []
        for number in range(len(options)):
            columns = linear.index[id_, number]
            signals = linear.table[columns]
            norms = np.sqrt(np.sum(np.square(signals), axis=1))
            weights = np.where(norms > 0, 1.0 / np.where(norms > 0, norms, 1.0), 0.0)
            if not weights.any():
                continue
            effect = weights @ signals
            raw = float(effect @ effect)
            cross = linear.gram[np.ix_(dimensions, columns)] @ weights
            seen = float(weights @ linear.gram[np.ix_(columns, columns)] @ weights - cross @ gram @ cross)
            cross = calibration @ effect
            own_energy = raw - float(cross @ np.linalg.solve(plain, cross))
            if seen <= 0 or own_energy <= 0:
                continue
            amplitude = max(np.sqrt(needed / seen), LEAST_EFFECT * floor / np.sqrt(own_energy / linear.rows))
            sizes.append(amplitude * np.sqrt(raw / linear.rows))
        if sizes:
            size_by_id[id_] = float(np.median(sizes))
    return size_by_id
