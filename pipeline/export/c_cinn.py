"""The conditional INN in C: from the root of eq. 4's contraction to the answer's root, and back by secant steps."""

from ..models.parts.networks import secant
from .c_coupling import chain_of, four_others, restored, scaled
from .c_physics import physics, standardised
from .c_text import Body, function, real
from .interface import Source
from .weights import blocks

SECANT = """\
#define TSA_NOTHING (sizeof(tsa_real) > sizeof(float) ? TSA_R(1e-12) : TSA_R(3e-7)) /* standard deviations */

/* The blocks backwards, then steps of the secant until the blocks forwards give what was wanted. */
static inline tsa_real tsa_secant(const tsa_real *given, const tsa_real *wanted)
{
    tsa_real x[TSA_FIRST + TSA_SECOND], there, last = 0, missed = 0, slope = 1;
    int i, step;
    for (i = 0; i < TSA_FIRST + TSA_SECOND; ++i) {
        x[i] = wanted[i];
    }
    tsa_chain_inverse(given, x);
    there = x[0];
    for (step = 0; step < %(secants)d; ++step) {
        const tsa_real apart = there - last;
        tsa_real lacks;
        x[0] = there;
        for (i = 1; i < TSA_FIRST + TSA_SECOND; ++i) {
            x[i] = wanted[i];
        }
        tsa_chain_forward(given, x);
        lacks = wanted[0] - x[0];
        if (lacks < TSA_NOTHING && lacks > -TSA_NOTHING) {
            break; /* no more than the last digit */
        }
        if (step > 0 && !(apart < %(nearest)s && apart > -%(nearest)s)) {
            slope = (missed - lacks) / apart;
            slope = slope < %(flattest)s ? %(flattest)s : slope > %(steepest)s ? %(steepest)s : slope;
        }
        last = there;
        missed = lacks;
        there += lacks / slope;
    }
    return there;
}

"""


def body(source: Source) -> Body:
    """The conditional INN, fitted."""
    model, c_body = source.model, Body(physics(source.inputs))
    chain_of(c_body, blocks(model.network))
    conditions = [*(["(tsa_real)at->direction"] if model.settings.direction else []), *standardised(source)]
    c_body.code += function(
        "void",
        "tsa_given(const tsa_state *at, tsa_real *given)",
        "(void)at;",
        "given[0] = 0;",
        *(f"given[{number}] = {expression};" for number, expression in enumerate(conditions)),
    )
    c_body.code += function(
        "tsa_real",
        "tsa_root(tsa_real contraction_mm)",
        f"const tsa_real shifted = contraction_mm + {real(model.shift_mm)};",
        "return tsa_sqrt(shifted > 0 ? shifted : 0);",
    )
    names = "tsa_real x[TSA_FIRST + TSA_SECOND], given[TSA_GIVEN + 1], root"
    c_body.code += function(
        "tsa_real",
        "tsa_raw_forward(const tsa_state *at, tsa_real motor_turns)",
        f"{names} = tsa_root(tsa_base_mm(at, tsa_mm_per_turn(at), motor_turns));",
        "tsa_given(at, given);",
        f"x[0] = {scaled('root', model.inputs)};",
        *four_others(source, model.inputs, True),
        "tsa_chain_forward(given, x);",
        f"root = {restored('x[0]', model.outputs)};",
        f"return root * root - {real(model.shift_mm)};",
    )
    numbers = {
        "secants": secant.SECANTS,
        "flattest": real(secant.FLATTEST),
        "steepest": real(secant.STEEPEST),
        "nearest": real(secant.NEAREST),
    }
    c_body.code += SECANT % numbers + function(
        "tsa_real",
        "tsa_raw_inverse(const tsa_state *at, tsa_real displacement_mm)",
        f"{names} = tsa_root(displacement_mm);",
        "tsa_given(at, given);",
        f"x[0] = {scaled('root', model.outputs)};",
        *four_others(source, model.outputs, True),
        "root = tsa_secant(given, x);",
        f"root = {restored('root', model.inputs)};",
        f"return tsa_base_turns(at, tsa_mm_per_turn(at), root * root - {real(model.shift_mm)});",
    )
    return c_body
