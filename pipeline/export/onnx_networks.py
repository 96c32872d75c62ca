"""The networks as ONNX nodes: chains of coupling blocks, and the pair of MLPs."""

from ..models.parts.networks.secant import FLATTEST, NEAREST, SECANTS, STEEPEST
from .graph import Graph
from .interface import Source
from .onnx_query import Query
from .weights import Blocks, Layer, blocks, layers


def dense(g: Graph, x: str, net: list[Layer], activation: str) -> str:
    """Fully connected layers; the activation is "relu" or "silu", the last layer has none."""
    for number, layer in enumerate(net):
        x = g.add("Gemm", x, layer.weight, layer.bias)
        if number < len(net) - 1:
            x = g.add("Relu", x) if activation == "relu" else g.add("Mul", x, g.add("Sigmoid", x))
    return x


class _Chain:
    """A chain of coupling blocks in a graph, under conditions ("" for none)."""

    def __init__(self, g: Graph, chain: Blocks, conditions: str) -> None:
        self.g, self.chain, self.given = g, chain, conditions
        self.left = list(range(chain.first))
        self.right = list(range(chain.first, chain.first + chain.second))

    def forward(self, x: str) -> str:
        """Blocks forwards (eq. 6)."""
        g = self.g
        for number in range(len(self.chain.net_1)):
            x = x if number == 0 else g.columns(x, self.chain.mixing[number - 1])
            x_1, x_2 = g.columns(x, self.left), g.columns(x, self.right)
            scale, shift = self._moves(self.chain.net_2[number], x_2, self.chain.first)
            y_1 = g.add("Add", g.add("Mul", x_1, scale), shift)
            scale, shift = self._moves(self.chain.net_1[number], y_1, self.chain.second)
            x = g.beside(y_1, g.add("Add", g.add("Mul", x_2, scale), shift))
        return x

    def inverse(self, y: str) -> str:
        """Blocks backwards (eq. 7)."""
        g = self.g
        for number in reversed(range(len(self.chain.net_1))):
            y_1, y_2 = g.columns(y, self.left), g.columns(y, self.right)
            scale, shift = self._moves(self.chain.net_1[number], y_1, self.chain.second)
            x_2 = g.add("Div", g.add("Sub", y_2, shift), scale)
            scale, shift = self._moves(self.chain.net_2[number], x_2, self.chain.first)
            y = g.beside(g.add("Div", g.add("Sub", y_1, shift), scale), x_2)
            y = y if number == 0 else g.columns(y, self.chain.unmixing[number - 1])
        return y

    def _moves(self, net: list[Layer], half: str, size: int) -> tuple[str, str]:
        """exp(s) and t of one half from the other."""
        g = self.g
        out = dense(g, g.beside(half, self.given) if self.given else half, net, "relu")
        bounded = g.add("Mul", g.add("Atan", g.columns(out, range(size))), self.chain.bound)
        return g.add("Exp", bounded), g.columns(out, range(size, 2 * size))


def coupling(query: Query, source: Source) -> str:
    """The answer of the paper's fitted INN."""
    g, model, forward = query.graph, source.model, query.given == "motor_turns"
    mine, other = (model.inputs, model.outputs) if forward else (model.outputs, model.inputs)
    chain = _Chain(g, blocks(model.network), "")
    four = query.paper_conditions(mine.mean[1:], mine.std[1:], model.settings.log_stroke)
    x = g.beside(query.scaled(query.read(query.given), mine.mean[0], mine.std[0]), four)
    y = g.columns(chain.forward(x) if forward else chain.inverse(x), [0])
    return query.restored(y, other.mean[0], other.std[0])


def conditional(query: Query, source: Source) -> str:
    """The fitted conditional INN's answer, over eq. 4."""
    g, model, forward = query.graph, source.model, query.given == "motor_turns"
    mine, other = (model.inputs, model.outputs) if forward else (model.outputs, model.inputs)
    others = query.conditions(source)
    inputs = [*([query.read("direction")] if model.settings.direction else []), *([others] if others else [])]
    chain = _Chain(g, blocks(model.network), g.beside(*inputs) if inputs else "")
    contraction = query.base_mm() if forward else query.read(query.given)
    root = g.add("Sqrt", g.add("Max", g.add("Add", contraction, model.shift_mm), 0.0))
    wanted = query.wide(query.scaled(root, mine.mean[0], mine.std[0]))
    four = query.paper_conditions(mine.mean[1:], mine.std[1:])
    answer = g.columns(chain.forward(g.beside(wanted, four)), [0]) if forward else _secant(chain, wanted, four)
    root = query.restored(answer, other.mean[0], other.std[0])
    value = g.add("Sub", g.add("Mul", root, root), model.shift_mm)
    return value if forward else query.base_turns(value)


def _secant(chain: _Chain, wanted: str, four: str) -> str:
    """The blocks backwards, then `Cinn.inverse`'s steps of the secant."""
    g = chain.g
    reached = g.columns(chain.inverse(g.beside(wanted, four)), [0])
    slope, last, missed = g.constant([[1.0]]), "", ""
    for step in range(SECANTS):
        short = g.add("Sub", wanted, g.columns(chain.forward(g.beside(reached, four)), [0]))
        if step:
            apart = g.add("Sub", reached, last)
            near = g.add("Less", g.add("Abs", apart), NEAREST)
            secant = g.add("Div", g.add("Sub", missed, short), g.add("Where", near, NEAREST, apart))
            slope = g.add("Where", near, slope, g.clipped(secant, FLATTEST, STEEPEST))
        last, missed, reached = reached, short, g.add("Add", reached, g.add("Div", short, slope))
    return reached


def pair_of_mlps(query: Query, source: Source) -> str:
    """The fitted MLP's answer."""
    g, model = query.graph, source.model
    side = 0 if query.given == "motor_turns" else 1
    mine, other = model.scalings[side], model.scalings[1 - side]
    others = query.conditions(source)
    inputs = g.beside(query.read("direction"), *([others] if others else []))
    x = g.beside(
        query.scaled(query.read(query.given), mine.mean[0], mine.std[0]),
        query.paper_conditions(mine.mean[1:5], mine.std[1:5]),
        query.scaled(inputs, mine.mean[None, 5:], mine.std[None, 5:]),
    )
    return query.restored(dense(g, x, layers(model.networks[side]), "silu"), other.mean[0], other.std[0])
