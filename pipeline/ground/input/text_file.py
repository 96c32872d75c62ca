"""How a text recording is written: `file:` of `run.yaml`, checked so that no reading fails or hangs on it."""

import codecs
import re
from typing import Annotated, Any, Literal

from pydantic import BaseModel, ConfigDict, Field, field_validator, model_validator

IN_NUMBERS = re.compile(r"[A-Za-z0-9.+\-\"'\r\n\0]")  # what a number is written with, or what ends a line
NO_TEXT = {"undefined", "punycode", "idna", "unicode_escape", "raw_unicode_escape", "utf-7", "mbcs", "oem"}


class TextFile(BaseModel):
    """How a text recording, or a workbook, is written."""

    model_config = ConfigDict(extra="forbid", frozen=True)

    delimiter: str = Field(",", min_length=1, max_length=1, description="one character; a space is any white space")
    skip: Annotated[int, Field(ge=0, le=10_000, strict=True)] = Field(
        0, description="how many lines stand before the names, or before the numbers where there are no names"
    )
    skip_below: Annotated[int, Field(ge=0, le=100, strict=True)] = Field(
        0, description="how many lines stand between the names and the numbers, such as one of units"
    )
    sheet: Annotated[int, Field(ge=0, strict=True)] | Annotated[str, Field(min_length=1, max_length=100)] | None = (
        Field(None, description="the sheet of an Excel workbook: its name, or its index from 0")
    )
    rows: tuple[Annotated[int, Field(ge=0, strict=True)], Annotated[int, Field(ge=1, strict=True)]] | None = Field(
        None, description="the first row of numbers to read, from 0, and the first not to read"
    )
    decimal: Literal[".", ","] = Field(".", description='"." or ",", what stands in 0.5 or 0,5')
    header: bool = Field(True, description="whether a line of names stands above the numbers")
    comment: Annotated[str, Field(min_length=1, max_length=10)] | None = Field(
        None, description="what a line begins with that is none of numbers, such as %"
    )
    encoding: str = Field("utf-8", max_length=40, description="utf-8, or utf-16, latin1, cp1252 ...")

    @field_validator("delimiter")
    @classmethod
    def _between_numbers(cls, value: str) -> str:
        if IN_NUMBERS.fullmatch(value) or not value.isascii() or not (value.isprintable() or value == "\t"):
            raise ValueError("must be a sign between numbers, such as a comma, a semicolon or a tab")
        return value

    @field_validator("header", mode="before")
    @classmethod
    def _no_line_number(cls, value: Any) -> Any:
        if isinstance(value, int) and value not in (0, 1):
            before = f"to {value - 1}, if the names stand in line {value}" if value > 0 else "to the lines before them"
            raise ValueError(
                f"is {value}, but only says whether there are names; leave it out and set file.skip {before}"
            )
        return value

    @model_validator(mode="after")
    def _below_names(self) -> "TextFile":
        if self.skip_below and not self.header:
            raise ValueError(
                "file.skip_below: counts lines below the names, of which there are none; "
                "set file.skip to all lines before the numbers"
            )
        return self

    @model_validator(mode="after")
    def _some_rows(self) -> "TextFile":
        if self.rows and self.rows[0] >= self.rows[1]:
            raise ValueError("file.rows: ends before it begins; give the first row to read and the first not to read")
        return self

    @model_validator(mode="after")
    def _two_signs(self) -> "TextFile":
        if self.decimal == self.delimiter:
            raise ValueError(
                "the sign between numbers is the decimal comma as well; set file.delimiter to ';' or a tab"
            )
        return self

    @field_validator("comment")
    @classmethod
    def _no_number(cls, value: str | None) -> str | None:
        if value is not None and (re.match(r"[0-9+\-.\s]", value) or not value.isprintable()):
            raise ValueError("must be a sign that no line of numbers begins with, such as % or #")
        return value

    @field_validator("encoding")
    @classmethod
    def _known(cls, value: str) -> str:
        try:
            codec = codecs.lookup(value) if re.fullmatch(r"[A-Za-z0-9][A-Za-z0-9 ._-]*", value) else None
        except (LookupError, ValueError):
            codec = None
        if codec is None or not getattr(codec, "_is_text_encoding", True) or codec.name in NO_TEXT:
            raise ValueError("must be an encoding of text, such as utf-8, utf-16, latin1 or cp1252")
        return value
