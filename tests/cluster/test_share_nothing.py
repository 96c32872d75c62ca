"""Jobs share nothing but files: each opens what its rule declares, and what comes with the code, and no more."""

import base64
import json
import shutil
from collections import defaultdict

import pytest

pytestmark = [pytest.mark.long, pytest.mark.skipif(shutil.which("strace") is None, reason="not installed: strace")]

# what whoever starts a job has: the code, and a file of words that evaluating the Snakefile writes
WITH_THE_CODE = ("pipeline", ".snakemake/words")


def declared(folder):
    """By log, the inputs and outputs that Snakemake has written down of the job."""
    jobs = defaultdict(lambda: ([], []))
    for path in (folder / ".snakemake" / "metadata").rglob("*"):
        if path.is_file():
            job = json.loads(path.read_text())
            name = str(path.relative_to(folder / ".snakemake" / "metadata")).replace("/@", "").lstrip("@")
            inputs, outputs = jobs[job["log"][0]]
            inputs += job["input"]
            outputs.append(base64.b64decode(name).decode())
    return jobs


def beyond(names, allowed):
    """Names that are none of the allowed ones, nor lie in one of them that is a folder."""
    return [
        name
        for name in names
        if not any(name == allowed_name or name.startswith(f"{allowed_name}/") for allowed_name in allowed)
    ]


def is_cache(name):
    """Whether a file is what Python or numba compiled of the code: any job may write it, and none needs it."""
    return name.startswith("pipeline/") and "/__pycache__/" in name


def test_a_job_opens_what_its_rule_declares_and_no_more(local):
    folder, jobs = local
    of_rules = declared(folder)
    assert {job["log"] for job in jobs} == set(of_rules) and len(jobs) > 40
    for job in jobs:
        inputs, outputs = of_rules[job["log"]]
        read, written = ([name for name in job[kind].split("|") if name] for kind in ("read", "written"))
        written = [name for name in written if not is_cache(name)]
        assert written and not beyond(written, [*outputs, job["log"]]), job
        assert not beyond(read, [*inputs, *outputs, *WITH_THE_CODE]), job
        assert not inputs or len(beyond(read, inputs)) < len(read), job
