"""A checkout of the launcher with a whole environment, copied for each test from one that is made once."""

import compileall
import ensurepip
import shutil
import zipfile
from pathlib import Path

import pytest
from small_checkout import Checkout, make_checkout

# pip is put into an environment by unpacking it: ten times as fast as by its own installer, whose work is not ours
SITE = """
import shutil, venv
from pathlib import Path

def unpack_pip(self, context):
    site = next(Path(context.env_dir).glob("lib/python*/site-packages"))
    shutil.copytree({pip!r}, site, dirs_exist_ok=True)

venv.EnvBuilder._setup_pip = unpack_pip
"""


@pytest.fixture(scope="session")
def quick(tmp_path_factory: pytest.TempPathFactory) -> dict[str, str]:
    """Variables under which making a virtual environment takes a second."""
    folder = tmp_path_factory.mktemp("quick")
    bundled = next((Path(ensurepip.__file__).parent / "_bundled").glob("pip-*.whl"), None)
    if bundled is None:  # as Debian packages Python: made by its own installer, slower
        (folder / "sitecustomize.py").write_text("")
        return {"PYTHONPATH": str(folder)}
    with zipfile.ZipFile(bundled) as wheel:
        wheel.extractall(folder / "pip")
    compileall.compile_dir(folder / "pip", quiet=2)
    (folder / "sitecustomize.py").write_text(SITE.format(pip=str(folder / "pip")))
    return {"PYTHONPATH": str(folder)}


@pytest.fixture(scope="session")
def original(tmp_path_factory: pytest.TempPathFactory, quick: dict[str, str]) -> Checkout:
    """A checkout with a whole environment. Tests leave it as it is."""
    checkout = make_checkout(tmp_path_factory.mktemp("original") / "project", quick)
    done = checkout.run("true")
    assert done.returncode == 0, done.stderr
    return checkout


@pytest.fixture
def checkout(tmp_path: Path, original: Checkout) -> Checkout:
    """A copy of it, fitted to its new place, to change at will."""
    folder = tmp_path / "project"
    shutil.copytree(original.folder, folder, symlinks=True)
    copy = Checkout(folder, original.wheels, original.quick)
    done = copy.run("true")
    assert done.returncode == 0, done.stderr
    return copy


@pytest.fixture
def bare(tmp_path: Path, quick: dict[str, str]) -> Checkout:
    """A checkout without an environment."""
    return make_checkout(tmp_path / "bare" / "project", quick)
