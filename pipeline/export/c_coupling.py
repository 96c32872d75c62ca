"""Chains of coupling blocks in C, and the paper's INN that is one."""

import numpy as np

from ..models.parts.scaling import Scaling
from .c_dense import Net
from .c_physics import paper_conditions
from .c_text import Body, function, real
from .interface import Source
from .weights import Blocks, blocks

CHAIN = """\
/* The s and t of a block's half, from the other half and the conditions: s bounded softly, as exp(s). */
static inline void tsa_moves(const tsa_real *y, int size, tsa_real *scale, tsa_real *shift)
{
    int i;
    for (i = 0; i < size; ++i) {
        scale[i] = tsa_exp(TSA_BOUND * tsa_atan(y[i]));
        shift[i] = y[size + i];
    }
}

static inline void tsa_from_first(
    int block, const tsa_real *x, const tsa_real *given, tsa_real *scale, tsa_real *shift)
{
    tsa_real in[TSA_FIRST + TSA_GIVEN], out[%(room_1)d];
    int i;
    for (i = 0; i < TSA_FIRST; ++i) {
        in[i] = x[i];
    }
    for (i = 0; i < TSA_GIVEN; ++i) {
        in[TSA_FIRST + i] = given[i];
    }
    tsa_net_1(block, in, out);
    tsa_moves(out, TSA_SECOND, scale, shift);
}

static inline void tsa_from_second(
    int block, const tsa_real *x, const tsa_real *given, tsa_real *scale, tsa_real *shift)
{
    tsa_real in[TSA_SECOND + TSA_GIVEN], out[%(room_2)d];
    int i;
    for (i = 0; i < TSA_SECOND; ++i) {
        in[i] = x[TSA_FIRST + i];
    }
    for (i = 0; i < TSA_GIVEN; ++i) {
        in[TSA_SECOND + i] = given[i];
    }
    tsa_net_2(block, in, out);
    tsa_moves(out, TSA_FIRST, scale, shift);
}

static inline void tsa_block_forward(int block, const tsa_real *given, tsa_real *x)
{
    tsa_real scale[TSA_SECOND], shift[TSA_SECOND];
    int i;
    tsa_from_second(block, x, given, scale, shift);
    for (i = 0; i < TSA_FIRST; ++i) {
        x[i] = x[i] * scale[i] + shift[i];
    }
    tsa_from_first(block, x, given, scale, shift);
    for (i = 0; i < TSA_SECOND; ++i) {
        x[TSA_FIRST + i] = x[TSA_FIRST + i] * scale[i] + shift[i];
    }
}

static inline void tsa_block_inverse(int block, const tsa_real *given, tsa_real *x)
{
    tsa_real scale[TSA_SECOND], shift[TSA_SECOND];
    int i;
    tsa_from_first(block, x, given, scale, shift);
    for (i = 0; i < TSA_SECOND; ++i) {
        x[TSA_FIRST + i] = (x[TSA_FIRST + i] - shift[i]) / scale[i];
    }
    tsa_from_second(block, x, given, scale, shift);
    for (i = 0; i < TSA_FIRST; ++i) {
        x[i] = (x[i] - shift[i]) / scale[i];
    }
}

static inline void tsa_mix(const signed char *from, tsa_real *x)
{
    tsa_real old[TSA_FIRST + TSA_SECOND];
    int i;
    for (i = 0; i < TSA_FIRST + TSA_SECOND; ++i) {
        old[i] = x[i];
    }
    for (i = 0; i < TSA_FIRST + TSA_SECOND; ++i) {
        x[i] = old[from[i]];
    }
}

static inline void tsa_chain_forward(const tsa_real *given, tsa_real *x)
{
    int block;
    for (block = 0; block < TSA_BLOCKS; ++block) {
        if (block > 0) {
            tsa_mix(tsa_mixing[block - 1], x);
        }
        tsa_block_forward(block, given, x);
    }
}

static inline void tsa_chain_inverse(const tsa_real *given, tsa_real *x)
{
    int block;
    for (block = TSA_BLOCKS - 1; block >= 0; --block) {
        tsa_block_inverse(block, given, x);
        if (block > 0) {
            tsa_mix(tsa_unmixing[block - 1], x);
        }
    }
}

"""


def chain_of(c_body: Body, chain: Blocks) -> None:
    """Add the chain's weights and functions."""
    sizes = {
        "BLOCKS": len(chain.net_1),
        "FIRST": chain.first,
        "SECOND": chain.second,
        "GIVEN": len(chain.net_1[0][0].weight) - chain.first,
        "BOUND": real(chain.bound),
    }
    c_body.code += "".join(f"#define TSA_{name} {value}\n" for name, value in sizes.items()) + "\n"
    for name, layers in (("mixing", chain.mixing), ("unmixing", chain.unmixing)):
        c_body.array(f"tsa_{name}", np.array(layers or [list(range(chain.first + chain.second))]), "signed char")
    net_1 = Net(c_body, "tsa_net_1", chain.net_1, "relu")
    net_2 = Net(c_body, "tsa_net_2", chain.net_2, "relu")
    c_body.code += CHAIN % {"room_1": net_1.room, "room_2": net_2.room}


def body(source: Source) -> Body:
    """The paper's INN, fitted."""
    model, c_body = source.model, Body()
    chain_of(c_body, blocks(model.network))
    sides = (
        ("forward", "motor_turns", model.inputs, model.outputs),
        ("inverse", "displacement_mm", model.outputs, model.inputs),
    )
    for way, answer, mine, other in sides:
        c_body.code += function(
            "tsa_real",
            f"tsa_raw_{way}(const tsa_state *at, tsa_real {answer})",
            "tsa_real x[TSA_FIRST + TSA_SECOND], given[1] = {0};",
            f"x[0] = {scaled(answer, mine)};",
            *four_others(source, mine, model.settings.log_stroke),
            f"tsa_chain_{way}(given, x);",
            f"return {restored('x[0]', other)};",
        )
    return c_body


def scaled(value: str, scaling: Scaling) -> str:
    """An expression in standard deviations of a scaling's first column."""
    return f"({value} - {real(scaling.mean[0])}) * {real(1.0 / scaling.std[0])}"


def restored(value: str, scaling: Scaling) -> str:
    """An expression in its own unit again."""
    return f"{value} * {real(scaling.std[0])} + {real(scaling.mean[0])}"


def four_others(source: Source, scaling: Scaling, log_stroke: bool) -> list[str]:
    """Lines that set x[1] to x[4]: b, l, r and n."""
    columns = paper_conditions(source, scaling.mean[1:], scaling.std[1:], log_stroke)
    return [f"x[{number}] = {column};" for number, column in enumerate(columns, start=1)]
