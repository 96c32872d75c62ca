"""Checks that the parts of a `diagnosis.json` have the right form; a wrong part is refused by its field."""

from pathlib import Path
from typing import Any, TypeVar

from pydantic import BaseModel, ConfigDict, ValidationError

from ...ground.errors import BadInput
from ...ground.input.complaint import short


class Form(BaseModel):
    """The form of one part of a diagnosis: a value of another type is refused."""

    model_config = ConfigDict(strict=True)


AnyForm = TypeVar("AnyForm", bound=Form)


def formed(form: type[AnyForm], content: Any, path: Path, mend: str, field: str = "") -> AnyForm:
    """The part of the diagnosis at `path`, checked; raises BadInput with the field that is wrong.

    `field` is the part's own name, which stands for all of it; left out, it is that of the first wrong field in it.
    """
    try:
        return form.model_validate(content)
    except ValidationError as error:
        first = error.errors()[0]
        problem = f"holds {short(first['input'])}, which is not what a diagnosis gives"
        raise BadInput(path, field or str(first["loc"][0]), problem, mend) from None
