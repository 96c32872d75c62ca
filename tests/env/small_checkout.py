"""A checkout of the launcher alone, with a lock of two tiny packages whose wheels lie beside it: no network needed."""

import base64
import hashlib
import json
import os
import shutil
import subprocess
import sys
import zipfile
from dataclasses import dataclass
from pathlib import Path

ENV = Path(__file__).parents[2] / "env"
# programs that read a package when they are asked to, as a job does that imports late
PROGRAM = "import sys\n\ndef main():\n    from {name} import deep\n    print('{name}', deep.VERSION, sys.prefix)\n"


def write_wheel(folder: Path, name: str, version: str, files: int = 40, spoiled: bool = False) -> None:
    """A wheel with a package of some files and a console script of its name; `spoiled`: a file is not as recorded."""
    content = {
        f"{name}/__init__.py": "",
        f"{name}/program.py": PROGRAM.format(name=name),
        **{f"{name}/part_{i}.py": f"PART = {i}\n" * 50 for i in range(files)},
        f"{name}/deep/__init__.py": f"VERSION = {version!r}\n",
        f"{name}/deep/data.bin": "x" * 100_000,
        f"{name}-{version}.dist-info/METADATA": f"Metadata-Version: 2.1\nName: {name}\nVersion: {version}\n",
        f"{name}-{version}.dist-info/WHEEL": "Wheel-Version: 1.0\nRoot-Is-Purelib: true\nTag: py3-none-any\n",
        f"{name}-{version}.dist-info/entry_points.txt": f"[console_scripts]\n{name} = {name}.program:main\n",
    }
    record = f"{name}-{version}.dist-info/RECORD"
    folder.mkdir(parents=True, exist_ok=True)
    with zipfile.ZipFile(folder / f"{name}-{version}-py3-none-any.whl", "w") as wheel:
        lines = []
        for path, text in content.items():
            sum_ = base64.urlsafe_b64encode(hashlib.sha256(text.encode()).digest()).rstrip(b"=").decode()
            lines.append(f"{path},sha256={sum_},{len(text.encode())}")
            wheel.writestr(path, text.replace("7", "8") if spoiled and path.endswith("part_7.py") else text)
        wheel.writestr(record, "\n".join([*lines, f"{record},,", ""]))


@dataclass
class Checkout:
    """A project folder with nothing in it but env/, and wheels to install from."""

    folder: Path
    wheels: Path
    quick: dict[str, str]

    @property
    def env(self) -> Path:
        return self.folder / "env"

    @property
    def link(self) -> Path:
        return self.env / ".venv"

    def lock(self, *lines: str) -> None:
        """Write the lock."""
        (self.env / "requirements.lock").write_text("\n".join([*lines, ""]))

    def variables(self, **more: str) -> dict[str, str]:
        """Offline, and without what the machine says about packages."""
        kept = {name: value for name, value in os.environ.items() if not name.startswith(("PIP_", "PYTHON"))}
        offline = {"PIP_CONFIG_FILE": os.devnull, "PIP_NO_INDEX": "1", "PIP_FIND_LINKS": self.wheels.as_uri()}
        return {**kept, **offline, "PIP_NO_CACHE_DIR": "1", **self.quick, **more}

    def command(self, *words: str, python: str = sys.executable) -> list[str]:
        return [python, str(self.env / "run.py"), *words]

    def run(self, *words: str, python: str = sys.executable, **more: str) -> subprocess.CompletedProcess[str]:
        """A launcher's start, to its end."""
        return subprocess.run(
            self.command(*words, python=python),
            capture_output=True,
            text=True,
            env=self.variables(**more),
            cwd=self.folder,
            stdin=subprocess.DEVNULL,
        )

    def start(self, *words: str, **more: str) -> subprocess.Popen[str]:
        """A launcher's start, left alone; the leader of a group of its own."""
        return subprocess.Popen(
            self.command(*words),
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            env=self.variables(**more),
            cwd=self.folder,
            stdin=subprocess.DEVNULL,
            start_new_session=True,
        )

    def places(self) -> list[Path]:
        """Every environment that lies there, whole or not."""
        return sorted(path for path in self.env.glob(".venv-*") if path.is_dir() and not path.is_symlink())

    def stamped(self) -> list[Path]:
        """Those that say that they are whole."""
        return [path for path in self.places() if (path / "stamp").exists()]


def is_whole(place: Path, packages: dict[str, int]) -> bool:
    """Whether an environment has every file of some packages, counted and read without the launcher's code."""
    site = next(place.glob("lib/python*/site-packages"))
    for name, files in packages.items():
        parts = [site / name / f"part_{i}.py" for i in range(files)]
        if not all(path.is_file() and path.read_text() == f"PART = {i}\n" * 50 for i, path in enumerate(parts)):
            return False
        if (site / name / "deep" / "data.bin").read_text() != "x" * 100_000:
            return False
        done = subprocess.run([place / "bin" / name], capture_output=True, text=True)
        if done.returncode or str(place) not in done.stdout:
            return False
    return "lock" in json.loads((place / "stamp").read_text())


def make_checkout(folder: Path, quick: dict[str, str]) -> Checkout:
    """The launcher as it is in this project, elsewhere."""
    (folder / "env").mkdir(parents=True)
    shutil.copy(ENV / "run.py", folder / "env")
    shutil.copytree(ENV / "launcher", folder / "env" / "launcher", ignore=shutil.ignore_patterns("__pycache__"))
    shutil.copytree(ENV / "profile", folder / "env" / "profile")
    wheels = folder.parent / "wheels"
    for name in ("alpha", "beta"):
        for version in ("1.0", "2.0"):
            write_wheel(wheels, name, version)
    checkout = Checkout(folder, wheels, quick)
    checkout.lock("alpha==1.0", "beta==1.0")
    return checkout
