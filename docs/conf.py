"""The site that these pages make: `python -m sphinx -W --keep-going docs reports/site`.

It is searched without a server, and nothing in it is fetched from elsewhere. The pages are plain Markdown, for a code
host shows them too; what the site alone needs is added here: its navigation, its reference and the tutorial's cells.
"""

import importlib
import inspect
import json
import re
import sys
from pathlib import Path
from typing import Any

DOCS = Path(__file__).resolve().parent
sys.path.insert(0, str(DOCS.parent))

import pipeline  # noqa: E402

sys.modules["twistbench"] = pipeline  # its name where it is installed, and the one that the reference shows

project, author = "twistbench", "the twistbench authors"
version = release = pipeline.__version__
copyright = f"{author}; MIT licence"
extensions = ["myst_parser", "sphinx.ext.autodoc"]
source_suffix = {".md": "markdown", ".ipynb": "markdown"}
exclude_patterns = ["conf.py"]
html_theme, html_title = "furo", "twistbench"
html_copy_source = html_show_sourcelink = False
html_show_sphinx = False
myst_heading_anchors = 4
autodoc_typehints_format = "short"
autodoc_member_order = "bysource"
autodoc_default_options = {"members": True, "exclude-members": "__init__"}
autodoc_class_signature = "separated"
default_role = "literal"
add_module_names = False


def _output(output: dict[str, Any]) -> str:
    """What a cell printed or showed, as Markdown: a picture, else text; a page of HTML is shown as it is."""
    shown = output.get("data", {})
    if "image/png" in shown:
        return f"![what the cell shows](data:image/png;base64,{''.join(shown['image/png']).strip()})"
    if "text/html" in shown:
        told = "".join(shown["text/html"]).replace('border="1" class="dataframe"', 'class="docutils"')
        return f'```{{raw}} html\n<div class="table-wrapper container">{told}</div>\n```'
    text = "".join(output.get("text", shown.get("text/plain", ""))).rstrip()
    return f"```text\n{text}\n```" if text else ""


def _cell(cell: dict[str, Any]) -> str:
    """A notebook's cell, and what it gave, as Markdown."""
    text = "".join(cell["source"])
    if cell["cell_type"] == "markdown":
        return text
    return "\n\n".join([f"```python\n{text}\n```", *filter(None, map(_output, cell.get("outputs", [])))])


def _navigation(page: str) -> str:
    """The front page, and a table of contents of each of its lists of links, under the list's heading."""
    told = []
    for caption, listed in re.findall(r"^## (.+)\n\n((?:- .*\n)+)", page, re.M):
        links = re.findall(r"^- \[(.+)\]\((.+)\.(?:md|ipynb)\)", listed, re.M)
        lines = "\n".join(f"{title} <{target}>" for title, target in links)
        told.append(f"```{{toctree}}\n:hidden:\n:caption: {caption}\n\n{lines}\n```\n")
    return "\n".join([page, *told])


def _documented(line: re.Match[str]) -> str:
    """The docstrings of a name, in place of a line that lists it."""
    module, _, name = line[1].rpartition(".")
    named = getattr(importlib.import_module(module), name)
    kind = "function" if not inspect.isclass(named) else "exception" if issubclass(named, Exception) else "class"
    return f"```{{eval-rst}}\n.. auto{kind}:: {line[1]}\n```\n"


def _reference(page: str) -> str:
    """The reference, each name in its lists shown with its docstrings."""
    return re.sub(r"^- `(.+?)`: .*\n", _documented, page, flags=re.M)


def _notebook(content: str) -> str:
    """A notebook as the Markdown that its cells are."""
    return "\n\n".join(_cell(cell) for cell in json.loads(content)["cells"])


MADE = {"index": _navigation, "api": _reference, "tutorial/tutorial": _notebook}


def _made(app: Any, name: str, source: list[str]) -> None:
    """A page as the site shows it."""
    if name in MADE:
        source[0] = MADE[name](source[0])


def setup(app: Any) -> None:
    """Let the site's pages be made of those in docs/."""
    app.connect("source-read", _made)
