"""`simulate --residual` on a rig that is no string: its columns are in the rig's own unit, and it says its worth."""

import benches
import pandas as pd
import programs
import pytest


@pytest.mark.long
def test_a_black_box_learns_the_friction_of_an_axis_that_the_library_may_not_name(tmp_path):
    file, mapping = tmp_path / "axis.csv", "pipeline/mappings/robot_axis.yaml"
    benches.axis(2, coulomb_nm=12.0, viscous_nm_s=6.0).to_csv(file, index=False)
    raw, out = tmp_path / "raw", tmp_path / "out"
    lacking = [word for id_ in ("friction_hysteresis", "viscous_loss", "backlash") for word in ("--without", id_)]
    for words in (
        ("pipeline.import_run", file, "--map", programs.ROOT / mapping, "--run", "axis", "--out", raw),
        ("pipeline.diagnose", raw / "axis", "--out", out, *lacking),
    ):
        assert programs.run(*words).returncode == 0
    diagnosis_path, answer = out / "axis" / "diagnosis.json", tmp_path / "answer.csv"
    done = programs.run(
        "pipeline.simulate", raw / "axis", "--simulation", diagnosis_path, "--residual", "--out", answer
    )
    assert done.returncode == 0 and "Nm with it: it helps. Add it to torque_nm to predict" in done.stdout
    table = pd.read_csv(answer)
    assert list(table) == ["time_s", "torque_nm", "residual_nm", "residual_low_nm", "residual_high_nm"]
    rubs = table["residual_nm"].abs().quantile([0.1, 0.9])
    assert 5.0 < rubs.loc[0.9] < 25.0, "12 Nm of a bearing, and 6 Nm s of drag"
