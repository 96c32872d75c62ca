"""What code and pages cite can be opened by whoever has the repository."""

import re

import pytest
from test_hygiene import ROOT, tracked

NO_DOCUMENT = re.compile(r"(?<![a-z])the[\s_#]+contracts?(?![a-z])", re.IGNORECASE)  # none of that name is here

TEXTS = (".py", ".md", ".smk", ".yaml", ".ipynb", ".toml", ".c", ".h")


@pytest.mark.parametrize("words", ["as the contract has it", "as the\n# contract", "test_is_the_contracts_layout"])
def test_the_pattern_sees_a_citation(words):
    assert NO_DOCUMENT.search(words)


def test_no_file_cites_a_document_that_is_not_here():
    texts = [path for path in tracked() if path.suffix in TEXTS]
    assert len(texts) > 500
    for path in texts:
        if path.is_file() and path.name != "test_sources_are_in_the_tree.py":
            cited = NO_DOCUMENT.search(path.read_text(encoding="utf-8"))
            assert not cited, f"{path.relative_to(ROOT)}: name a file of this tree that says it"
