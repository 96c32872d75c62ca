"""Files as lab software writes them, with words among the numbers: `--guess` drafts for them what reads them."""

import numpy as np
import pytest
from foreign.test_import_guess import M, T, X, filled, program

from pipeline.run.samples import read_samples

LOAD = 10.0 + 0.1 * np.sin(np.arange(len(T)))
NAMES = "Zeit;Winkel;Weg;Kraft;Status"
HEAD = "Prüfstand A\nDatum: 3.11.2026\n"
LABVIEW = (
    "LabVIEW Measurement\t\nWriter_Version\t2\nDecimal_Separator\t,\nDate\t2026/11/03\n***End_of_Header***\t\n\t\n"
)
DIADEM = "DIAGROUP;Prüfstand A\nNAME;Zeit;Winkel;Weg;Kraft\nEINHEIT;s;deg;mm;N\nDATENTYP;DOUBLE;DOUBLE;DOUBLE;DOUBLE\n"
DIADEM += "LAENGE;200;200;200;200\nMIN;0,0;0,0;0,0;9,9\nMAX;9,9;3600,0;9,9;10,1\nBEGINN\n"


def german(value: float) -> str:
    return f"{value:.6f}".replace(".", ",")


def of_day(time_s: float) -> str:
    return f"10:{12 + int(time_s // 60)}:{german(time_s % 60).zfill(9)}"


def rows(*words: str, sign: str = ";", write=german, time=None) -> str:
    """The recording, in s, degrees, mm and N; `words` stand behind each row, and `time` writes the time."""
    numbers = zip(T, M * 360, X, LOAD, strict=True)
    lines = ([(time or write)(t), write(turns), write(mm), write(load), *words] for t, turns, mm, load in numbers)
    return "".join(sign.join(line) + "\n" for line in lines)


FILES = {
    "status-and-titles.csv": (HEAD + NAMES + "\n" + rows("OK"), "cp1252"),
    "titles-are-remarks.csv": ("# Prüfstand A\n# Datum: 3.11.2026\n" + NAMES + "\n" + rows("OK"), "utf-8"),
    "one-title-is-a-remark.csv": ("# Prüfstand A\nDatum: 3.11.2026\n" + NAMES + "\n" + rows("OK"), "utf-8"),
    "units-below.csv": (HEAD + NAMES + "\ns;°;mm;N;-\n" + rows("OK"), "utf-8"),
    "labview.lvm": (
        (LABVIEW + "Zeit\tWinkel (deg)\tWeg (mm)\tKraft (N)\tComment\n" + rows("", sign="\t")).replace("\n", "\r\n"),
        "utf-8",
    ),
    "excel.csv": (
        ("\ufeffZeit;Winkel;Weg;Kraft;Notiz;;\n" + rows("", "", "") + ";;;;;;\n\n\n").replace("\n", "\r\n"),
        "utf-8",
    ),
    "diadem.csv": (DIADEM + "".join(f"{at};{line}\n" for at, line in enumerate(rows().splitlines())), "cp1252"),
    "tabs.txt": ("Zeit\tWinkel\tWeg\tKraft\ns\tdeg\tmm\tN\n" + rows(sign="\t", write=lambda v: f"{v:.6f}"), "utf-8"),
    "time-of-day.csv": (
        NAMES.replace("Zeit", "Uhrzeit") + ";Modus\n" + rows("OK", "auto", time=of_day),
        "utf-8",
    ),
    "foot.csv": (HEAD + NAMES + "\n" + rows("OK") + "Ende der Messung\nBediener: X\n", "utf-8"),
    "utf-16.txt": (NAMES.replace(";", "\t") + "\n" + rows("OK", sign="\t"), "utf-16"),
    "padded-titles.csv": ("Prüfstand A;;;;\nDatum;3.11.2026;;;\n" + NAMES + "\n" + rows("OK"), "utf-8"),
    "matlab.txt": ("% Zeit Winkel Weg Kraft\n" + rows(sign="  ", write=lambda v: f"{v:.6f}"), "utf-8"),
}


@pytest.mark.parametrize("name", FILES)
def test_the_draft_for_a_file_of_lab_software_reads_it_as_it_stands(tmp_path, name):
    """`set file.delimiter to ';'` was the answer to a column of words, which nobody could tell to --guess."""
    text, encoding = FILES[name]
    (tmp_path / name).write_bytes(text.encode(encoding))
    done = program("--guess", name, cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    (tmp_path / "map.yaml").write_text(filled(done.stdout, unit="N"), encoding="utf-8")
    done = program(name, "--map", "map.yaml", "--run", "a-01", cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    read = read_samples(tmp_path / "raw" / "a-01")[1]
    for channel, values in (("time_s", T), ("motor_turns", M), ("displacement_mm", X), ("load_n", LOAD)):
        assert read[channel].to_numpy() == pytest.approx(np.asarray(values), abs=2e-6), channel


@pytest.mark.parametrize(
    ("text", "says"),
    [
        (
            "Zeit,Winkel,Weg,Kraft\n" + rows(sign=","),
            ["file.delimiter: is a comma, and so is the decimal sign", "Mend: save it again with semicolons or tabs"],
        ),
        (
            "Zeit,Winkel\n" + "".join(f'"{german(t)}","{german(t)}"\n' for t in T),
            ["file.delimiter: is a comma, and so is the decimal sign"],
        ),
        (
            NAMES + "\n" + "".join(f"{german(t)};{german(t)};1.234,5;10,0;OK\n" for t in T),
            [
                "Weg: has numbers such as 1.234,5, with a sign between thousands",
                "Mend: save it again without that sign",
            ],
        ),
        (
            "Name;Ort\nfoo;bar\n" * 9,
            ["file: has no row of two numbers or more in its first 300 lines", "write the mapping by hand"],
        ),
    ],
)
def test_what_no_draft_can_read_is_named_with_the_field_and_a_mend_that_can_be_done(tmp_path, text, says):
    (tmp_path / "log.csv").write_text(text, encoding="utf-8")
    done = program("--guess", "log.csv", cwd=tmp_path)
    assert done.returncode == 2 and "log.csv" in done.stderr and all(each in done.stderr for each in says), done.stderr
    assert "set file." not in done.stderr, "which --guess does not take"


def test_a_mend_that_guess_cannot_take_is_told_for_a_mapping_by_hand(tmp_path):
    """The first million bytes are looked at; a letter of another encoding stood behind them."""
    line = "0,000000;0,000000;0,000000;10,000000;OK\n"
    (tmp_path / "log.csv").write_bytes((NAMES + "\n" + 30_000 * line + line.replace("OK", "Prüfung")).encode("cp1252"))
    done = program("--guess", "log.csv", cwd=tmp_path)
    assert done.returncode == 2, done.stdout
    assert "file.encoding: is not utf-8" in done.stderr
    by_hand = "--guess cannot: write the mapping by hand (docs/import.md), with file: {delimiter: ;, decimal: ','}"
    assert f"Mend: {by_hand}, and there set file.encoding, latin1 for instance" in done.stderr
