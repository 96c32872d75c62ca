"""The plan says which cases there are; fresh ones are one number away, and no name tells what hides."""

from pathlib import Path

import pytest
import yaml

from pipeline.ground.errors import BadInput
from pipeline.proof.draws import NAMED, OPEN_SET
from pipeline.proof.plan import batches, effect_names, plan, read, written

CONFIG = yaml.safe_load((Path(__file__).parents[2] / "pipeline" / "config" / "default.yaml").read_text())["proof"]


def count(**wanted):
    return sum(all(getattr(case, key) == value for key, value in wanted.items()) for case in plan(CONFIG))


def test_effects_by_file_are_the_effects_that_can_be_drawn():
    assert effect_names(open_set=False) == sorted(NAMED) and effect_names(open_set=True) == sorted(OPEN_SET)


def test_the_full_proof_has_what_was_promised():
    controls = sum(count(stratum=stratum) for stratum in ("none", "parameters", "noise"))
    assert controls >= 300 and count(stratum="pair") >= 30 and count(stratum="open") >= 24
    for kappa in (0.25, 0.5, 1.0, 3.0):
        for name in NAMED:
            assert count(stratum="single", protocol="rich", effects=(name,), kappas=(kappa,), without="") >= 1
    for name in NAMED:
        assert count(protocol="poor", effects=(name,), kappas=(1.0,)) and count(without=name, effects=(name,)) == 1


def test_ten_thousand_cases_are_planned_in_batches_of_a_few_minutes_whose_commands_a_shell_takes():
    path = Path(__file__).parents[2] / "pipeline" / "config" / "ten_thousand.yaml"
    large = yaml.safe_load(path.read_text())["proof"]
    cases = plan(large)
    assert len(cases) >= 10_000 and not {case.seed for case in cases} & {case.seed for case in plan(CONFIG)}
    kinds = {(case.stratum, case.protocol, case.kappas, case.author, bool(case.without)) for case in cases}
    assert kinds == {
        (case.stratum, case.protocol, case.kappas, case.author, bool(case.without)) for case in plan(CONFIG)
    }
    batched = batches(large)
    assert sorted(case.run for batch in batched.values() for case in batch) == sorted(case.run for case in cases)
    assert len(batched) < 150 and max(map(len, batched.values())) <= 100
    assert max(len(written(batch)) for batch in batched.values()) < 60_000


def test_a_seed_draws_a_block_of_its_own_in_an_order_that_tells_nothing():
    cases, other = plan(CONFIG), plan({**CONFIG, "seed": CONFIG["seed"] + 10_000})
    assert len({case.seed for case in [*cases, *other]}) == 2 * len(cases)
    assert [case.stratum for case in cases] != [case.stratum for case in other]
    assert len({case.stratum for case in cases[:40]}) >= 4
    assert all(case.run == f"case-{case.seed}" for case in cases)


def test_every_case_is_in_one_batch_and_survives_the_command_line():
    batched = batches(CONFIG)
    cases = [case for batch in batched.values() for case in batch]
    assert sorted(case.run for case in cases) == sorted(case.run for case in plan(CONFIG))
    assert all(len({case.without for case in batch}) == 1 for batch in batched.values())
    assert read(written(cases)) == cases


def test_an_effect_that_the_rig_has_not_is_refused():
    mix = {"stratum": "single", "protocol": "rich", "each": 1, "effects": ["../creep"]}
    with pytest.raises(BadInput, match="is no effect of the rig"):
        plan({"seed": 1, "batch": 4, "mixes": [mix]})
