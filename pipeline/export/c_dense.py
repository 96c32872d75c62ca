"""Fully connected layers in C that a compiler turns into vector instructions, and the pair of MLPs made of them."""

import numpy as np

from .c_physics import paper_conditions, standardised
from .c_text import Body, function, real
from .interface import Source
from .weights import Layer, Weights, layers

LANES = 16  # a vector's numbers at most; hidden layers are padded to a multiple of it, with weights of 0

LAYER = """\
static inline void {name}(const float weight[{inputs}][{outputs}], const float *bias, const tsa_real *x, tsa_real *y)
{{
    tsa_real sum[{outputs}];
    int i, j;
    for (j = 0; j < {outputs}; ++j) {{
        sum[j] = (tsa_real)bias[j];
    }}
{loop}    for (j = 0; j < {outputs}; ++j) {{
        y[j] = {result};
    }}
}}

"""
DENSE = """\
    for (i = 0; i < {inputs}; ++i) {{
        for (j = 0; j < {outputs}; ++j) {{
            sum[j] += (tsa_real)weight[i][j] * x[i];
        }}
    }}
"""
BY_FOUR = """\
    /* Four rows at a time: the sums stay in registers. */
    for (i = 0; i < {inputs}; i += 4) {{
        const float *w0 = weight[i], *w1 = weight[i + 1], *w2 = weight[i + 2], *w3 = weight[i + 3];
        const tsa_real x0 = x[i], x1 = x[i + 1], x2 = x[i + 2], x3 = x[i + 3];
        for (j = 0; j < {outputs}; ++j) {{
            sum[j] += ((tsa_real)w0[j] * x0 + (tsa_real)w1[j] * x1) + ((tsa_real)w2[j] * x2 + (tsa_real)w3[j] * x3);
        }}
    }}
"""
FEW = """\
/* Few outputs, each a sum over many inputs: products first, then halves are added, in loops that become vectors. */
static inline void {name}(const float weight[{outputs}][{inputs}], const float *bias, const tsa_real *x, tsa_real *y)
{{
    int i, j;
    for (j = 0; j < {outputs}; ++j) {{
        tsa_real part[{room}] = {{0}};
        for (i = 0; i < {inputs}; ++i) {{
            part[i] = (tsa_real)weight[j][i] * x[i];
        }}
{halves}        y[j] = (tsa_real)bias[j] + {total};
    }}
}}

"""
HALVES = """\
        for (i = 0; i < {half}; ++i) {{
            part[i] += part[{half} + i];
        }}
"""
RESULTS = {"relu": "sum[j] > 0 ? sum[j] : 0", "silu": "sum[j] / (1 + tsa_exp(-sum[j]))", "linear": "sum[j]"}


def padded(size: int) -> int:
    """The size, rounded up to whole lanes."""
    return -(-size // LANES) * LANES


class Net:
    """Equally shaped nets in C under one name: `<name>(number, x, y)` maps x to y for net `number`."""

    def __init__(self, body: Body, name: str, nets: list[list[Layer]], activation: str) -> None:
        self.body, self.name, self.activation = body, name, activation
        last, lines, code = len(nets[0]) - 1, [], ""
        self.rooms = [nets[0][0].weight.shape[0]]  # of x, the hidden layers and y
        for number in range(last + 1):
            code += self._layer(number, [net[number] for net in nets], "linear" if number == last else activation)
            layer_input, result = "x" if number == 0 else f"h{number - 1}", "y" if number == last else f"h{number}"
            arrays = f"{name}_weight_{number}[number], {name}_bias_{number}[number]"
            lines.append(f"{name}_layer_{number}({arrays}, {layer_input}, {result});")
        hidden = ", ".join(f"h{number}[{size}]" for number, size in enumerate(self.rooms[1:-1]))
        head = f"{name}(int number, const tsa_real *x, tsa_real *y)"
        body.code += "\n" + code + function("void", head, f"tsa_real {hidden};", *lines)
        self.room = self.rooms[-1]

    def _layer(self, number: int, layers: list[Layer], kind: str) -> str:
        """Add the arrays of a layer of every net, and return its function."""
        rows, outputs, name = self.rooms[-1], len(layers[0].bias), f"{self.name}_layer_{number}"
        if number > 0 and kind == "linear" and outputs < LANES:
            self._arrays(number, [layer.weight.T for layer in layers], layers, (outputs, rows), outputs)
            self.rooms.append(outputs)
            room = 1 << (rows - 1).bit_length()
            halves = [HALVES.format(half=room >> fold) for fold in range(1, (room // LANES).bit_length())]
            sizes = {"inputs": rows, "outputs": outputs, "room": room, "total": _total(0, LANES)}
            return FEW.format(name=name, halves="".join(halves), **sizes)
        wide = padded(outputs)
        self._arrays(number, [layer.weight for layer in layers], layers, (rows, wide), wide)
        self.rooms.append(wide)
        loop = (BY_FOUR if number > 0 else DENSE).format(inputs=rows, outputs=wide)
        return LAYER.format(name=name, loop=loop, result=RESULTS[kind], inputs=rows, outputs=wide)

    def _arrays(
        self, number: int, weights: list[Weights], layers: list[Layer], shape: tuple[int, int], outputs: int
    ) -> None:
        biases = [_padded(layer.bias, (outputs,)) for layer in layers]
        self.body.array(f"{self.name}_weight_{number}", np.stack([_padded(w, shape) for w in weights]), "float")
        self.body.array(f"{self.name}_bias_{number}", np.stack(biases), "float")


def _total(first: int, count: int) -> str:
    """The sum of so many parts as an expression, in pairs: a running sum would wait for itself at every step."""
    if count == 1:
        return f"part[{first}]"
    return f"({_total(first, count // 2)} + {_total(first + count // 2, count // 2)})"


def _padded(table: Weights, shape: tuple[int, ...]) -> Weights:
    """A table with zeros up to a shape."""
    return np.pad(table, [(0, size - own_size) for size, own_size in zip(shape, table.shape, strict=True)])


def body(source: Source) -> Body:
    """The fitted pair of MLPs."""
    c_body, model = Body(), source.model
    nets = [layers(net) for net in model.networks]
    net = Net(c_body, "tsa_net", nets, "silu")
    for side, (way, from_column) in enumerate((("forward", "motor_turns"), ("inverse", "displacement_mm"))):
        mine, other = model.scalings[side], model.scalings[1 - side]
        columns = [f"({from_column} - {real(mine.mean[0])}) * {real(1.0 / mine.std[0])}"]
        columns += paper_conditions(source, mine.mean[1:5], mine.std[1:5])
        others = ["(tsa_real)at->direction", *standardised(source)]
        columns += [
            f"(({other}) - {real(mean)}) * {real(1.0 / std)}"
            for other, mean, std in zip(others, mine.mean[5:], mine.std[5:], strict=True)
        ]
        c_body.code += function(
            "tsa_real",
            f"tsa_raw_{way}(const tsa_state *at, tsa_real {from_column})",
            f"tsa_real x[{len(columns)}], y[{net.room}];",
            *(f"x[{number}] = {column};" for number, column in enumerate(columns)),
            f"tsa_net({side}, x, y);",
            f"return y[0] * {real(other.std[0])} + {real(other.mean[0])};",
        )
    return c_body
