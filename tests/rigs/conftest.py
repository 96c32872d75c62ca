"""A rig's shipped mapping and a recording by another hand, through the programs that a person runs."""

import json
from pathlib import Path

import programs
import pytest
import yaml

ROOT = Path(__file__).parents[2]


def program(*words):
    """Run a module of the package; it must succeed."""
    done = programs.run(*words)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


@pytest.fixture
def diagnosed(tmp_path):
    """Import a file through a shipped mapping, some sections changed, adopt some effects, and diagnose the run."""

    def make(file, mapping, simulation=(), /, **changes):
        content = yaml.safe_load((ROOT / "pipeline" / "mappings" / f"{mapping}.yaml").read_text())
        content |= {"simulation": list(simulation)}
        for section, overrides in changes.items():
            content[section] = {**content.get(section, {}), **overrides}
        name = f"{mapping.replace('_', '-')}-{len(list(tmp_path.glob('*.yaml')))}"
        path = tmp_path / f"{name}.yaml"
        path.write_text(yaml.safe_dump(content))
        program("pipeline.import_run", file, "--map", path, "--run", name, "--out", tmp_path / "raw")
        program("pipeline.diagnose", tmp_path / "raw" / name, "--out", tmp_path / "verdicts")
        return json.loads((tmp_path / "verdicts" / name / "diagnosis.json").read_text())

    return make
