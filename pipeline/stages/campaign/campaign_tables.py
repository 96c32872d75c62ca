"""The results of the campaign's stages, as tables: errors from few strokes, the floor beneath them, coverage."""

import pyarrow as pa


def _schema(texts: tuple[str, ...], counts: tuple[str, ...], numbers: tuple[str, ...]) -> pa.Schema:
    return pa.schema(
        [pa.field(name, pa.string()) for name in texts]
        + [pa.field(name, pa.int32()) for name in counts]
        + [pa.field(name, pa.float64()) for name in numbers]
    )


# One row for each string asked about and number of its strokes shown; `how` is "transfer" (learnt from other strings,
# then adapted) or "alone"; `reads` names the columns, besides twist and contraction, that its answers depend on.
FEW_SHOT = _schema(("model", "string", "material", "how", "reads"), ("shots",), ("forward_mm", "inverse_turns"))
# One row for each string asked about: what an oracle that sees the answers misses.
FLOOR = _schema(("string", "material"), (), ("forward_mm", "inverse_turns"))
# One row for each string, map, stroke ahead and level: share of the points inside the model's box that were held,
# median width of their intervals (mm or turns), how many they are, and how many more got no interval.
COVERAGE = _schema(("string", "material", "map"), ("ahead",), ("level", "held", "width", "points", "outside"))
