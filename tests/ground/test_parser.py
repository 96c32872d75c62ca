"""A misspelt option is told the near name, also where argparse complains of something else first."""

import pytest
from programs import run

from pipeline.__main__ import PROGRAMS
from pipeline.ground.input.parser import Parser


def complaint(capsys, *words):
    parser = Parser(prog="a program")
    parser.add_argument("run", nargs="?")
    parser.add_argument("--tolerance")
    parser.add_argument("--out", required=True)
    with pytest.raises(SystemExit) as end:
        parser.parse_args(words)
    assert end.value.code == 2
    return capsys.readouterr().err.splitlines()[-1]


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (
            ["--out", "a", "--tolerence", "3"],
            "--tolerence; did you mean --tolerance by --tolerence?",
        ),
        (["--uot=a"], "required: --out; did you mean --out by --uot?"),
        (["--out", "a", "--qqqq"], "unrecognized arguments: --qqqq"),
        (["--tol", "3"], "required: --out"),
        (["--", "--uot"], "required: --out"),
    ],
)
def test_the_near_option_is_named_and_no_far_one(capsys, words, message):
    last = complaint(capsys, *words)
    assert message in last and ("did you mean" in message) == ("did you mean" in last)


@pytest.mark.parametrize("name", list(PROGRAMS))
def test_every_program_says_it(name):
    done = run(f"pipeline.{name.replace('-', '_')}", "--hlep")
    assert done.returncode == 2 and "did you mean --help by --hlep?" in done.stderr
