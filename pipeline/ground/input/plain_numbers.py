"""Numbers as `run.yaml` may have them: plainly written, and of a size that can be measured."""

import re
from typing import Annotated, Any

from pydantic import BeforeValidator, Field

from .strict_yaml import Unclear, plain_value

COMMA = re.compile(r"[+-]?[0-9]+,[0-9]+")


def no_bool(value: Any) -> Any:
    """The value itself; raises ValueError where it is true or false."""
    if isinstance(value, bool):  # YAML reads yes and no as these, and they would count as 1 and 0
        raise ValueError("must be a number")
    return value


def _plain(value: Any) -> Any:
    if isinstance(value, str):  # of these pydantic would take "0300" and 1_0, which readers take differently
        try:
            number = plain_value(value)
        except Unclear:
            number = None
        if isinstance(number, bool | str | None):
            if COMMA.fullmatch(value.strip()):
                like = value.strip().replace(",", ".")
                raise ValueError(f"must be a plain number with a point, not a comma, such as {like}")
            raise ValueError("must be a plain number, such as 0.55 or 300")
    return no_bool(value)


# What can be measured in the units here; outside, a product of two such numbers would leave what a computer holds.
Number = Annotated[float, BeforeValidator(_plain), Field(allow_inf_nan=False, ge=-1e18, le=1e18)]
Positive = Annotated[Number, Field(ge=1e-9, le=1e9)]
Times = Annotated[int, BeforeValidator(_plain), Field(ge=0, le=10**9)]
