"""The profiles of a cluster bundle rules that there are, and say what the usual profile says."""

from pathlib import Path

import pytest
import yaml

from pipeline.workflow.needs import Needs

ROOT = Path(__file__).parents[2]
PROFILES = [ROOT / "env" / name / "profile.yaml" for name in ("slurm", "slurm-unshared")]


def read(path):
    return yaml.safe_load(path.read_text(encoding="utf-8"))


@pytest.mark.parametrize("path", PROFILES, ids=lambda path: path.parent.name)
def test_a_profile_of_a_cluster_says_what_the_usual_one_says_and_bundles_rules_that_there_are(path):
    profile = read(path)
    assert read(ROOT / "env" / "profile" / "profile.yaml").items() <= profile.items()
    groups = dict(one.split("=") for one in profile["groups"])
    assert set(groups) <= set(Needs())
    assert {one.split("=")[0] for one in profile["group-components"]} <= set(groups.values())
    # the rule that ends a main job as failed stands alone: in a bundle it would take finished pages with it
    assert "all_taken" not in groups


def test_both_profiles_of_a_cluster_differ_in_what_is_shared_alone():
    shared, unshared = map(read, PROFILES)
    assert {name for name in unshared if unshared[name] != shared.get(name)} == {
        "slurm-logdir",
        "shared-fs-usage",
        "default-storage-provider",
        "local-storage-prefix",
        "remote-job-local-storage-prefix",
    }
    assert set(shared) <= set(unshared)
