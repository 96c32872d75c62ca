"""The queries of an ONNX graph: its columns by name, eqs 2 to 5 of them, and whether they lie in range."""

from typing import Any

from ..ground.kinematics import RAD_PER_TURN, Array, loaded_radius
from .graph import Graph
from .inputs import Inputs
from .interface import Source


class Query:
    """One graph and its columns, of shape (points, 1) each; `given` is twist or contraction."""

    def __init__(self, graph: Graph, inputs: Inputs, from_column: str) -> None:
        self.graph, self.inputs, self.given = graph, inputs, from_column
        self.fields = inputs.columns(from_column)
        self.column = {field.name: graph.columns("queries", [at]) for at, field in enumerate(self.fields)}

    def read(self, name: str) -> str:
        """A column, or the constant that is baked in."""
        if name not in self.column:
            self.column[name] = self.graph.constant([[self.inputs.baked.get(name, 0.0)]])
        return self.column[name]

    def scaled(self, value: str, mean: Any, std: Any) -> str:
        """(value − mean) / std."""
        return self.graph.add("Div", self.graph.add("Sub", value, mean), std)

    def restored(self, value: str, mean: float, std: float) -> str:
        """value · std + mean."""
        return self.graph.add("Add", self.graph.add("Mul", value, std), mean)

    def inside(self) -> str:
        """Whether every column lies in its range, whole where it must be; NaN does not."""
        g, truths = self.graph, []
        for field in self.fields:
            column = self.column[field.name]
            truths += [g.add("GreaterOrEqual", column, field.low), g.add("LessOrEqual", column, field.high)]
            if field.whole:
                truths.append(g.add("Equal", column, g.add("Floor", column)))
            if field.name == "direction":
                truths.append(g.add("Not", g.add("Equal", column, 0.0)))
        return g.all(truths)

    def held(self, turns: str, inside: str) -> tuple[str, str]:
        """Twist limited to its range, and whether the query is inside and needed no limiting."""
        g, (low, high) = self.graph, self.inputs.motor_turns
        reached = [g.add("GreaterOrEqual", turns, low), g.add("LessOrEqual", turns, high)]
        return g.clipped(turns, low, high), g.all([inside, *reached])

    def zone_mm(self) -> str:
        """The length that contractions are taken relative to."""
        return self.read("length_mm" if self.inputs.pair else "torsion_zone_mm")

    def base_mm(self) -> str:
        """Contraction by eq. 4, or a pair's, in mm; without the difference of near numbers that eq. 4 has."""
        g, whole = self.graph, self.zone_mm()
        wound = g.add("Mul", self.read("motor_turns"), self._mm_per_turn())
        if self.inputs.pair:
            axial_squared = g.add("Max", g.add("Sub", _square(g, whole), _square(g, wound)), 0.0)
            curve = g.add("Div", _square(g, wound), g.add("Add", whole, g.add("Sqrt", axial_squared)))
            return g.add("Where", g.add("Greater", axial_squared, 0.0), curve, whole)
        wound = g.add("Add", wound, self.read("separator_mm"))
        root = g.add("Sqrt", g.add("Add", _square(g, whole), _square(g, wound)))
        return g.add("Div", _square(g, wound), g.add("Add", root, whole))

    def base_turns(self, contraction_mm: str) -> str:
        """Twist by eq. 5, or a pair's, in turns."""
        g, whole = self.graph, self.zone_mm()
        if self.inputs.pair:
            x = g.add("Min", g.add("Max", contraction_mm, 0.0), whole)
            square = g.add("Mul", x, g.add("Sub", g.add("Mul", whole, 2.0), x))
            return g.add("Div", g.add("Sqrt", square), self._mm_per_turn())
        square = g.add("Mul", contraction_mm, g.add("Add", contraction_mm, g.add("Mul", whole, 2.0)))
        open_mm = g.add("Sqrt", g.add("Max", square, 0.0))
        return g.add("Div", g.add("Sub", open_mm, self.read("separator_mm")), self._mm_per_turn())

    def log_stroke(self) -> str:
        """log(1 + n)."""
        return self.graph.add("Log", self.graph.add("Add", self.read("stroke"), 1.0))

    def paper_conditions(self, mean: Array, std: Array, log_stroke: bool = True) -> str:
        """The scaled conditions b, l, r and n, shape (points, 4).

        Mean and std of shape (4,), in the columns' units; scaled they have none.
        """
        stroke = self.log_stroke() if log_stroke else self.read("stroke")
        names = ("separator_mm", "length_mm", "radius_mm")
        values = [*map(self.read, names), stroke]
        table = [self.scaled(value, m, s) for value, m, s in zip(values, mean, std, strict=True)]
        return self.graph.beside(*(self.wide(column) for column in table))

    def wide(self, column: str) -> str:
        """A column that may be one constant, as one value a point."""
        nothing = self.graph.add("Mul", self.read("stroke"), 0.0)
        return self.graph.add("Add", column, nothing)

    def conditions(self, source: Source) -> str:
        """The conditions' table (`conditions.Conditions.table`), or an empty name where nothing varies."""
        model_conditions = source.model.conditions
        table = [
            self.wide(self.scaled(self.read(name), mean, std))
            for name, mean, std in zip(model_conditions.names, model_conditions.mean, model_conditions.std, strict=True)
        ]
        for number in range(1, len(model_conditions.materials)):
            same = self.graph.add("Equal", self.read("material"), float(number))
            table.append(self.graph.number(same))
        return self.graph.beside(*table) if table else ""

    def _mm_per_turn(self) -> str:
        g, radius = self.graph, self.read("radius_mm")
        names = ("radius_mm", "length_mm", "stiffness_n_per_mm", "load_n")
        if not self.inputs.pair and not set(names) & set(self.inputs.names):
            return g.constant([[RAD_PER_TURN * float(loaded_radius(*(self.inputs.baked[name] for name in names)))]])
        if not self.inputs.pair:
            length, stiffness, load = map(self.read, names[1:])
            stretched = g.add("Add", length, g.add("Div", load, stiffness))
            radius = g.add("Mul", radius, g.add("Sqrt", g.add("Div", length, stretched)))
        return g.add("Mul", radius, RAD_PER_TURN)


def _square(graph: Graph, value: str) -> str:
    return graph.add("Mul", value, value)
