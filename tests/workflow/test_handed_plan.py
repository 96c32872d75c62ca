"""What a start hands its nodes comes back whole, and where a job lies that shares no files."""

import numpy as np
import pytest

from pipeline.ground.words.left_out import LeftOut
from pipeline.workflow import handed_plan
from pipeline.workflow.dag import Plan
from pipeline.workflow.storage import copy_of_storage


def plan_of(count):
    days = np.random.default_rng(1).integers(1, 29, count)
    names = [f"nylon-202611{day:02}-{run:05}" for run, day in enumerate(days)]
    bad = LeftOut("bad-1", "nylon", "raw/bad-1/run.yaml", "radius_mm", "must be above 0", "correct the line")
    plan = Plan({"nylon": names[1:]}, names[:1], [bad], [], [bad])
    return plan, {run: [f"raw/{run}/run.yaml", f"raw/{run}/recording.parquet"] for run in names}


def test_a_plan_comes_back_as_it_was():
    plan, files = plan_of(40)
    assert handed_plan.unpacked(handed_plan.packed(plan, files)) == (plan, files)


def test_ten_thousand_runs_fit_into_one_variable_and_what_does_not_is_left_to_the_node(monkeypatch):
    plan, files = plan_of(10_000)
    text = handed_plan.packed(plan, files)
    assert text and len(text) <= handed_plan.LONGEST and handed_plan.unpacked(text)[1] == files
    monkeypatch.setattr(handed_plan, "LONGEST", len(text) - 1)
    assert handed_plan.packed(plan, files) == ""


class Settings:
    default_storage_provider: str | None = "s3"
    default_storage_prefix: str | None = "s3://bucket/tsa/"
    local_storage_prefix = "/tmp/place"


def test_the_copy_of_a_storage_is_one_folder_by_its_whole_path():
    settings = Settings()
    assert copy_of_storage(settings) == "/tmp/place/s3/bucket/tsa"
    settings.default_storage_provider, settings.default_storage_prefix = "fs", "/bucket"
    assert copy_of_storage(settings) == "/tmp/place/fs/bucket"
    settings.local_storage_prefix = ".snakemake/storage"
    with pytest.raises(ValueError, match="relative"):
        copy_of_storage(settings)
    settings.default_storage_provider = None
    assert copy_of_storage(settings) == ""
