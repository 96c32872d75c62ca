"""A run's diagnosis as the rules before a page leave it: words, and with a verdict its content and figures."""

import json


def made_verdict(folder, words, content=None):
    """Write the files of one diagnosis; returns its folder."""
    folder.mkdir(parents=True)
    (folder / "verdict.txt").write_text(words + "\n")
    if content:
        (folder / "diagnosis.json").write_text(json.dumps(content))
        (folder / "diagnosis.png").write_bytes(b"")
        (folder / "diagnosis.pdf").write_bytes(b"")
    return folder
