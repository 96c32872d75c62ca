"""The site that these pages make: `python -m sphinx -W --keep-going docs reports/site`.

It is searched without a server, and nothing in it is fetched from elsewhere.
"""

import json
import sys
from pathlib import Path
from typing import Any

DOCS = Path(__file__).resolve().parent
sys.path.insert(0, str(DOCS.parent))

import pipeline  # noqa: E402

sys.modules["twistbench"] = pipeline  # its name where it is installed, and the one that the reference shows

project, author = "twistbench", "the twistbench team"
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
        return f"```{{raw}} html\n{''.join(shown['text/html'])}\n```"
    text = "".join(output.get("text", shown.get("text/plain", ""))).rstrip()
    return f"```text\n{text}\n```" if text else ""


def _cell(cell: dict[str, Any]) -> str:
    """A notebook's cell, and what it gave, as Markdown."""
    text = "".join(cell["source"])
    if cell["cell_type"] == "markdown":
        return text
    return "\n\n".join([f"```python\n{text}\n```", *filter(None, map(_output, cell.get("outputs", [])))])


def _as_markdown(app: Any, name: str, source: list[str]) -> None:
    """A notebook as a page: it is read as the Markdown that its cells are."""
    if app.env.doc2path(name).suffix == ".ipynb":
        source[0] = "\n\n".join(_cell(cell) for cell in json.loads(source[0])["cells"])


def setup(app: Any) -> None:
    """Let notebooks be pages."""
    app.connect("source-read", _as_markdown)
