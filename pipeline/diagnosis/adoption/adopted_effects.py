"""What the effects that run.yaml has adopted do in this recording: sizes and sentences, as a verdict gives them."""

from dataclasses import replace
from pathlib import Path

from ...ground.kinematics import Array
from ...run.description import Run
from ..choice.outcome import rms
from ..document.effects_named import AdoptedEffect, Loop, MechanismEntry
from ..document.made_keys import with_made
from ..facts import extents, loops
from ..facts.mechanism_entries import parameters_of
from ..fit.problem import Act, Problem
from ..mechanisms.library import mechanisms
from ..prediction.simulation import of_run, state_of
from ..recording.system_units import Units
from ..words.language.vocabulary import Vocabulary
from ..words.named.effect_sentence import sentence


def adopted_effects(problem: Problem, run: Run, ending: str) -> list[AdoptedEffect]:
    """An entry each: `id`, its `rms` and `top` (`extents.tops`) in the reading's unit `ending`, `sentence`.

    The numbers are held as they were adopted, so that no size has an interval.
    """
    system, entries = problem.system, list[AdoptedEffect]()
    words, units = Vocabulary.of(system), Units.of(system)
    values = state_of(of_run(run), problem, Path("run.yaml"), run.run).values
    mass_kg = {parameter.name: value for parameter, value in zip(problem.parameters, values, strict=True)}.get(
        "mass_kg"
    )
    for act, effect in effects_of(problem, run):
        widest, worth = loops.widest(problem, effect), rms(effect)
        parameters = parameters_of(problem, act, (1.0, 1.0), {}, widest.width / 2 if widest else None)
        entry_without_rms: MechanismEntry = {"id": act.id, "parameters": parameters}
        entry = with_made(entry_without_rms, {f"rms_{ending}": {"value": worth, "low": worth, "high": worth}})
        opened = with_made(Loop(), {f"width_{ending}": widest.width, system.driver: widest.motion}) if widest else None
        by_id = {act.id: effect}
        span, trend = extents.spans(by_id)[act.id], extents.trends(by_id)[act.id]
        says = sentence(mechanisms()[act.id], entry, span, words, units, opened, trend, mass_kg=mass_kg)
        top = extents.tops(by_id, problem.record).get(act.id)
        adopted: AdoptedEffect = {"id": act.id, "sentence": says if worth else ""}
        entries.append(with_made(with_made(adopted, {f"rms_{ending}": worth}, "sentence"), {f"top_{ending}": top}))
    return entries


def effects_of(problem: Problem, run: Run) -> list[tuple[Act, Array]]:
    """Each effect that a run has adopted, all its acts together, with what it does to the reading.

    With the dimensions that were adopted; each of shape (samples,), in the reading's unit.
    """
    adopted = state_of(of_run(run), problem, Path("run.yaml"), run.run)
    acts_by_id: dict[str, list[Act]] = {}
    for act in adopted.acts:
        acts_by_id.setdefault(act.id, []).append(act)
    whole, effects = problem.simulate(adopted), []
    for id_, acts in acts_by_id.items():
        rest = replace(adopted, acts=tuple(act for act in adopted.acts if act.id != id_))
        nonlinear = tuple(each for act in acts for each in act.nonlinear)
        together = Act(id_, nonlinear, tuple(value for act in acts for value in act.coefficients))
        effects.append((together, whole - problem.simulate(rest)))
    return effects
