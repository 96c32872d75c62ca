"""A rule and the module that it runs share a word, so that who reads one name finds the other."""

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
RULE = re.compile(r"^rule (\w+):\n((?:[ \t].*\n|\n)*)", re.M)
EXCEPTIONS: dict[str, str] = {}  # rule: why its name cannot share a word; three at most
RULES = {
    name: re.findall(r"python -m pipeline\.([\w.]+)", body)
    for path in [ROOT / "Snakefile", *sorted((ROOT / "pipeline/rules").glob("*.smk"))]
    for name, body in RULE.findall(path.read_text())
}
RUNNING = [(name, module) for name, modules in RULES.items() for module in modules]


def words(name: str) -> set[str]:
    """The words of a name, a plural as its singular."""
    return {word.removesuffix("s") for word in re.split(r"[._]", name)}


@pytest.mark.parametrize(("rule", "module"), RUNNING, ids=[rule for rule, _ in RUNNING])
def test_a_rule_and_its_module_share_a_word(rule: str, module: str) -> None:
    """The room of the module, as `report`, is no such word."""
    own = module.partition(".")[2] or module
    assert rule in EXCEPTIONS or words(rule) & words(own), f"rule {rule} runs pipeline.{module}"


def test_every_rule_that_runs_a_module_was_read() -> None:
    text = "".join(path.read_text() for path in (ROOT / "pipeline/rules").glob("*.smk"))
    assert len(RUNNING) == len(re.findall(r"python -m pipeline\.", text)) > 30
    assert len(EXCEPTIONS) <= 3 and set(EXCEPTIONS) <= set(RULES)
