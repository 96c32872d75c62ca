"""The probabilities of a page add up, and the tables have the likeliest explanations."""

import re

from made_content import explanation, told, weighed


def test_a_stand_in_is_part_of_the_share_of_physics_that_the_library_lacks() -> None:
    diagnosis = weighed(0.0, 0.0, 0.18, 0.0, 0.71, none=0.22, alternatives=[["x_swelling"]])
    diagnosis["evidence"]["explanations"][3]["ids"] = ["x_swelling"]
    table = told(diagnosis).partition("How probable each explanation is\n")[2].partition("\n\n")[0]
    assert "physics that the library lacks, stand-ins included" in table and "x_swelling (the radius" in table
    rows = [re.match(r" +\S+ +(.+?)  +(\d+) %", line) for line in table.splitlines()]
    shares = {row[1]: float(row[2]) for row in rows if row}
    assert shares.pop("x_swelling") == 18.0 and sum(shares.values()) == 100.0


def test_the_table_of_what_is_less_likely_has_the_likeliest_of_all_kinds() -> None:
    diagnosis = weighed(0.004, 0.004, 0.31, 0.03, 0.52)
    more = [explanation([f"x_{place}"], "beaten", 0.05) | {"probability": 1e-4} for place in range(9)]
    diagnosis["evidence"]["explanations"][1:1] = more
    beaten = told(diagnosis).partition("How probable each explanation is\n")[2]
    assert re.search(r"friction_hysteresis \+ creep \+ wear +3 %", beaten), "it has one effect more, and 3 %"
