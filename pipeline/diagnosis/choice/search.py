"""Search for explanations: joint refits of one mechanism, of every pair, of triples; forward, then backward.

Source: Efroymson, Multiple regression analysis, 1960 (forward, backward); Schwarz, Annals of Statistics 6, 1978 (ln n).
"""

from dataclasses import dataclass
from itertools import combinations

import numpy as np

from ..fit.linear import Fit, Key, Linear
from ..mechanisms.library import mechanisms
from ..mechanisms.shared_laws import varied
from .candidates import apart

LEAST_GAIN, EXPLAINED = 10.0, 0.9  # the latter of the mismatch's energy: an explanation must take away more
LEAST_EFFECT = 0.2  # noise floors: smaller imperfections are real everywhere and matter nowhere
LEAST_MORE = 100.0  # gain of a further mechanism, beyond what a discrepancy of the others' formulas can do
MORE_SHARE, MORE_EFFECT = 0.12, (0.2, 0.4)  # its size: of the whole mismatch's rms, within noise floors
INEXACT = 0.035  # of the whole mismatch: what no formula of a real rig gets right, however low the noise
LARGEST = 3  # mechanisms of an explanation
LARGEST_BESIDE_DRAG = 4  # where the reading is a force that moves a mass: drag alone is two or three
PARTNERS = 8  # of the best mechanisms: how many may have a partner
TRIED = 4  # of the best larger explanations
SIGNS_TRIED = 24  # of the best further events, until one has the same sign as those before it


@dataclass(frozen=True)
class Explanation:
    """Mechanisms, each with its candidates; their fit, its cost (misfit and ln n per number) and plain energy."""

    ids: tuple[str, ...]
    keys: tuple[Key, ...]
    fit: Fit
    cost: float
    energy: float


class Search:
    """The explanations on one linearisation, what acts at its state among them; each fitted one is remembered."""

    def __init__(self, linear: Linear, least: float = 0.0) -> None:
        self.linear, self.least = linear, least  # rms that a mechanism must take away at least
        self.largest = LARGEST if linear.problem.drivers.velocity is None else LARGEST_BESIDE_DRAG
        self.penalty = float(np.log(linear.rows))
        self.free = {id_: varied(options) for id_, options in linear.catalogue.items()}
        self.fits: dict[tuple[str, ...], tuple[tuple[Key, ...], Fit]] = {}
        self._explained: dict[tuple[str, ...], Explanation] = {}
        self.nothing = self._explanation((), (), linear.fit(linear.columns_of(())))

    def _cost(self, keys: tuple[Key, ...], fit: Fit) -> float:
        return fit.misfit + self.penalty * (fit.active + sum(self.free[id_] for id_, _ in keys))

    def _explanation(self, ids: tuple[str, ...], keys: tuple[Key, ...], fit: Fit) -> Explanation:
        return Explanation(ids, keys, fit, self._cost(keys, fit), self.linear.plain(fit.columns).energy)

    def _best(self, id_: str, others_keys: tuple[Key, ...]) -> tuple[Key, ...]:
        """The best candidates of a mechanism beside given ones; sudden events are added one by one, all of one sign."""
        chosen: tuple[Key, ...] = ()
        cost = np.inf
        for _ in range(mechanisms()[id_].steps):
            keys = (*others_keys, *chosen)
            misfits, active = self.linear.scan(keys, id_)
            free = sum(self.free[other] for other, _ in keys) + self.free[id_]
            costs = misfits + self.penalty * (active + free)
            costs[self.linear.taken(id_, [number for _, number in chosen])] = np.inf
            for number in np.argsort(costs, kind="stable")[: SIGNS_TRIED if chosen else 1]:
                more = (*chosen, (id_, int(number)))
                if not chosen or costs[number] >= cost - LEAST_GAIN or self._one_sign(others_keys, more):
                    break
            else:
                break
            if costs[number] >= cost - (LEAST_GAIN if chosen else 0.0):
                break
            chosen, cost = more, float(costs[number])
        return chosen

    def _one_sign(self, others_keys: tuple[Key, ...], events: tuple[Key, ...]) -> bool:
        """Whether events of one mechanism all go one way, as what drives them does."""
        fit = self.linear.fit(self.linear.columns_of((*others_keys, *events)))
        signs = np.sign(fit.coefficients[-sum(len(self.linear.index[key]) for key in events) :])
        return bool(np.all(signs >= 0) or np.all(signs <= 0))

    def _fitted(self, ids: tuple[str, ...]) -> tuple[tuple[Key, ...], Fit]:
        """The best candidates of exactly these mechanisms, in the order of their ids, and their fit."""
        if ids in self.fits:
            return self.fits[ids]
        chosen: dict[str, tuple[Key, ...]] = {}
        if len(ids) > 1:
            subsets = [tuple(other for other in ids if other != id_) for id_ in ids]
            best = min(subsets, key=lambda subset: self._cost(*self._fitted(subset)))
            for key in self._fitted(best)[0]:
                chosen[key[0]] = (*chosen.get(key[0], ()), key)
            missing = next(id_ for id_ in ids if id_ not in best)
            order = [missing, *best, missing]
        else:
            order = list(ids)
        for id_ in order:
            others_keys = tuple(key for other, keys in chosen.items() if other != id_ for key in keys)
            if len(self.linear.catalogue[id_]) > 1 or id_ not in chosen:
                chosen[id_] = self._best(id_, others_keys)
        keys = tuple(key for id_ in ids for key in chosen[id_])
        self.fits[ids] = keys, self.linear.fit(self.linear.columns_of(keys))
        return self.fits[ids]

    def explain(self, ids: tuple[str, ...]) -> Explanation:
        """The best explanation by exactly these mechanisms."""
        return self.explained([ids])[0]

    def explained(self, sets: list[tuple[str, ...]]) -> list[Explanation]:
        """The best explanation by exactly the mechanisms of each set; all of them are asked for at once."""
        ordered = [tuple(sorted(ids)) for ids in sets]
        new = [ids for ids in dict.fromkeys(ordered) if ids not in self._explained]
        if new:
            self.linear.gather(np.unique(np.concatenate([self._fitted(ids)[1].columns for ids in new])))
            self._explained |= {ids: self._explanation(ids, *self._fitted(ids)) for ids in new}
        return [self._explained[ids] for ids in ordered]

    @property
    def known(self) -> list[Explanation]:
        """Every explanation that was fitted so far."""
        return self.explained(list(self.fits))

    def all_of(self, size: int) -> list[Explanation]:
        """Explanations of a size, cheapest first: all singles, pairs with a good partner, and so on."""
        ids = [id_ for id_, options in self.linear.catalogue.items() if options]
        sets: list[tuple[str, ...]]
        if size == 1:
            sets = [(id_,) for id_ in ids]
        elif size == 2:
            good = [explanation.ids[0] for explanation in self.all_of(1)[:PARTNERS]]
            acting = set(self.linear.acting)  # a step after the other, the search could lead past them
            sets = [pair for pair in combinations(ids, 2) if set(pair) & set(good) or set(pair) <= acting]
        else:
            good_sets = [*(good.ids for good in self.all_of(size - 1)[:2]), *combinations(self.linear.acting, size - 1)]
            sets = sorted({tuple(sorted({*chosen, id_})) for chosen in good_sets for id_ in ids if id_ not in chosen})
        return sorted(self.explained([ids for ids in sets if apart(ids)]), key=lambda explanation: explanation.cost)

    def leaders(self, chosen: Explanation) -> list[Explanation]:
        """The chosen explanation, and the others of its size that come close to it."""
        alike = self.all_of(len(chosen.ids))
        near = [*alike[:3], *sorted(alike, key=lambda explanation: explanation.energy)[:3]]
        half = 0.5 * (self.nothing.energy + chosen.energy)
        others = {
            explanation.ids: explanation
            for explanation in near
            if explanation.ids != chosen.ids and explanation.energy < half
        }
        return [chosen, *others.values()]

    def with_discrepancy(self, explanation: Explanation) -> Explanation:
        """An explanation whose formulas may be wrong by a little, as smooth functions of the drivers."""
        deviations = [self.linear.deviations[id_] for id_ in explanation.ids if id_ in self.linear.deviations]
        columns = np.concatenate([self.linear.columns_of(explanation.keys), *deviations]).astype(int)
        fit = self.linear.fit(columns)
        active = explanation.fit.active
        cost = fit.misfit + self.penalty * (active + sum(self.free[id_] for id_, _ in explanation.keys))
        return Explanation(explanation.ids, explanation.keys, fit, cost, self.linear.plain(columns).energy)

    def more(self, small: Explanation, large: Explanation, floor: float) -> bool:
        """Whether a larger explanation has physics that a discrepancy of the smaller one's formulas cannot replace."""
        if not small.ids:
            enough = small.energy - large.energy >= max(LEAST_EFFECT * floor, self.least) ** 2
            return large.cost <= small.cost - LEAST_GAIN and enough
        if small.energy - large.energy < self.least_energy(floor):
            return False
        return self.with_discrepancy(large).cost <= self.with_discrepancy(small).cost - LEAST_MORE

    def least_energy(self, floor: float) -> float:
        """Energy that a further mechanism must take away to count."""
        mismatch = self.mismatch(floor)
        needed = float(np.clip(MORE_SHARE * mismatch, MORE_EFFECT[0] * floor, MORE_EFFECT[1] * floor))
        return max(needed, INEXACT * mismatch, self.least) ** 2

    def mismatch(self, floor: float) -> float:
        """What calibration alone leaves, noise taken off, rms."""
        return float(np.sqrt(max(self.nothing.energy - floor**2, 0.0)))

    def forward(self, floor: float, largest: int | None = None) -> Explanation:
        """The smallest explanation that no larger one beats by enough, in likelihood and in size."""
        chosen = self.nothing
        for size in range(1, (largest or self.largest) + 1):
            larger = self.all_of(size)
            if not larger:
                break
            best = next((explanation for explanation in larger[:TRIED] if self.more(chosen, explanation, floor)), None)
            if best is None:
                break
            chosen = best
        return chosen

    def select(self, floor: float, largest: int | None = None) -> Explanation:
        """The explanation that `forward` chooses, without a mechanism that turns out not to be needed."""
        chosen = self.forward(floor, largest)
        for id_ in chosen.ids if len(chosen.ids) > 1 else ():
            smaller = self.explain(tuple(other for other in chosen.ids if other != id_))
            if not self.more(smaller, chosen, floor):
                return smaller
        return chosen
