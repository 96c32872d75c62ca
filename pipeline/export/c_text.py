"""Pieces of C99: numbers, arrays, and the body of a model that the header is put together from."""

import re
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from .inputs import Inputs

A_LINE = 8  # numbers
PREFIX = re.compile(r"\b(tsa|TSA)_")


@dataclass
class Body:
    """A model in C: its arrays and functions, the first of which are `tsa_raw_forward` and `tsa_raw_inverse`.

    Both take `const tsa_state *at` and a number, check nothing, and return a number.
    """

    code: str = ""
    arrays: list[str] = field(default_factory=list)  # names
    size: int = 0  # of the arrays, in bytes, `tsa_real` being float
    further: str = ""  # functions beside the two of every header
    usage: tuple[str, ...] = ()  # lines of the comment on them

    def array(self, name: str, values: Any, kind: str = "tsa_real") -> None:
        """Add a constant array; `float` ones keep their type whatever `tsa_real` is, as do `signed char` ones."""
        values = np.asarray(values)
        sizes = "".join(f"[{size}]" for size in values.shape)
        self.code += f"static const {kind} {name}{sizes} = {_nested(values, kind)};\n"
        self.arrays.append(name)
        self.size += values.size * (1 if kind == "signed char" else 4)


def _nested(values: Any, kind: str) -> str:
    if values.ndim > 1:
        return "{\n" + ",\n".join(_nested(row, kind) for row in values) + "}"
    written = {"float": short, "tsa_real": real}.get(kind, lambda value: str(int(value)))
    numbers = [written(value) for value in values]
    rows = [", ".join(numbers[start : start + A_LINE]) for start in range(0, len(numbers), A_LINE)]
    return "{" + ",\n ".join(rows) + "}"


def short(value: float) -> str:
    """A single-precision number with all its digits."""
    text = f"{value:.9g}"
    return f"{text if set(text) & set('.en') else text + '.0'}f"


def real(value: float) -> str:
    """A number as a constant of type `tsa_real`."""
    return f"TSA_R({float(value)!r})"


def read(inputs: Inputs, name: str) -> str:
    """A measured column as an expression: the caller's field, or the constant that is baked in."""
    if name in inputs.names:
        return f"at->{name}"
    return real(inputs.baked.get(name, 0.0))


def function(returns: str, head: str, *lines: str) -> str:
    """A `static inline` function of these lines."""
    return f"static inline {returns} {head}\n{{\n" + "".join(f"    {line}\n" for line in lines) + "}\n\n"


def renamed(text: str, name: str) -> str:
    """The text with another prefix than tsa_ and TSA_."""
    return PREFIX.sub(lambda match: (name if match[1] == "tsa" else name.upper()) + "_", text)
