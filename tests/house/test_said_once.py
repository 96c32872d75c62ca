"""What many modules decide by is said in one place: ids outside the library, models that pages treat apart."""

import re
from pathlib import Path

PIPELINE = Path(__file__).parents[2] / "pipeline"
IN_ONE_PLACE = {
    r"""startswith\(["']x_""": {"ground/outside_library.py"},
    r"""^USUAL = (True|["'](inn|spline|traditional))""": {"ground/model_names.py"},
    # beside it: the paper's printed numbers, and the leak's figure, by the models' names
    r"""(?<!\w)["'](inn|spline|traditional)["']""": {
        "ground/model_names.py", "report/layout/paper.py", "report/leak.py", "export/c_spline.py",
    },
}  # fmt: skip


def test_a_name_that_programs_decide_by_stands_in_one_module() -> None:
    paths = [path for path in PIPELINE.rglob("*") if path.suffix in (".py", ".smk")]
    texts = {str(path.relative_to(PIPELINE)): path.read_text("utf-8") for path in paths}
    for pattern, places in IN_ONE_PLACE.items():
        assert {name for name, text in texts.items() if re.search(pattern, text, re.M)} == places, pattern
