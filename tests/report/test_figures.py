import subprocess
import sys

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import pytest

from pipeline import schemas


@pytest.fixture(scope="module")
def material(tmp_path_factory):
    """A dataset and the INN's predictions of two seeds, as the DAG leaves them."""
    from test_dataset import NINE

    folder = tmp_path_factory.mktemp("processed") / "UHMWPE"
    schemas.write(NINE, schemas.DATASET, folder / "dataset.parquet")
    held = np.flatnonzero(NINE["within"] == "test")
    for seed in (0, 1):
        table = pd.DataFrame({"point": held})
        for column in ("displacement_mm", "motor_turns"):
            table[column] = NINE[column].to_numpy()[held] + 0.1 * seed
        schemas.write(table, schemas.PREDICTIONS, folder / "inn" / f"within-{seed}.predictions.parquet")
    return folder


def draw(material, out):
    inn = [str(material / "inn" / f"within-{seed}.predictions.parquet") for seed in (0, 1)]
    command = ["pipeline.report.figures", str(material / "dataset.parquet"), "--inn", *inn, "--out-dir", str(out)]
    subprocess.run([sys.executable, "-m", *command], check=True)
    return {path.name: path.read_bytes() for path in out.iterdir()}


def test_figures_are_drawn_and_the_same_every_time(material, tmp_path):
    first, second = draw(material, tmp_path / "a"), draw(material, tmp_path / "b")
    assert sorted(first) == ["figure_4.pdf", "figure_4.png", "figure_5.pdf", "figure_5.png"]
    assert first == second
    assert first["figure_4.png"].startswith(b"\x89PNG") and first["figure_5.pdf"].startswith(b"%PDF")


def test_figures_show_what_they_say(material):
    from pipeline.report.figures import figure_4, figure_5, with_median, with_nominal

    dataset = schemas.read(material / "dataset.parquet", schemas.DATASET)
    inn = with_median(dataset, sorted((material / "inn").glob("within-*.parquet")))
    assert inn["forward_mm"].to_numpy() == pytest.approx(inn["displacement_mm"].to_numpy() + 0.05)
    four, five = figure_4(with_nominal(dataset), "UHMWPE"), figure_5(inn, with_nominal(dataset), "UHMWPE")
    labels = [text.get_text() for text in four.axes[0].get_legend().get_texts()]
    assert labels == ["n=1", "n=3", "n=5", "n=7", "traditional model"]
    forward_error = four.axes[1].get_lines()[0].get_ydata()
    one = with_nominal(dataset).query("stroke == 1 and phase == 'winding'")
    assert forward_error == pytest.approx((one["forward_mm"] - one["displacement_mm"]).to_numpy())
    assert [axes.get_title(loc="left")[:3] for axes in five.axes] == ["(a)", "(b)", "(c)", "(d)", "(e)", "(f)"]
    plt.close("all")


def test_missing_strokes_are_said_not_drawn(material):
    from pipeline.report.figures import figure_4, figure_5, with_nominal

    dataset = schemas.read(material / "dataset.parquet", schemas.DATASET)
    few = with_nominal(dataset[dataset["stroke"] == 2])
    four, five = figure_4(few, "UHMWPE"), figure_5(few, few, "UHMWPE")
    assert "not recorded: n=1, n=3, n=5, n=7" in four.get_suptitle()
    assert "no stroke 9 recorded" in [text.get_text() for text in five.axes[2].texts]
    plt.close("all")
