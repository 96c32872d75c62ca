"""A checkout with every file of CONTRIBUTING.md and docs/new_rig.md in it needs nothing that these pages do not say.

The walls of the house stand, and so do the tests that compare a list or a page with the files that are there.
"""

import os
import re
import subprocess
import sys
from pathlib import Path

import copied
import pytest
from files_shown import ROOT, shown

FILES = {
    path: text
    for page in ("CONTRIBUTING.md", "docs/new_rig.md")
    for path, text in shown(page).items()
    if path.endswith(".py")
}
WALLS = (  # of tests/house: those that read sources, and start no program
    *("arrays_said", "house", "locals_say_what_they_hold", "one_name_one_thing", "quoted_imports", "said_once"),
    *("sources_said", "types_between_modules", "types_between_rooms"),
)
LISTS = (  # whose outcome a file that is added could change
    "tests/proof/test_proof_plan.py",
    "tests/diagnosis/words/test_physics_page.py",
    "tests/diagnosis/words/test_numbers_page.py",
    "tests/diagnosis/words/language/test_glossary.py",
    "tests/diagnosis/words/named/test_coefficients.py",
)
PYTEST = ("pytest", "-q", "-o", "addopts=", "-p", "no:cacheprovider", "-m", "not long")


@pytest.fixture(scope="module")
def checkout(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A copy of the checkout with the pages' files, and pages of docs/ made anew by the command that the page tells."""
    root = tmp_path_factory.mktemp("checkout")
    copied.checkout(root)
    for path, text in FILES.items():
        (root / path).write_text(text, encoding="utf-8")
    (command,) = re.findall(r"^```sh\n(.+_page.+)\n```", (ROOT / "docs/new_rig.md").read_text("utf-8"), re.M)
    first = {**os.environ, "PATH": f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"}
    done = subprocess.run(["sh", "-ec", command], cwd=root, env=first, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return root


def tried(root: Path, *words: str) -> None:
    """Start a tool in a checkout, which must be content."""
    environment = {**os.environ, "PYTHONPATH": f"{root}{os.pathsep}{root / 'tests'}"}
    done = subprocess.run([sys.executable, "-m", *words], cwd=root, env=environment, capture_output=True, text=True)
    assert done.returncode == 0, (done.stdout + done.stderr)[-6000:]


def test_ruff_finds_nothing_in_them(checkout: Path) -> None:
    assert len(FILES) == 8
    tried(checkout, "ruff", "check", *FILES)
    tried(checkout, "ruff", "format", "--check", *FILES)


@pytest.mark.long
def test_lists_and_pages_agree_with_them(checkout: Path) -> None:
    tried(checkout, *PYTEST, *LISTS)


@pytest.mark.long
def test_the_walls_stand_with_them(checkout: Path) -> None:
    tried(checkout, *PYTEST, *(f"tests/house/test_{name}.py" for name in WALLS))
