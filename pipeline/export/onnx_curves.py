"""The spline, the polynomials and the analytic models as ONNX nodes, in double precision."""

import numpy as np
from onnx import TensorProto

from ..models.parts.growth import Law
from ..models.spline import MOST
from .graph import Graph
from .interface import Source
from .onnx_query import Query


def analytic(query: Query, source: Source) -> str:
    """The nominal or calibrated analytic model's answer."""
    g = query.graph
    if query.given == "motor_turns":
        return g.add("Add", query.base_mm(), source.zero_mm)
    return query.base_turns(g.add("Sub", query.read("displacement_mm"), source.zero_mm))


def polynomial(query: Query, source: Source) -> str:
    """The fitted ridge regression's answer: the terms in `Polynomial`'s order, times its weights."""
    g, model, from_column = query.graph, source.model, query.given
    s, low, high = model.settings, model.box.low, model.box.high
    within = query.restored(
        query.scaled(query.read(from_column), low[from_column], (high[from_column] - low[from_column]) or 1.0),
        -1.0,
        2.0,
    )
    power = _legendre(g, g.clipped(within, -1.0, 1.0), s.degree)
    first = np.log1p(low["stroke"])
    span = max(np.log1p(high["stroke"]) - first, np.log(2.0))
    grown = _legendre(g, query.restored(query.scaled(query.log_stroke(), first, span), -1.0, 2.0), s.stroke_degree)
    terms = []
    for p in power:
        for growth in grown:
            term = g.add("Mul", p, growth)
            terms += [term, g.add("Mul", term, query.read("direction"))]
    others = query.conditions(source)
    if others:
        terms += [g.add("Mul", p, others) for p in power[: s.other_degree + 1]]
    return g.add("MatMul", g.beside(*map(query.wide, terms)), model.weights[from_column][:, None])


def _legendre(g: Graph, x: str, degree: int) -> list[str]:
    """Legendre polynomials of degree 0 to the given one."""
    values = [g.constant([[1.0]]), x]
    for k in range(1, degree):
        rising = g.add("Mul", g.add("Mul", x, values[k]), (2 * k + 1) / (k + 1))
        values.append(g.add("Sub", rising, g.add("Mul", values[k - 1], k / (k + 1))))
    return values[: degree + 1]


def spline(query: Query, source: Source) -> str:
    """The fitted spline's answer: every point's knots, its bin, and the curve of the bin or its root."""
    g, model, zone = query.graph, source.model, query.zone_mm()
    bins, at = model.settings.bins, model.knots_at
    linear = g.add("MatMul", _features(query, source), model.weights.T)
    start = g.add("Add", g.add("Div", g.columns(linear, [0]), zone), float(at[0]))
    gains = g.add("Exp", g.clipped(g.columns(linear, range(1, 2 * bins + 2)), -MOST, MOST))
    rises = g.add("Mul", g.columns(gains, range(bins)), np.diff(at)[None])
    slopes = g.columns(gains, range(bins, 2 * bins + 1))
    gained = g.beside(query.wide(g.constant([[0.0]])), g.add("CumSum", rises, g.whole(1)))
    values = g.add("Add", gained, start)
    forward = query.given == "motor_turns"
    contraction = g.add("Div", query.base_mm() if forward else query.read("displacement_mm"), zone)
    steps = g.constant(at[None]) if forward else values
    passed = g.number(g.add("GreaterOrEqual", contraction, steps))
    number = g.clipped(g.add("Sub", g.sum(passed), 1.0), 0.0, float(bins - 1))
    curve = _Bin(g, at, g.add("Cast", number, to=TensorProto.INT64), values, rises, slopes)
    if forward:
        return g.add("Mul", curve.value(contraction), zone)
    return query.base_turns(g.add("Mul", curve.root(contraction), zone))


class _Bin:
    """Each point's bin of its own knots: left end, width, rise and slopes, of shape (points, 1)."""

    def __init__(self, g: Graph, at: np.ndarray, number: str, values: str, rises: str, slopes: str) -> None:
        def chosen(table: str, which: str) -> str:
            return g.add("GatherElements", table, which, axis=1)

        after = g.add("Add", number, g.whole([[1]]))
        ends = (g.add("Gather", g.constant(at), which, axis=0) for which in (number, after))
        self.g, (self.at, right_at) = g, ends
        self.width = g.add("Sub", right_at, self.at)
        self.start, self.rise = chosen(values, number), chosen(rises, number)
        self.left, self.right = chosen(slopes, number), chosen(slopes, after)
        self.steep = g.add("Div", self.rise, self.width)
        both = g.add("Add", self.left, self.right)
        self.bend = g.add("Sub", both, g.add("Mul", self.steep, 2.0))

    def value(self, u: str) -> str:
        """The spline at u, going on straight beyond the outer knots."""
        g = self.g
        far = g.add("Div", g.add("Sub", u, self.at), self.width)
        share = g.clipped(far, 0.0, 1.0)
        mixed = g.add("Mul", share, g.add("Sub", g.constant(1.0), share))
        square = g.add("Mul", share, share)
        top = g.add("Add", g.add("Mul", self.steep, square), g.add("Mul", self.left, mixed))
        bottom = g.add("Add", self.steep, g.add("Mul", self.bend, mixed))
        curve = g.add("Add", self.start, g.add("Div", g.add("Mul", self.rise, top), bottom))
        beyond = g.add("Mul", g.add("Sub", far, share), self.width)
        return g.add("Add", curve, g.add("Mul", beyond, self._slope(far)))

    def root(self, y: str) -> str:
        """The u at which the spline is y."""
        g = self.g
        wanted = g.add("Sub", y, self.start)
        up = g.add("Min", g.add("Max", wanted, 0.0), self.rise)
        bend = g.add("Mul", up, self.bend)
        a = g.add("Add", g.add("Mul", self.rise, g.add("Sub", self.steep, self.left)), bend)
        b = g.add("Sub", g.add("Mul", self.rise, self.left), bend)
        c = g.add("Mul", self.steep, up)  # with the sign turned
        square = g.add("Add", g.add("Mul", b, b), g.add("Mul", g.add("Mul", a, c), 4.0))
        root = g.add("Sqrt", g.add("Max", square, 0.0))
        share = g.clipped(g.add("Div", g.add("Mul", c, 2.0), g.add("Add", b, root)), 0.0, 1.0)
        beyond = g.add("Div", g.add("Sub", wanted, up), self._slope(wanted))
        return g.add("Add", g.add("Add", self.at, g.add("Mul", share, self.width)), beyond)

    def _slope(self, side: str) -> str:
        """The slope of the straight line on the side given by a number's sign."""
        return self.g.add("Where", self.g.add("Less", side, 0.0), self.left, self.right)


def _features(query: Query, source: Source) -> str:
    """The inputs of the knots, in `Spline`'s order, shape (points, features)."""
    g, model = query.graph, source.model
    grown = _grown(g, query.read("stroke"), model.law)
    first = g.number(g.add("Equal", query.read("stroke"), 1.0))
    base = g.beside(query.wide(g.constant([[1.0]])), grown, first)
    others = query.conditions(source)
    inputs = [base, *([others, g.add("Mul", others, grown)] if others else [])]
    if model.settings.direction:
        way = query.read("direction")
        inputs += [g.add("Mul", table, way) for table in ([base, others] if others else [base])]
    return g.beside(*inputs)


def _grown(g: Graph, stroke: str, law: Law) -> str:
    """The law of n at each stroke."""
    if law.family == "logarithm":
        raw = g.add("Log", g.add("Add", stroke, law.parameter))
    elif law.family == "power":
        raw = g.add("Pow", stroke, law.parameter)
    else:
        raw = g.add("Neg", g.add("Exp", g.add("Div", stroke, -law.parameter)))
    return g.add("Div", g.add("Sub", raw, law.mean), law.std)
