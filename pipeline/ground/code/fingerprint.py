"""A fingerprint of the Python behind a rule, so that Snakemake sees when that Python changes."""

import ast
import hashlib
from collections.abc import Iterator
from functools import cache
from pathlib import Path

from .kept_imports import KeptImports
from .modules import literal

SOURCES = (".py", ".yaml", ".json")
HOUSE = Path(__file__).resolve().parents[2]  # the package: `pipeline` in a checkout, it may be installed as another
NAME = "pipeline"


@cache
def _file_in(house: Path, module: str) -> Path | None:
    """Source file of a module of a package, or None for anything else; fingerprints look for the same ones."""
    first, *rest = module.split(".")
    if first != NAME:
        return None
    base = house.joinpath(*rest)
    candidates = (base.with_suffix(".py"), base / "__init__.py")
    return next((path for path in candidates if path.is_file()), None)


def _file(module: str) -> Path | None:
    """Source file of a module of ours, or None for anything else."""
    return _file_in(HOUSE, module)


def _is_source(path: Path) -> bool:
    """Whether a file of the package is code or data of it, not a file beside compiled code."""
    return path.suffix in SOURCES and path.parent.name != "__pycache__"


def _statements(body: list[ast.stmt]) -> Iterator[ast.stmt]:
    """Statements that can run, and those inside them; no expression holds one."""
    for node in body:
        if isinstance(node, ast.If) and "TYPE_CHECKING" in ast.unparse(node.test):
            continue  # for a checker of types alone
        yield node
        for field in ("body", "orelse", "finalbody", "handlers", "cases"):
            yield from _statements(getattr(node, field, []))


def _absolute(node: ast.ImportFrom, path: Path) -> str:
    """Name of the module that an import statement of a source file names, its leading dots resolved."""
    if not node.level:
        return node.module or ""
    package = (NAME, *path.relative_to(HOUSE).parts[: -node.level])
    return ".".join((*package, *(node.module or "").split("."))).removesuffix(".")


@cache
def _source(path: Path) -> tuple[str, bytes]:
    """Path inside the project and content of a source file, read once."""
    return path.relative_to(HOUSE).as_posix(), path.read_bytes()


@cache
def _kept(house: Path) -> KeptImports:
    """The imports that earlier processes found in a package's source files."""
    return KeptImports(house)


@cache
def _imports(path: Path) -> frozenset[str]:
    """Modules of ours that a source file imports, found now or by an earlier process."""
    return _kept(HOUSE).of(*_source(path), lambda: _imports_anew(path))


def _imports_anew(path: Path) -> frozenset[str]:
    """Modules of ours that a source file imports anywhere in its code, parents included, or finds by name."""
    names: set[str] = set()
    tree = ast.parse(_source(path)[1])
    for node in _statements(tree.body):
        if isinstance(node, ast.Import):
            names.update(alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            base = _absolute(node, path)
            names.add(base)
            names.update(f"{base}.{alias.name}" for alias in node.names)
    parts = [name.split(".") for name in names if name.split(".")[0] == NAME]
    by_name = literal(tree, "FOUND_BY_NAME", ())
    return frozenset([*by_name, *(".".join(part[:end]) for part in parts for end in range(1, len(part) + 1))])


def reachable(*modules: str) -> list[Path]:
    """Source files, sorted, of modules and of all of ours that they import, directly or not.

    `package.*` stands for every file of a package, data too: what it finds by name at run time, imports do not show.
    A module that finds others so says of what packages, under FOUND_BY_NAME.
    """
    paths: set[Path] = set()
    waiting, seen = list(modules), set[str]()
    while waiting:
        module = waiting.pop()
        if module in seen:
            continue
        seen.add(module)
        if module.endswith(".*"):
            files = [path for path in HOUSE.joinpath(*module.split(".")[1:-1]).rglob("*") if _is_source(path)]
            paths.update(path for path in files if path.suffix != ".py")
            names = [(NAME, *path.relative_to(HOUSE).with_suffix("").parts) for path in files if path.suffix == ".py"]
            waiting += [".".join(name).removesuffix(".__init__") for name in names]
            continue
        path = _file(module)
        if path is None or path in paths:
            continue
        paths.add(path)
        main = path.parent / "__main__.py"
        if path.name == "__init__.py" and main.is_file() and module in modules:
            waiting.append(f"{module}.__main__")
        waiting.extend(_imports(path))
    _kept(HOUSE).keep()
    return sorted(paths)


def fingerprint(*modules: str) -> str:
    """Hash of the source that modules reach, by content and by path inside the project.

    Raises ModuleNotFoundError for a module that is not ours: a rule that names it would never run again.
    """
    for module in modules:
        if _file(module.removesuffix(".*")) is None:
            raise ModuleNotFoundError(f"{module} is not a module of this project")
    digest = hashlib.sha256()
    for path in reachable(*modules):
        name, content = _source(path)
        digest.update(name.encode() + b"\0" + content + b"\0")
    return digest.hexdigest()[:16]
