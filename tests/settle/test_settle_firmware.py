"""The loop moves the reference firmware on a simulated Arduino Uno, from nothing to a right and firm verdict."""

import json
from pathlib import Path

import pytest
from firmware.builds import for_the_uno, running, simulator
from settle_bench import ended, program

RIG = ("-DTOP_TURNS=14L", "-DSTEPS_PER_S=8000L", "-DRATE_HZ=40")
STRING = ("--actuator", "twisted_pair", "--radius-mm", 1.0, "--length-mm", 300, "--load-n", 20, "--string-id", "a")
LIMITS = "{turns: [0, 14], turns_per_s: 5, seconds: 300}"
LATE_S, SHAKE_MM = 0.03, 0.1  # what the bench conceals: a sensor that is late, and its noise


@pytest.mark.long
def test_on_a_simulated_uno_the_loop_moves_the_motor_and_names_a_late_sensor(tmp_path: Path) -> None:
    uno, firmware = simulator(tmp_path / "uno"), for_the_uno(tmp_path / "rig.elf", *RIG)
    done = ended(tmp_path, "new_run", "a-1", "--material", "example", *STRING, "--out", "raw")
    assert done.returncode == 0, done.stdout
    with running(uno, firmware, LAG_S=LATE_S, SHAKE_MM=SHAKE_MM) as port:
        words = ("--port", port, "--approve", "auto", "--limits", LIMITS, "--out", "out")
        loop = program(tmp_path, "settle", "raw/a-1", *words)
        printed = loop.communicate(timeout=1200)[0]
    assert loop.returncode == 0, printed
    assert "step 0: proposed: a first recording: 6 equal strokes to 14 turns" in printed, printed
    content = json.loads((tmp_path / "out" / "settled.json").read_text())
    assert (content["verdict"], content["mechanisms"]) == ("explained", ["sensor_lag"]), printed
    capture = json.loads((tmp_path / "raw" / "a-1" / "capture.json").read_text())
    assert content["spent"]["strokes"] >= 6 and capture["frames"]["lost"] == 0
