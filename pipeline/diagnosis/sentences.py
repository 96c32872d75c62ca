"""A verdict in plain words."""

from typing import Any

from pipeline.diagnosis.outcome import Study
from pipeline.schemas import unit_of
from pipeline.systems import System

LEAVES = 2.5  # sigma by which a dimension must have moved to be measured again


def left_tolerance(found: Study) -> dict[str, float]:
    """Dimensions that calibration moved by more than `LEAVES` sigma, and by how many."""
    shifts = {
        found.problem.parameters[i].name: abs(found.state.values[i] - found.problem.parameters[i].nominal)
        / found.problem.parameters[i].sigma
        for i in found.problem.movable
    }
    return {name: float(shift) for name, shift in shifts.items() if shift > LEAVES}


def sentences(content: dict[str, Any], system: System, moved: dict[str, float]) -> str:
    """A verdict in plain words, a few lines; `moved` names the dimensions that left their tolerance, in sigma."""
    unit, motion = unit_of(system.channel), unit_of(system.driver)
    unit_key = system.channel.rpartition("_")[2]
    run = content["run"] if isinstance(content["run"], str) else ", ".join(content["run"])
    floor = content["fit"][f"noise_floor_{unit_key}"]
    said = {
        "consistent": f"the simulation explains the recording to its noise ({floor:.3g} {unit}).",
        "parameters": "the simulation explains the recording once its measured dimensions move; no physics is missing.",
        "explained": "physics is missing, and named.",
        "ambiguous": "physics is missing; several explanations fit alike.",
        "unknown": "the mismatch is real, and nothing in the library explains it.",
    }[content["verdict"]]
    lines = [f"{run}: {content['verdict']}: {said}"]
    if content["mismatch"] and content["verdict"] != "parameters":
        place, driver = content["mismatch"]["location"], content["mismatch"]["driver"]
        lines.append(
            f"  mismatch {content['mismatch'][f'rms_{unit_key}']:.3g} {unit} rms (noise {floor:.3g}), "
            f"{place['share']:.0%} at "
            f"{place[system.driver][0]:.3g} to {place[system.driver][1]:.3g} {motion}, strokes {place['strokes'][0]}-"
            f"{place['strokes'][1]}, {place['phase']}; it follows {driver}"
        )
    lines += [f"  {entry['id']}: {entry['sentence']}" for entry in content["mechanisms"]]
    own = content.get("of_your_own", {"mechanisms": []})["mechanisms"]
    lines += [f"  but of your own does {entry['id']}: {entry['sentence']}" for entry in own]
    lines += ["  cannot be ruled out: " + " + ".join(other) for other in content["alternatives"]]
    lines += [f"  re-measure {name}: it had to move by {value:.1f} sigma" for name, value in moved.items()]
    if content["next_experiment"]:
        lines.append(f"  next: {content['next_experiment']}")
    held = content["fit"]["heldout"]
    if held:
        lines.append(
            f"  on strokes no fit has seen: nominal {held[f'nominal_{unit_key}']:.3g}, calibrated "
            f"{held[f'calibrated_{unit_key}']:.3g}, explained {held[f'explained_{unit_key}']:.3g} {unit}"
        )
    return "\n".join(lines)
