"""The pair of ridge regressions in C."""

import numpy as np

from ..models.polynomial import GIVEN
from .c_physics import standardised
from .c_text import Body, function, real
from .interface import Source

TERMS = """\
/* Legendre polynomials of degree 0 to the given one. */
static inline void tsa_legendre(tsa_real x, int degree, tsa_real *p)
{
    int k;
    p[0] = 1;
    if (degree > 0) {
        p[1] = x;
    }
    for (k = 1; k < degree; ++k) {
        p[k + 1] = ((tsa_real)(2 * k + 1) * x * p[k] - (tsa_real)k * p[k - 1]) / (tsa_real)(k + 1);
    }
}

static inline tsa_real tsa_sum(const tsa_state *at, tsa_real within, int map)
{
    tsa_real power[%(powers)d], grown[%(growths)d], other[%(room)d] = {0}, sum = 0;
    const tsa_real way = (tsa_real)at->direction;
    const tsa_real *weight = tsa_weights[map];
    int i, j;
    tsa_legendre(within < -1 ? -1 : within > 1 ? 1 : within, %(powers)d - 1, power);
    tsa_legendre(%(grown)s, %(growths)d - 1, grown);
%(others)s    for (i = 0; i < %(powers)d; ++i) {
        for (j = 0; j < %(growths)d; ++j) {
            sum += power[i] * grown[j] * (weight[0] + weight[1] * way);
            weight += 2;
        }
    }
    for (i = 0; i < %(beside)d; ++i) {
        for (j = 0; j < %(count)d; ++j) {
            sum += power[i] * other[j] * *weight++;
        }
    }
    return sum;
}

"""


def body(source: Source) -> Body:
    """The fitted regressions."""
    c_body, model, scaled = Body(), source.model, standardised(source)
    s, low, high = model.settings, model.box.low, model.box.high
    first = np.log1p(low["stroke"])
    span = max(np.log1p(high["stroke"]) - first, np.log(2.0))
    c_body.array("tsa_weights", np.stack([model.weights[from_column] for from_column in GIVEN]))
    c_body.code += "\n" + TERMS % {
        "powers": s.degree + 1,
        "growths": s.stroke_degree + 1,
        "grown": f"(tsa_log((tsa_real)(at->stroke + 1)) - {real(first)}) * {real(2.0 / span)} - 1",
        "room": len(scaled) or 1,
        "others": "".join(f"    other[{number}] = {expression};\n" for number, expression in enumerate(scaled)),
        "beside": s.other_degree + 1 if scaled else 0,
        "count": len(scaled),
    }
    for number, (way, from_column) in enumerate(zip(("forward", "inverse"), GIVEN, strict=True)):
        scale = 2.0 / ((high[from_column] - low[from_column]) or 1.0)
        c_body.code += function(
            "tsa_real",
            f"tsa_raw_{way}(const tsa_state *at, tsa_real {from_column})",
            f"return tsa_sum(at, ({from_column} - {real(low[from_column])}) * {real(scale)} - 1, {number});",
        )
    return c_body
