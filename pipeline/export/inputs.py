"""The inputs of an exported model: its fields, the range of each, and constants, which are fixed in the export."""

from dataclasses import dataclass, field

import numpy as np
import pandas as pd

from ..ground.kinematics import RAD_PER_TURN, Array, usual_stiffness
from ..ground.units import unit_of
from ..models.parts.box import ROUNDED, Box
from ..models.parts.conditions import MEASURED, VARIES

SAME = 1e-6  # spread over size below which a dimension is one number
WIDE = 8.0 * VARIES  # range over size of a load that is more than its cell's noise (four sigmas each way)
BEYOND = 2  # times the last training stroke: an actuator is used longer than it was trained, by its law of n
ANSWER = {"motor_turns": "displacement_mm", "displacement_mm": "motor_turns"}
MEANING = {
    "stroke": "number of the stroke, the first is 1",
    "direction": "+1 while winding, -1 while unwinding",
    "load_n": "pull on the string",
    "separator_mm": "width of the separator, b",
    "length_mm": "length of the untwisted string, L",
    "radius_mm": "radius of the string, r",
    "torsion_zone_mm": "length of the torsion zone, d",
    "stiffness_n_per_mm": "stiffness of the string, K",
    "material": "number of the material",
}


@dataclass(frozen=True)
class Field:
    """One number that a caller gives: its name, unit and inclusive range; `whole` where only whole numbers are."""

    name: str
    low: float
    high: float
    whole: bool = False

    @property
    def unit(self) -> str:
        """Its unit, "1" for a number without."""
        return unit_of(self.name)


@dataclass(frozen=True)
class Inputs:
    """Fields beside twist or contraction, the ranges of these two, and the constants of all training points."""

    motor_turns: tuple[float, float]
    displacement_mm: tuple[float, float]
    fields: tuple[Field, ...]  # stroke, direction, what varies, material
    baked: dict[str, float]  # measured columns that are constant
    materials: tuple[str, ...]
    last_stroke: int  # of the training points
    unread: dict[str, tuple[float, float]] = field(default_factory=dict)  # ranges of what varied and is not read
    never_measured: bool = False  # the stiffness of any string, by a dataset; unknown without one

    @classmethod
    def of(cls, box: Box, reads: tuple[str, ...], conditions: tuple[str, ...], materials: tuple[str, ...]) -> "Inputs":
        """The inputs of a model that reads measured columns, some of them as conditions, trained within a box.

        Materials are empty where the model does not tell them apart. Raises ValueError for points of strings with
        and without separator in one model.
        """
        fields, baked, unread = [], {}, {}
        for name in MEASURED:
            if name not in box.low:
                if name in conditions:
                    raise ValueError("strings with and without separator in one model")
                continue
            low, high = box.low[name], box.high[name]
            varies = high - low > (WIDE if name == "load_n" else SAME) * max(abs(low), abs(high))
            if name in conditions or (name in reads and varies):
                fields.append(Field(name, low, high))
            else:
                baked[name] = (low + high) / 2.0
                if varies:
                    unread[name] = low, high
        new, last = round(box.low["stroke"]), round(box.high["stroke"])
        ways = [way for way in (-1, 1) if box.low["direction"] <= way <= box.high["direction"]]
        first = [Field("stroke", new, BEYOND * last, True), Field("direction", ways[0], ways[-1], True)]
        if materials:
            fields.append(Field("material", 0, len(materials) - 1, True))
        return cls(
            (max(box.low["motor_turns"], _least_turns(box)), box.high["motor_turns"]),
            (box.low["displacement_mm"], box.high["displacement_mm"]),
            (*first, *fields),
            baked,
            materials,
            last,
            unread,
        )

    @property
    def assumed(self) -> dict[str, str]:
        """Numbers that nobody measured, and their origin, such as a usual stiffness: of one length, of each radius.

        Of several lengths a dataset alone says whether it was measured.
        """
        ranges = {name: (value, value) for name, value in self.baked.items()}
        ranges |= {field.name: (field.low, field.high) for field in self.fields}
        if self.never_measured and "length_mm" not in self.baked and "stiffness_n_per_mm" in ranges:
            return {"stiffness_n_per_mm": "assumed, not measured: the usual one of each radius_mm and length_mm"}
        if "length_mm" not in self.baked or not {"radius_mm", "stiffness_n_per_mm"} <= set(ranges):
            return {}
        usual = [usual_stiffness(radius_mm, self.baked["length_mm"]) for radius_mm in ranges["radius_mm"]]
        is_field = "stiffness_n_per_mm" not in self.baked
        near = 4.0 * ROUNDED if is_field else SAME  # the ends of a field have room
        if not np.allclose(ranges["stiffness_n_per_mm"], usual, rtol=near, atol=0.0):
            return {}
        whose = "of each radius_mm and this" if is_field else "of this radius_mm and"
        return {"stiffness_n_per_mm": f"assumed, not measured: the usual one {whose} length_mm"}

    @property
    def pair(self) -> bool:
        """Whether the strings are twisted pairs, without separator."""
        return not self._known("torsion_zone_mm")

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the fields, in their order."""
        return tuple(field.name for field in self.fields)

    def columns(self, from_column: str) -> tuple[Field, ...]:
        """The columns of a query: twist or contraction, as `from_column` says, then the fields."""
        return (Field(from_column, *getattr(self, from_column)), *self.fields)

    def points(self, from_column: str, queries: Array) -> pd.DataFrame:
        """Queries of shape (points, columns) as the Python model's points, with the constants and without an answer.

        Each column in its field's unit.
        """
        names = [field.name for field in self.columns(from_column)]
        points = pd.DataFrame(dict(zip(names, np.asarray(queries, float).T, strict=True)))
        points = points.assign(
            **{ANSWER[from_column]: np.nan, "actuator": "twisted_pair" if self.pair else "separator"}
        )
        points = points.assign(**{name: self.baked.get(name, np.nan) for name in MEASURED if name not in points})
        if self.materials:
            points["material"] = np.array(self.materials)[points["material"].astype(int)]
        return points.assign(string="exported", **{name: points[name].astype(int) for name in ("stroke", "direction")})

    def drawn(self, from_column: str, count: int, rng: np.random.Generator) -> Array:
        """Queries drawn evenly over every field's whole range, shape (count, columns), each in its field's unit."""
        return np.column_stack(
            [
                _whole(field, rng, count) if field.whole else rng.uniform(field.low, field.high, count)
                for field in self.columns(from_column)
            ]
        )

    def _known(self, name: str) -> bool:
        return name in self.baked or name in self.names


def _whole(field: Field, rng: np.random.Generator, count: int) -> Array:
    """Whole numbers of a field; a direction is never 0."""
    step = 2 if field.name == "direction" else 1
    return rng.choice(np.arange(field.low, field.high + 1, step), count).astype(float)


def _least_turns(box: Box) -> float:
    """The twist below which the string would wind the other way round: the analytic curve's lowest point."""
    if "separator_mm" not in box.low:
        return 0.0
    return -box.low["separator_mm"] / (RAD_PER_TURN * box.high["radius_mm"])
