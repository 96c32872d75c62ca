"""A length or a stiffness that is wrong by 1000 is refused or asked about, wherever a run comes in at the door."""

import programs
import pytest
import yaml
from made_recording import content, recording

SIZES = {"--radius-mm": "0.4", "--length-mm": "400", "--torsion-zone-mm": "150", "--separator-mm": "8"}


@pytest.fixture
def described(tmp_path):
    def run(*words, **sizes):
        options = {**SIZES, **{f"--{key.replace('_', '-')}": value for key, value in sizes.items()}}
        flat = [word for pair in options.items() for word in pair if pair[1]]
        return programs.run(
            "pipeline.new_run", "a-01", "--material", "UHMWPE", *flat, *words, "--out", tmp_path / "raw"
        )

    return run


def test_a_length_in_metres_is_refused_with_its_torsion_zone(described, tmp_path):
    """0.4 mm were taken, with a tolerance of 2 mm."""
    for sure in ((), ("--sure",)):
        done = described(*sure, length_mm="0.4")
        assert done.returncode == 2 and not (tmp_path / "raw").exists(), done.stdout
        assert "string.length_mm: is 0.4 mm, but the torsion zone within it is 150 mm. Mend: " in done.stderr
        assert "give string.length_mm and rig.torsion_zone_mm in mm" in done.stderr


@pytest.mark.parametrize(
    ("sizes", "says"),
    [
        ({"length_mm": "140"}, "string.length_mm: is 140 mm, less than the torsion zone within it, 150 mm"),
        ({"length_mm": "400000"}, "string.length_mm: is 400 m, which no bench has"),
        ({"stiffness_n_per_mm": "9000"}, "string.stiffness_n_per_mm: is 9000 N/mm, a modulus of 7162 GPa"),
        ({"torsion_zone_mm": "0.15"}, "tolerance.torsion_zone_mm: is 1 mm, the default, 667% of 0.15 mm"),
        ({"separator_mm": "0.008"}, "tolerance.separator_mm: is 0.5 mm, the default, 6250% of 0.008 mm"),
    ],
)
def test_a_dimension_in_another_unit_is_asked_about(described, tmp_path, sizes, says):
    done = described(**sizes)
    assert done.returncode == 2 and f"/a-01/run.yaml: {says}" in done.stderr, done.stderr
    assert "if it is right as it is, add --sure" in done.stderr and not (tmp_path / "raw").exists()
    done = described("--sure", **sizes)
    assert done.returncode == 0 and f"run.yaml: {says}" in done.stderr, done.stderr


def test_a_pair_whose_default_tolerance_is_larger_than_its_length_is_asked_about(described):
    pair = {"torsion_zone_mm": "", "separator_mm": ""}
    done = described("--actuator", "twisted_pair", length_mm="0.4", **pair)
    assert done.returncode == 2 and "tolerance.length_mm: is 2 mm, the default, 500% of 0.4 mm" in done.stderr
    done = described("--actuator", "twisted_pair", length_mm="4", **pair, tolerance="{length_mm: 0.1}")
    assert done.returncode == 0 and "warning" not in done.stderr, done.stderr  # the mend that was given


def test_an_import_says_a_stiffness_in_newtons_per_metre_and_refuses_a_length_in_metres(tmp_path):
    file, mapping = tmp_path / "log.csv", tmp_path / "map.yaml"
    recording().to_csv(file, index=False)
    for key, value, status, says in (
        ("stiffness_n_per_mm", 9000, 0, f"warning: {mapping}: string.stiffness_n_per_mm: is 9000 N/mm, a modulus of "),
        ("length_mm", 0.4, 2, "string.length_mm: is 0.4 mm, but the torsion zone within it is 150 mm. Mend: "),
    ):
        whole = content("x", run=None)
        mapping.write_text(yaml.safe_dump({**whole, "string": {**whole["string"], key: value}}))
        done = programs.run(
            "pipeline.import_run", file, "--map", mapping, "--run", f"a-{value:.0f}", "--out", tmp_path / "raw"
        )
        assert done.returncode == status and says in done.stderr, done.stderr
