"""More words than a command may have go by a file, in which every word stays what it is."""

import argparse
import subprocess
import sys
from pathlib import Path

import pytest

from pipeline.ground.input.words_by_file import SIGN, by_file, spread

MANY = [f"run-{at:05d}" for at in range(20_000)]
ODD = ["a b", "--runs", "it's", "ünï {x}", '{"a": ["b"]}', "$(touch PWNED)", "-1", ""]


def test_a_parser_reads_what_was_written_and_the_same_words_have_the_same_name(tmp_path):
    parser = argparse.ArgumentParser(fromfile_prefix_chars=SIGN)
    parser.add_argument("words", nargs="*")
    stands = by_file(["--", *ODD], tmp_path / "words")
    assert parser.parse_args([stands]).words == ODD
    assert by_file(["--", *ODD], tmp_path / "words") == stands != by_file(ODD, tmp_path / "words")
    assert spread(["x", stands, "@nowhere"]) == ["x", "--", *ODD, "@nowhere"]
    assert spread([by_file([], tmp_path / "words")]) == []


def test_a_command_that_starts_elsewhere_finds_its_words_there(tmp_path, monkeypatch):
    stands = by_file(ODD, Path("words"), tmp_path / "elsewhere")
    assert stands.startswith("@words/") and spread([stands]) == [stands]
    monkeypatch.chdir(tmp_path / "elsewhere")
    assert spread([stands]) == ODD


def test_a_shell_takes_more_words_than_its_command_may_have(tmp_path):
    program = f"{sys.executable} -c 'import sys; print(len(sys.argv[1]))' "
    with pytest.raises(OSError, match="too long"):
        subprocess.run(["sh", "-c", program + " ".join(MANY)])
    done = subprocess.run(["sh", "-c", program + by_file(MANY, tmp_path)], capture_output=True, text=True)
    assert done.returncode == 0 and int(done.stdout) < 300 and spread([by_file(MANY, tmp_path)]) == MANY


@pytest.mark.parametrize("word", ["a\nb", "a\rb", "a\u2028b", "a\x85b", "a\n"])
def test_a_word_of_several_lines_is_refused(tmp_path, word):
    with pytest.raises(ValueError, match="several lines"):
        by_file(["x", word, "y"], tmp_path)
    assert not list(tmp_path.iterdir())
