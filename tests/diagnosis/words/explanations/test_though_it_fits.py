"""A page whose closest explanation fits says why that is no name, and what it would be."""

from made_content import content, full, leg, page

from pipeline.diagnosis.facts.recognised import recognised

BOX = {"motor_turns": [3.0, 9.0], "strokes": [1, 12], "phase": "all", "share": 0.8}


def unknown(**changes):
    """An unknown mismatch that eccentricity on a wheel takes away almost whole, and the judge does not believe."""
    diagnosis = content(verdict="unknown", mechanisms=[], alternatives=[], **changes)
    diagnosis["mismatch"] = {"rms_mm": 0.13, "location": BOX, "driver": ["twist"]}
    diagnosis["parameters"]["radius_mm"] = {"nominal": 0.55, "value": 0.5512, "low": 0.55, "high": 0.553}
    run = {"title": "another load, then half the speed", "load": 20.0, "fixed_load": False, "follows": "twist"}
    run["legs"] = [leg(2.0, 0.0, 20.0), leg(0.5, 0.0, 30.0), leg(10.0, 12.0, 30.0), leg(10.0, 0.0, 30.0)]
    diagnosis["next_run"] = run
    shown = [([], "nothing", 0.13, None), (["wear"], "not enough", 0.125, 0.01)]
    shown += [(["eccentricity", "wear"], "not needed", 0.0312, 0.004), (["eccentricity"], "not enough", 0.0314, 0.07)]
    diagnosis["evidence"] |= {
        "calibrated_mm": 0.13, "nominal_mm": 0.64, "moved_sigma": {"radius_mm": 0.6}, "probability_of_none": 0.91,
        "tolerance": {"radius_mm": 0.0165}, "chosen_without_them": [], "closest_without_them": ["eccentricity"],
        "explanations": [
            {"ids": ids, "standing": standing, "left_mm": left_mm, "bent_mm": left_mm, "probability": share}
            for ids, standing, left_mm, share in shown
        ],
    }  # fmt: skip
    parameters = {"wheel_mm": 12.8955, "sine_mm": 0.195, "cosine_mm": 0.189}
    diagnosis["closest"] = {"ids": ["eccentricity"], "simulation": [{"id": "eccentricity", "parameters": parameters}]}
    return diagnosis


def joined(text):
    return " ".join(text.split())


def test_what_fits_and_is_no_name_has_a_reason_and_its_constants():
    """`eccentricity 100 % 0.013 mm (1.1) 7 % not likely enough` stood there without a reason."""
    text = joined(page(unknown()))
    assert "eccentricity fits and is no name: a formula with free numbers can copy other physics." in text
    assert "about 91 % were physics that the library lacks, 7 % were eccentricity." in text
    assert "as fitted, once in every 12.9 mm that the sensor reads, as a wheel of that circumference turns." in text
    assert "is unlike" not in text
    assert (
        "circumference turns. What would show it: one slow stroke: the ripple follows the turn, not the time." in text
    )
    diagnosis = unknown()
    diagnosis["evidence"]["looks_like"] = {"eccentricity": 0.0097, "wear": 0.2, "outside": 0.31}
    looks = "The pattern of what is missing is unlike the one that eccentricity leaves in simulated recordings."
    assert looks in joined(page(diagnosis))
    assert "eccentricity wheel_mm 12.9, sine_mm 0.195, cosine_mm 0.189." in joined(full(unknown()))
    assert "less than 1 % adds too little" in joined(page(unknown()))


def test_the_closest_has_its_error_of_the_whole_recording_too():
    row = next(line for line in page(unknown()).splitlines() if "closest, no name: eccentricity" in line)
    assert "0.031 mm (1.0 times the noise)" in row, "a dash stood in the column that the fit has seen"


def test_the_size_is_beside_the_noise_and_the_report_has_place_and_driver():
    assert "noise taken off (4.3 times the noise), mostly at 3 to 9 turns." in joined(page(unknown()))
    report = joined(full(unknown()).partition("To report it\n")[2])
    assert "noise taken off, mostly at 3 to 9 turns, following the twist; the errors on the unseen strokes" in report


def test_the_run_says_why_it_asks_again_what_the_page_has_said():
    """`It follows the twist.` stood above `Make the run that shows whether that follows the twist.`"""
    asks = "it follows the twist here; see whether it does so in this run as well."
    assert asks in joined(page(unknown()))
    assert "follows the twist, as here, or what went along with it." in joined(full(unknown()))


def test_a_load_that_was_recorded_needs_no_care():
    care = "Only if the rig bears so much."
    assert care in joined(full(unknown()))
    covered = {"load": [18.0, 60.0], "speed_per_s": [1.0, 2.0], "longest_hold_s": 0.0, "longest_rest_s": 0.0}
    assert care not in joined(full(unknown(evidence__covered=covered)))
    assert care in joined(full(unknown(evidence__covered=covered | {"load": [18.0, 21.0]})))


def test_the_table_of_dimensions_stands_where_the_page_sends_a_reader_to_it():
    text = full(unknown())
    assert "(how far each moved: Dimensions)" in joined(text)
    assert "\nDimensions\n" in text and "radius" in text.partition("\nDimensions\n")[2]


def test_what_would_be_the_same_of_single_samples_is_not_said():
    """`Of single samples, 0.13 mm would be about 0.13 mm` stood there."""
    near = {"floor_mm": 0.011, "step_s": 0.06, "calibrated_mm": 0.13}
    text = joined(full(unknown(fit__noise_floor_mm=0.016)))
    assert "Of single samples" in joined(full(content(evidence__floor_mm=0.018, evidence__step_s=0.05)))
    diagnosis = unknown(fit__noise_floor_mm=0.016)
    diagnosis["evidence"] |= near
    text = joined(full(diagnosis))
    assert "The left column is of averages" in text and "Of single samples" not in text


class Weighed:
    def __init__(self, ids, **signs):
        self.ids, self.signs = ids, signs


class Study:
    def __init__(self, verdict, *weighed):
        self.verdict = verdict
        self.judged = type("Judged", (), {"weighed": weighed})


def test_the_recogniser_is_told_of_an_unknown_mismatch_alone():
    weighed = (
        Weighed(("wear",), alike=-3.93, alike_outside=-1.14),
        Weighed(("x_clock",), alike=-2.0, alike_outside=-1.14),
        Weighed(("wear", "creep"), alike=0.0, alike_outside=-1.14),
    )
    (looks,) = recognised(Study("unknown", *weighed)).values()
    assert list(looks) == ["wear", "outside"]
    assert abs(looks["wear"] - 0.0096) < 1e-3 and abs(looks["outside"] - 0.31) < 1e-3
    assert recognised(Study("explained", *weighed)) == {} and recognised(Study("unknown", Weighed(("wear",)))) == {}
