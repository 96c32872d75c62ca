"""Whether an environment holds what the lock names: in full by its own records, or cheaply by an outline of them.

Every installed package carries a RECORD: its files with their sizes and SHA-256 sums.
"""

import base64
import csv
import hashlib
import os
import re
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

Outline = dict[str, int]


def site_of(place: Path) -> Path:
    """The folder that the packages of an environment lie in."""
    return next(iter(sorted(place.glob("lib/python*/site-packages"))), place / "lib" / "site-packages")


def canonical(name: str) -> str:
    """A package's name as indexes compare it."""
    return re.sub(r"[-_.]+", "-", name).lower()


def locked(lock: Path) -> dict[str, str]:
    """Package → version, as the lock pins them."""
    lines = [line.split("#")[0].split(";")[0].strip() for line in lock.read_text(encoding="utf-8").splitlines()]
    pairs = [line.split("==", 1) for line in lines if "==" in line]
    return {canonical(name.strip()): version.strip() for name, version in pairs}


def installed(site: Path) -> dict[str, Path]:
    """Package → its folder of records."""
    return {canonical(package_of(folder)[0]): folder for folder in site.glob("*.dist-info")}


def package_of(folder: Path) -> tuple[str, str]:
    """Name and version, as a folder of records is called."""
    name, _, version = folder.name.removesuffix(".dist-info").rpartition("-")
    return name, version


def rows(record: Path) -> list[list[str]]:
    """Path, sum and size of each file of a package; raises OSError, csv.Error or UnicodeDecodeError."""
    with open(record, newline="", encoding="utf-8") as file:
        return [row for row in csv.reader(file) if row]


def wrong_file(path: Path, sum_: str, size: str) -> str:
    """What is wrong with an installed file, or nothing."""
    try:
        with open(path, "rb") as file:
            # a script begins with the environment's own path, which changes when the checkout moves
            script = path.parent.name == "bin" and file.read(2) == b"#!"
            if not sum_ or script:
                return ""
            if size and os.fstat(file.fileno()).st_size != int(size):
                return f"{path.name} has another size than its record says"
            file.seek(0)
            kind, _, expected = sum_.partition("=")
            found = base64.urlsafe_b64encode(hashlib.file_digest(file, kind).digest()).rstrip(b"=").decode()
            return "" if found == expected else f"{path.name} differs from its record"
    except FileNotFoundError:
        return f"{path.name} is missing"
    except (OSError, ValueError) as error:
        return f"{path.name} cannot be read ({error})"


def faults_of(site: Path, folder: Path) -> list[str]:
    """What is wrong with one installed package, by its RECORD."""
    package = package_of(folder)[0]
    try:
        listed = [(row[0], row[1], row[2]) for row in rows(folder / "RECORD") if not row[0].endswith(".pyc")]
    except (OSError, ValueError, IndexError, csv.Error) as error:
        return [f"{package}: its RECORD cannot be read ({error})"]
    found = [wrong_file(site / path, sum_, size) for path, sum_, size in listed]
    return [f"{package}: {fault}" for fault in found if fault]


def faults(place: Path, lock: Path) -> list[str]:
    """Everything in which an environment differs from the lock and from its own records; each file is read."""
    site = site_of(place)
    here = installed(site)
    found = []
    for name, version in locked(lock).items():
        has = package_of(here[name])[1] if name in here else ""
        if has.split("+")[0] != version.split("+")[0]:  # torch 2.13.0+cpu is torch 2.13.0
            found.append(f"{name} {version} is not installed" + (f", {has} is" if has else ""))
    with ThreadPoolExecutor() as readers:
        for some in readers.map(lambda folder: faults_of(site, folder), here.values()):
            found += some
    return found


def outline(place: Path, lock: Path) -> Outline:
    """What a start looks at: entries in each top folder of the locked packages, and the size of each RECORD."""
    site, looked_at = site_of(place), {}
    here = installed(site)
    for name in locked(lock):
        record = here[name] / "RECORD"
        looked_at[f"{here[name].name}/RECORD"] = record.stat().st_size
        for top in {row[0].split("/")[0] for row in rows(record)} - {"..", "__pycache__"}:
            path = site / top
            looked_at[top] = len(os.listdir(path)) if path.is_dir() else path.stat().st_size
    return looked_at


def shrunk(place: Path, looked_at: Outline) -> str:
    """The first thing of the outline that is gone, has fewer entries or another size, or nothing."""
    site = site_of(place)
    for name, expected in looked_at.items():
        try:
            found = len(os.listdir(site / name))
            enough = found >= expected  # a cache may have come in
        except NotADirectoryError:
            found = os.stat(site / name).st_size
            enough = found == expected
        except OSError:
            return f"{name} is missing"
        if not enough:
            return f"{name} is incomplete"
    return ""
