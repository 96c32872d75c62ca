"""A campaign's points: thinned evenly, parted by whole strings, every material in every part."""

import shutil
from pathlib import Path

import numpy as np
import programs
import pytest
import yaml

from pipeline.ground.errors import BadInput
from pipeline.ground.stored import schemas
from pipeline.run.samples import read_samples
from pipeline.run.strokes import segment
from pipeline.stages.campaign.points import MOST_POINTS, SCHEMA, campaign_points, labelled, string_points
from pipeline.stages.dataset import points_of
from pipeline.string.history import Recorded, tare_mm

ROOT = Path(__file__).parents[3]


@pytest.fixture(scope="module")
def runs(tmp_path_factory):
    """Run folders of twenty short strings, four of each material."""
    out = tmp_path_factory.mktemp("campaign") / "runs"
    words = ["--strings", 20, "--seed", 2, "--strokes", 2, "--out", out]
    assert programs.run("pipeline.rig.campaign", *words).returncode == 0
    return out


@pytest.fixture(scope="module")
def points(runs):
    return campaign_points(runs)


def test_no_string_is_in_two_parts_and_every_material_is_in_all(points):
    parts = points.groupby("string")["strings"].unique()
    assert len(parts) == 20 and (parts.map(len) == 1).all()
    by_material = points.groupby("material")["strings"].unique().map(set)
    assert len(by_material) == 5 and all(parts == {"train", "tune", "test"} for parts in by_material)
    counts = points.groupby("strings")["string"].nunique()
    assert counts.to_dict() == {"train": 10, "tune": 5, "test": 5}


def test_the_parts_hang_on_names_alone_not_on_the_order_of_the_points(points):
    mixed = points.sample(frac=1.0, random_state=3)
    again = labelled(mixed.drop(columns="strings"))
    assert (again.sort_index()["strings"] == points["strings"]).all()


def test_columns_and_types_are_the_schemas_and_nothing_measured_is_missing(points, tmp_path):
    assert list(points.columns) == SCHEMA.names
    schemas.write(points, SCHEMA, tmp_path / "points.parquet")
    assert len(schemas.read(tmp_path / "points.parquet", SCHEMA)) == len(points)
    assert np.isfinite(points.select_dtypes("number")).all().all()
    for name in ("load_n", "radius_mm", "torsion_zone_mm", "separator_mm", "length_mm", "stiffness_n_per_mm"):
        assert (points.groupby("string")[name].nunique() == 1).all() and points[name].nunique() > 10


def test_a_passage_is_thinned_evenly_to_so_many_points_and_keeps_its_first(runs, points):
    passages = points.groupby(["string", "stroke", "phase"])
    assert passages.size().max() == MOST_POINTS and (passages.size() > MOST_POINTS // 2).all()
    folder = next(iter(sorted(runs.iterdir())))
    run, samples = read_samples(folder)
    recorded = Recorded(run, "", samples, segment(samples, samples.columns[1], folder))
    whole = points_of(recorded, run.string.strokes_before, tare_mm(recorded))
    kept = string_points([folder])
    for key, rows in whole.groupby(["stroke", "phase"]):
        thin = kept[(kept["stroke"] == key[0]) & (kept["phase"] == key[1])]
        assert thin["time_s"].iloc[0] == rows["time_s"].iloc[0]
        assert set(thin["time_s"]) <= set(rows["time_s"]) and len(thin) <= MOST_POINTS < len(rows)
        gaps = np.diff(np.flatnonzero(rows["time_s"].isin(thin["time_s"])))
        assert gaps.max() - gaps.min() <= 1


def test_a_folder_without_runs_is_refused(tmp_path):
    with pytest.raises(BadInput, match="there is none"):
        campaign_points(tmp_path)


def test_runs_of_one_string_continue_each_other(runs, tmp_path):
    folder = next(iter(sorted(runs.iterdir())))
    for name in ("first", "second"):
        shutil.copytree(folder, tmp_path / name)
        content = yaml.safe_load((folder / "run.yaml").read_text())
        content["run"], content["string"]["id"] = name, "one"
        (tmp_path / name / "run.yaml").write_text(yaml.safe_dump(content))
    all_points = campaign_points(tmp_path)
    assert set(all_points["string"]) == {"one"} and sorted(all_points["stroke"].unique()) == [1, 2, 3, 4]
    assert all_points.groupby("run")["stroke"].max().to_dict() == {"first": 2, "second": 4}
    content["string"]["material"] = "straw"
    (tmp_path / "second" / "run.yaml").write_text(yaml.safe_dump(content))
    with pytest.raises(BadInput, match="straw"):
        campaign_points(tmp_path)
