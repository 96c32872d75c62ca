"""Few-shot errors: what is asked is never shown, what is shown is only the new string's first strokes."""

import numpy as np
import pandas as pd
import pytest

from pipeline.ground.errors import BadInput
from pipeline.ground.stored import schemas
from pipeline.models.interface import about, make_model
from pipeline.stages.campaign import coverage, few_shot, floor
from pipeline.stages.campaign.adapt import Adaptation
from pipeline.stages.campaign.campaign_tables import COVERAGE, FEW_SHOT
from pipeline.stages.campaign.coverage import LEFT_OUT, LEVELS, of_string
from pipeline.stages.campaign.few_shot import ASKED_AFTER, SHOTS, asked_and_shown, curves, fitted, reads
from pipeline.stages.campaign.floor import floors
from pipeline.stages.campaign.points import SCHEMA


@pytest.fixture(scope="module")
def tables(campaign):
    return {name: curves(name, {}, campaign, 0) for name in ("polynomial", "calibrated", "traditional")}


@pytest.mark.long
def test_every_new_string_is_asked_about_after_each_number_of_strokes(tables, campaign):
    new = sorted(campaign.loc[campaign["strings"] == "test", "string"].unique())
    for name, table in tables.items():
        assert list(table.columns) == FEW_SHOT.names and np.isfinite(table[["forward_mm", "inverse_turns"]]).all().all()
        expected = (["transfer"] if name != "calibrated" else []) + (["alone"] if name != "polynomial" else [])
        assert sorted(table["how"].unique()) == sorted(expected)
        for _, group in table.groupby(["how", "shots"]):
            assert sorted(group["string"]) == new
        assert sorted(table["shots"].unique()) == sorted(SHOTS)


@pytest.mark.long
def test_what_is_asked_is_never_shown(campaign, monkeypatch):
    """With every asked answer replaced by poison no model and no correction changes: only the errors do."""
    asked_mask = (campaign["strings"] == "test") & (campaign["stroke"] > ASKED_AFTER)
    poison = {"displacement_mm": 1e6, "motor_turns": -1e6}
    poisoned = campaign.assign(**{name: campaign[name].mask(asked_mask, value) for name, value in poison.items()})
    learnt: dict[str, list[object]] = {}
    for kind, points in (("clean", campaign), ("poisoned", poisoned)):
        learnt[kind] = []
        adaptation = Adaptation(fitted("polynomial", {}, points, 0), points[points["strings"] == "tune"])
        for rows, shown in asked_and_shown(points):
            assert (rows["displacement_mm"] == 1e6).all() == (kind == "poisoned") and rows["stroke"].min() > max(SHOTS)
            learnt[kind] += [adaptation.to(few).weights.tolist() for few in shown.values()]
    assert learnt["clean"] == learnt["poisoned"] and len(learnt["clean"]) == 12 * len(SHOTS)

    fits: list[pd.DataFrame] = []

    def spy(name, **settings):
        model = make_model(name, **settings)
        fit = model.fit
        model.fit = lambda points, seed: (fits.append(points), fit(points, seed))[1]
        return model

    monkeypatch.setattr(few_shot, "make_model", spy)
    curves("polynomial", {}, poisoned, 0)
    curves("calibrated", {}, poisoned[poisoned["string"] <= "made-007"], 0)
    assert len(fits) == 1 + 2 * (len(SHOTS) - 1)  # made-006 and made-007 are new
    assert all(few["displacement_mm"].abs().max() < 1e3 and few["motor_turns"].abs().max() < 1e3 for few in fits)


def test_the_answer_is_not_in_the_question(campaign):
    class Peeping:
        def forward(self, points):
            assert points["displacement_mm"].isna().all()
            return np.zeros(len(points))

        def inverse(self, points):
            assert points["motor_turns"].isna().all()
            return np.zeros(len(points))

    asked_rows, _ = next(asked_and_shown(campaign))
    forward, inverse = few_shot.errors(Peeping(), asked_rows)
    assert forward == pytest.approx(np.sqrt(np.mean(asked_rows["displacement_mm"] ** 2)))
    assert inverse == pytest.approx(np.sqrt(np.mean(asked_rows["motor_turns"] ** 2)))


def test_models_learn_on_the_strings_to_learn_on_and_on_so_many_points(campaign, monkeypatch):
    seen: list[pd.DataFrame] = []

    class Spy:
        def fit(self, points, seed):
            seen.append(points)

    monkeypatch.setattr(few_shot, "TRAINING_POINTS", 1000)
    monkeypatch.setattr(few_shot, "make_model", lambda name: Spy())
    fitted("spy", {}, campaign, 0)
    assert set(seen[0]["strings"]) == {"train"} and 800 <= len(seen[0]) <= 1000
    assert seen[0]["string"].nunique() == 12 and set(seen[0]["direction"]) == {-1, 1}


@pytest.mark.long
def test_an_analytic_model_that_learns_nothing_errs_the_same_whatever_it_is_shown(tables):
    for how, same in (("alone", True), ("transfer", False)):
        rows = tables["traditional"][tables["traditional"]["how"] == how]
        assert (rows.groupby("string")["forward_mm"].nunique() == 1).all() == same
    calibrated = tables["calibrated"].groupby("shots")["forward_mm"].median()
    nominal = tables["traditional"][tables["traditional"]["how"] == "alone"]["forward_mm"].median()
    assert calibrated[0] == pytest.approx(nominal) and calibrated[5] < calibrated[0]


def test_what_a_model_reads_is_found_by_asking(campaign):
    shaken = campaign.assign(load_n=campaign["string"].map(lambda name: 10.0 + int(name[-3:])))
    new = shaken[shaken["strings"] == "test"]
    tiny = {"blocks": 2, "width": 8, "layers": 1, "epochs": 1}
    # of the INN's inputs b, l and r are the same on all made strings
    assert reads(fitted("inn", tiny, shaken, 0), new) == "stroke"
    assert reads(fitted("polynomial", {}, shaken, 0), new) == "direction stroke load_n material"


def test_the_floor_is_the_noise(campaign):
    floor_sizes = np.array([sizes for _, _, *sizes in floors(campaign)])
    assert floor_sizes.shape == (12, 2) and np.median(floor_sizes[:, 0]) == pytest.approx(0.05, rel=0.1)


def test_coverage_is_of_the_last_strokes_from_the_others(campaign):
    rows = campaign[campaign["string"] == "made-004"].reset_index(drop=True)
    table = of_string(rows, "polynomial", {}, 0)
    assert list(table.columns) == COVERAGE.names and len(table) == 2 * LEFT_OUT * len(LEVELS)
    assert (table.groupby(["map", "ahead"])["held"].apply(lambda shares: shares.is_monotonic_increasing)).all()
    assert (table["points"] + table["outside"] == 40).all()
    last = rows["stroke"] > rows["stroke"].max() - LEFT_OUT
    far = rows.assign(displacement_mm=rows["displacement_mm"].where(~last, 1e6))
    poisoned = of_string(far, "polynomial", {}, 0)
    forward = poisoned["map"] == "forward"
    assert (poisoned.loc[forward, "held"] == 0.0).all()  # nothing of it was learnt
    assert poisoned.loc[forward, "width"].equals(table.loc[forward, "width"])
    assert (poisoned.loc[~forward, "outside"] == 40).all() and poisoned.loc[~forward, "held"].isna().all()


def test_too_few_strings_are_refused_in_words(campaign, tmp_path, monkeypatch, capsys):
    schemas.write(campaign[campaign["strings"] == "train"], SCHEMA, tmp_path / "points.parquet")
    arguments = ["few_shot", str(tmp_path / "points.parquet"), "--model", "traditional", "--out", str(tmp_path / "out")]
    monkeypatch.setattr("sys.argv", arguments)
    with pytest.raises(SystemExit) as status:
        few_shot.main()
    assert status.value.code == 2 and "too few strings" in capsys.readouterr().err


def test_strokes_shown_are_counted_from_the_first_recorded_one(campaign):
    used = campaign.assign(stroke=campaign["stroke"] + 100)
    for (asked_rows, shown), (later, few) in zip(asked_and_shown(campaign), asked_and_shown(used), strict=True):
        assert (later["stroke"] == asked_rows["stroke"] + 100).all()
        assert [len(rows) for rows in few.values()] == [len(rows) for rows in shown.values()]


def test_a_new_string_with_no_stroke_left_to_ask_about_is_refused(campaign):
    new = sorted(campaign.loc[campaign["strings"] == "test", "string"].unique())[0]
    short = campaign[(campaign["string"] != new) | (campaign["stroke"] <= ASKED_AFTER)]
    with pytest.raises(BadInput, match=new):
        list(asked_and_shown(short))


def test_twisted_pairs_can_be_adapted_to(campaign):
    pairs = campaign.assign(actuator="twisted_pair", torsion_zone_mm=np.nan, separator_mm=np.nan)
    assert np.isfinite(curves("traditional", {}, pairs, 0)[["forward_mm", "inverse_turns"]]).all().all()


def test_an_interval_without_end_holds_nothing(campaign):
    rows = campaign[(campaign["string"] == "made-004") & (campaign["stroke"] <= 5)].reset_index(drop=True)
    table = of_string(rows, "polynomial", {}, 0)
    assert (table["points"] == 0).all() and (table["outside"] == 40).all() and table["held"].isna().all()


@pytest.mark.parametrize("program", [few_shot, coverage, floor])
def test_a_file_that_is_no_campaign_is_refused_in_words(program, tmp_path, monkeypatch, capsys):
    (tmp_path / "points.parquet").write_text("no table")
    model = [] if program is floor else ["--model", "polynomial"]
    monkeypatch.setattr("sys.argv", ["it", str(tmp_path / "points.parquet"), *model, "--out", str(tmp_path / "out")])
    with pytest.raises(SystemExit) as status:
        program.main()
    assert status.value.code == 2 and "no Parquet table" in capsys.readouterr().err


@pytest.mark.parametrize("settings", ["{", "[1]", '{"colour": 1}'])
def test_settings_that_are_none_are_refused_in_words(settings, monkeypatch, capsys):
    for program in (few_shot, coverage):
        words = ["it", "points.parquet", "--model", "polynomial", "--settings", settings, "--out", "out"]
        monkeypatch.setattr("sys.argv", words)
        with pytest.raises(SystemExit) as status:
            program.main()
        assert status.value.code == 2 and "--settings" in capsys.readouterr().err


@pytest.mark.long
@pytest.mark.parametrize(("name", "least"), [("traditional", 0), ("calibrated", 0), ("spline", 1), ("inn", None)])
def test_what_learns_alone_says_from_how_many_strokes(tables, campaign, name, least):
    """The spline cannot answer unfitted; the equations can, and so their row of no strokes is there."""
    assert about(name).least_strokes_alone == least
    if least is not None:
        two_new = campaign[campaign["string"] <= "made-007"]
        table = tables[name] if name in tables else curves(name, {}, two_new, 0)
        assert table.loc[table["how"] == "alone", "shots"].min() == least
