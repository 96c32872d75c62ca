"""The profiles of a cluster bundle rules that there are, and say what the usual profile says."""

import re
from pathlib import Path

import pytest
import yaml

from pipeline.workflow.needs import Needs

ROOT = Path(__file__).parents[2]
PROFILES = [ROOT / "env" / name / "profile.yaml" for name in ("slurm", "slurm-unshared")]
# jobs that are sent alone: they take long, or there is one of each in all, or one that fails must take no other with it
ALONE = {"ask_baselines", "left_out", "twins", "campaign", "coverage", "real_verdicts_together", "transfer"}


def read(path):
    return yaml.safe_load(path.read_text(encoding="utf-8"))


@pytest.mark.parametrize("path", PROFILES, ids=lambda path: path.parent.name)
def test_a_profile_of_a_cluster_says_what_the_usual_one_says_and_bundles_rules_that_there_are(path):
    profile = read(path)
    assert read(ROOT / "env" / "profile" / "profile.yaml").items() <= profile.items()
    groups = dict(assignment.split("=") for assignment in profile["groups"])
    assert set(groups) | ALONE == set(Needs({})) and not set(groups) & ALONE
    assert {assignment.split("=")[0] for assignment in profile["group-components"]} <= set(groups.values())
    # the rule that ends a main job as failed stands alone: in a bundle it would take finished pages with it
    assert "left_out" not in groups


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


def test_the_page_names_every_bundle_where_one_of_them_is_changed():
    """Snakemake takes `--group-components` instead of the profile's: what is not named is sent alone."""
    page = (ROOT / "docs" / "cluster.md").read_text(encoding="utf-8")
    (words,) = set(re.findall(r"--group-components ([^`]+)`", page))
    sizes = dict(word.split("=") for word in words.split())
    profile = dict(word.split("=") for word in read(PROFILES[0])["group-components"])
    assert sizes == profile | {"fits": "1"}
