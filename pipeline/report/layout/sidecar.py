"""The file beside a csv table: its columns and its configuration, as W3C "CSV on the Web" metadata."""

import json
from collections.abc import Iterable
from pathlib import Path

from ...ground.stored.files import write_text
from .made_by import MadeBy, sentence

Column = tuple[str, str, str]  # head, datatype (string, integer, number or boolean), what it holds
STATUS = {
    "default": "result of the default configuration", "small": "small fit: not a result",
    "own": "not the default configuration", "unknown": "configuration not known",
}  # fmt: skip


def metadata(name: str, title: str, columns: Iterable[Column], mark: MadeBy) -> dict[str, object]:
    """Content of the file beside the table `name`."""
    described = [{"titles": head, "datatype": kind, "dc:description": words} for head, kind, words in columns]
    return {
        "@context": ["http://www.w3.org/ns/csvw", {"@language": "en"}],
        "url": name,
        "dc:title": title,
        "dc:provenance": sentence(mark),
        "schema:creativeWorkStatus": STATUS[mark.kind],
        **({"schema:isBasedOn": mark.name, "schema:version": mark.digest} if mark.name else {}),
        "dialect": {"encoding": "utf-8", "header": True, "delimiter": ","},
        "tableSchema": {"columns": described},
    }


def describe(table: Path, title: str, columns: Iterable[Column], mark: MadeBy) -> None:
    """Write `<table>-metadata.json`, where readers of CSV on the Web look for it."""
    content = metadata(table.name, title, columns, mark)
    path = table.with_name(f"{table.name}-metadata.json")
    write_text(path, json.dumps(content, indent=1, ensure_ascii=False) + "\n")
