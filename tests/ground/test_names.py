"""Names that become part of a path, a rule or a page are checked at one door."""

import re
from pathlib import Path

import pytest
from snakemake.io import PeriodicityDetector

from pipeline.ground import names
from pipeline.ground.errors import BadInput

ROOT = Path(__file__).parents[2]

HOSTILE = [
    "", ".", "..", "../../x", "/etc/passwd", "a/b", "a\\b", "..\\x", "-rf", ".hidden", "a\0b", "a\nb", "a\rb", "a\tb",
    "$(touch PWNED)", "`id`", "a;$HOME", "a{b}c", "<img src=x onerror=alert(1)>", '"><script>', "a|b", "a*", "a?",
    "x" * 300, " a", "a ", "a\u202eb", "a\u2028b", "a\u00a0b", "\ud800", "nul", "CON", "com1", "aux.txt", "C:x",
    "~root",
]  # fmt: skip


@pytest.mark.parametrize("check", [names.run_name, names.material, names.own_material, names.string_id])
@pytest.mark.parametrize("name", HOSTILE)
def test_no_hostile_name_passes(check, name):
    with pytest.raises(BadInput) as error:
        names.checked(check, name, "run.yaml", "string.id")
    assert error.value.problem and error.value.mend and error.value.field == "string.id"


def test_what_a_lab_would_write_passes():
    for name in (
        "spool-3-a",
        "Spool 3, end A",
        "Faden №7 (grün)",
        "2026-11-22 #4",
        "Тест_1",
        "糸 5",
        "O'Neil & Co. 50 %",
    ):
        assert names.string_id(name) == name
    for name in ("uhmwpe-20261121-01", "a", "0", "x" * 99 + "y"):
        assert names.run_name(name) == name
    for name in ("UHMWPE", "nylon_6-6", "x" * 99 + "y", "synthetic"):
        assert names.material(name) == name


def test_one_name_is_one_text_however_it_is_typed():
    assert names.string_id("gru\u0308n") == "gr\u00fcn"


@pytest.mark.parametrize(
    "name", ["diagnosis", "real", "Proof", "campaign", "blind", "INDEX", "logs", "raw", "recordings"]
)
def test_folders_of_the_reports_are_no_material_and_no_run(name):
    for check in (names.material, names.run_name):
        with pytest.raises(ValueError):
            check(name)


EXAMPLES = {"example", "mine", "nylon"}  # that documents give to what a user names


def test_every_folder_that_rules_and_documents_name_is_reserved():
    written = [*(ROOT / "pipeline" / "rules").glob("*.smk"), *(ROOT / "docs").glob("*.*"), ROOT / "Snakefile"]
    text = "\n".join(path.read_text(encoding="utf-8") for path in written if path.suffix in (".smk", ".md", ".py", ""))
    named = set(re.findall(r"\b(?:reports|processed)/([A-Za-z_][\w-]*)(?=[/`\s])", text)) - EXAMPLES
    assert {"proof", "site", "settle", "diagnosis"} < named
    for name in named - {"synthetic"}:
        with pytest.raises(ValueError, match="use for something else"):
            names.material(name)


@pytest.mark.parametrize(
    "name", ["0" * 20, "run-" + "0" * 60, "ab" * 20, "spool" + "-3" * 25, "x" * 19, "ab" * 19, "a" * 30 + "b", "1" * 99]
)
def test_a_name_passes_where_snakemake_can_plan_it(name):
    repetition = names.PERIODIC.search(name)
    assert (repetition is None) == (PeriodicityDetector().is_periodic(name) is None)
    for check in (names.run_name, names.material):
        if repetition:
            with pytest.raises(
                ValueError, match="20 times or more, which Snakemake plans no job for; use a shorter end"
            ):
                check(name)
        else:
            assert check(name) == name


def test_the_synthetic_rigs_material_is_its_own():
    for name in ("synthetic", "Synthetic"):
        with pytest.raises(ValueError, match="kept for the synthetic rig's own runs; give another"):
            names.own_material(name)


def test_a_column_is_one_line_that_can_be_seen():
    for name in ("theta_1", "Zeit [s]", "x/y", "F {N}", "t; s"):
        assert names.column(name) == name
    for name in ("", "a\nb", "a\0", "\u202ea", "x" * 101):
        with pytest.raises(ValueError):
            names.column(name)
