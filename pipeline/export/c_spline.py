"""The conditional monotone spline over eq. 4 in C: plain queries, and tables prepared once a stroke and direction."""

import numpy as np

from ..ground.errors import BadInput
from ..models.spline import MOST
from .c_curve import CURVE, PREPARED, QUERIES
from .c_physics import physics, standardised, zone
from .c_text import Body, function, real
from .interface import Source

LAWS = {
    "logarithm": "tsa_log({parameter} + n)",
    "power": "tsa_pow(n, {parameter})",
    "saturating": "-tsa_exp(-n / {parameter})",
}

TABLES = """\
/* The spline of one state: value and slope at its BINS + 1 knots, which are evenly spaced in u = x4 / d. */
#define TSA_BINS %(bins)d
#define TSA_FEATURES %(features)d
#define TSA_FIRST_U %(first)s
#define TSA_BIN_U %(width)s

typedef struct {
    tsa_real value[TSA_BINS + 1];
    tsa_real rise[TSA_BINS]; /* not the difference of values, which rounding may make 0 */
    tsa_real slope[TSA_BINS + 1];
    tsa_real mm_per_turn;
    tsa_real zone_mm;
    tsa_state at;
} tsa_tables;

"""

KNOTS_OF_STATE = """\
/* exp for |x| <= 21: no branch and no call, so that a loop of it becomes vectors. */
static inline tsa_real tsa_gain(tsa_real x)
{
    const int power = (int)(x * TSA_R(1.4426950408889634) + TSA_R(32.5)); /* nearest power of two, from -32 */
    const tsa_real twos = (tsa_real)(power - 32);
    const tsa_real rest = (x - twos * TSA_R(0.693145751953125)) - twos * TSA_R(1.4286068203094172e-06);
    tsa_real sum = 1, eights = (tsa_real)(1 << (power >> 3));
    if (sizeof(tsa_real) > sizeof(float)) {
%(double_terms)s    }
%(terms)s    eights *= eights;
    eights *= eights;
    return sum * (tsa_real)(1 << (power & 7)) * TSA_R(2.3283064365386963e-10) * (eights * eights);
}

static inline void tsa_knots(const tsa_state *at, tsa_tables *tables)
{
    tsa_real feature[TSA_FEATURES], linear[2 * TSA_BINS + 2] = {0};
    int i, k;
    tsa_features(at, feature);
    tables->at = *at;
    tables->mm_per_turn = tsa_mm_per_turn(at);
    tables->zone_mm = %(zone)s;
    for (i = 0; i < TSA_FEATURES; ++i) {
        for (k = 0; k < 2 * TSA_BINS + 2; ++k) {
            linear[k] += tsa_weights[i][k] * feature[i];
        }
    }
    tables->value[0] = TSA_FIRST_U + linear[0] / tables->zone_mm;
    for (k = 0; k < 2 * TSA_BINS + 2; ++k) {
        linear[k] = linear[k] < -%(most)s ? -%(most)s : linear[k] > %(most)s ? %(most)s : linear[k];
    }
    for (k = 0; k < 2 * TSA_BINS + 2; ++k) {
        linear[k] = tsa_gain(linear[k]);
    }
    for (k = 0; k < TSA_BINS; ++k) {
        tables->rise[k] = TSA_BIN_U * linear[k + 1];
        tables->value[k + 1] = tables->value[k] + tables->rise[k];
    }
    for (k = 0; k <= TSA_BINS; ++k) {
        tables->slope[k] = linear[TSA_BINS + 1 + k];
    }
}

"""


def _terms(first: int, last: int, indent: str) -> str:
    """Lines that add terms of the exponential's series, the highest first; a loop of them would not become vectors."""
    return "".join(f"{indent}sum = 1 + sum * (rest * {real(1.0 / number)});\n" for number in range(first, last, -1))


def feature_terms(others: list[str], directed: bool) -> list[str]:
    """The knots' features in `Spline`'s order, of the C names one, grown, first and way."""
    terms = ["1", "grown", "first", *others, *(f"{other} * grown" for other in others)]
    return terms + (["way", "way * grown", "way * first", *(f"way * {other}" for other in others)] if directed else [])


def body(source: Source) -> Body:
    """The fitted spline; raises BadInput for a spline whose knots are not evenly spaced."""
    model, inputs = source.model, source.inputs
    at, bins = model.knots_at, model.settings.bins
    if not np.allclose(np.diff(at), (at[-1] - at[0]) / bins, rtol=1e-6, atol=0.0):
        raise BadInput("spline", "knots", "are not evenly spaced", "fit it again")
    scaled = standardised(source)
    others = [f"other[{number}]" for number in range(len(scaled))]
    terms = feature_terms(others, model.settings.direction)
    law = LAWS[model.law.family].format(parameter=real(model.law.parameter))
    c_body = Body(physics(inputs))
    c_body.code += TABLES % {
        "bins": bins,
        "features": len(terms),
        "first": real(at[0]),
        "width": real((at[-1] - at[0]) / bins),
    }
    c_body.array("tsa_weights", model.weights.T)
    declared = [f"tsa_real other[{len(others)}];"] if others else []
    c_body.code += "\n" + function(
        "void",
        "tsa_features(const tsa_state *at, tsa_real *feature)",
        "const tsa_real n = (tsa_real)at->stroke, first = (tsa_real)(at->stroke == 1);",
        f"const tsa_real grown = ({law} - {real(model.law.mean)}) * {real(1.0 / model.law.std)};",
        *(["const tsa_real way = (tsa_real)at->direction;"] if model.settings.direction else []),
        *declared,
        *(f"{other} = {expression};" for other, expression in zip(others, scaled, strict=True)),
        *(f"feature[{number}] = {term};" for number, term in enumerate(terms)),
    )
    c_body.code += KNOTS_OF_STATE % {
        "zone": zone(inputs),
        "most": real(MOST),
        "double_terms": _terms(14, 8, "        "),
        "terms": _terms(8, 0, "    "),
    }
    c_body.code += CURVE + QUERIES
    c_body.further = PREPARED
    c_body.usage = (
        "Where stroke and conditions change seldom, tsa_prepare(&state, &tables) once and then",
        "tsa_forward_prepared(&tables, ...), tsa_inverse_prepared(&tables, ...): the same answers, sooner.",
    )
    return c_body
