"""Headers compiled as strictly as can be, and asked many queries at once."""

import shutil
import subprocess
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from pipeline.export.c_header import header
from pipeline.export.inputs import Inputs
from pipeline.export.interface import Source

ROOT = Path(__file__).resolve().parents[2]
WARNINGS = ("-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wdouble-promotion", "-Werror")
C99 = ("gcc", "-std=c99", *WARNINGS)
UNTOUCHED = -12345.0

DRIVER = """\
#include "model.h"
#include <stdio.h>

/* Queries from stdin, as rows of doubles; for each, on stdout: return code, answer, and what prepared tables say. */
int main(int count, char **words)
{
    double row[%(columns)d], answer[4];
    const int forward = count > 1 && words[1][0] == 'f', pairs = count > 1 && words[1][0] == 'r';
    while (fread(row, sizeof row, 1, stdin) == 1) {
        tsa_state at;
        tsa_real value = (tsa_real)%(untouched)s, again = value;
        int code, code_again = 0;
%(assign)s        code = pairs ? tsa_recorded(&at, (tsa_real)row[0])
               : forward ? tsa_forward(&at, (tsa_real)row[0], &value)
                         : tsa_inverse(&at, (tsa_real)row[0], &value);
%(prepared)s        answer[0] = code;
        answer[1] = (double)value;
        answer[2] = code_again;
        answer[3] = (double)again;
        fwrite(answer, sizeof answer, 1, stdout);
    }
    fprintf(stderr, "%%lu", (unsigned long)TSA_CONST_BYTES);
    return 0;
}
"""
PREPARED = """\
        {
            tsa_tables tables;
            code_again = tsa_prepare(&at, &tables);
            if (code_again == TSA_OK) {
                code_again = forward ? tsa_forward_prepared(&tables, (tsa_real)row[0], &again)
                                     : tsa_inverse_prepared(&tables, (tsa_real)row[0], &again);
            }
        }
"""


def need(*programs: str) -> None:
    """Skip the test where a compiler is not installed."""
    for program in programs:
        if shutil.which(program) is None:
            pytest.skip(f"{program} is not installed")


def built(*command: object) -> None:
    """Run a compiler; it has nothing to say of good code."""
    done = subprocess.run([*map(str, command)], capture_output=True, text=True)
    assert done.returncode == 0 and not done.stderr, done.stderr[:3000]


@dataclass
class Compiled:
    """A header's program."""

    program: Path
    inputs: Inputs

    def answers(self, way: str, queries: Any) -> tuple[Any, Any]:
        """Return codes and answers of queries of shape (points, columns), each of shape (points,)."""
        return self._asked(way, queries)[:2]

    def recorded(self, queries: Any) -> Any:
        """Codes that say which twists were recorded around the states, queries as of "forward", of shape (points,)."""
        return self._asked("recorded", queries)[0]

    def prepared(self, way: str, queries: Any) -> tuple[Any, Any]:
        """The same by prepared tables."""
        return self._asked(way, queries)[2:]

    def bytes(self) -> int:
        """Constant data of the header."""
        return int(subprocess.run([self.program], input=b"", capture_output=True, check=True).stderr)

    def _asked(self, way: str, queries: Any) -> Any:
        query_bytes = np.ascontiguousarray(queries, float).tobytes()
        done = subprocess.run([self.program, way], input=query_bytes, capture_output=True, check=True)
        return np.frombuffer(done.stdout).reshape(len(queries), 4).T


def compiled(source: Source, folder: Path, real: str = "float", *, options: tuple[str, ...] = ("-O1",)) -> Compiled:
    """The source's header under a driver, built as C99 without a warning."""
    need("gcc")
    fields, text = source.inputs.fields, header(source, "tsa")
    assign = "".join(
        f"        at.{field.name} = ({'int' if field.whole else 'tsa_real'})row[{number}];\n"
        for number, field in enumerate(fields, start=1)
    )
    driver = DRIVER % {
        "columns": len(fields) + 1,
        "untouched": UNTOUCHED,
        "assign": assign,
        "prepared": PREPARED if "tsa_prepare(" in text else "",
    }
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "model.h").write_text(text)
    (folder / "driver.c").write_text(driver)
    program = folder / f"driver-{real}"
    warnings = C99 if real == "float" else [word for word in C99 if word != "-Wdouble-promotion"]
    built(*warnings, *options, f"-DTSA_REAL={real}", folder / "driver.c", "-o", program, "-lm")
    return Compiled(program, source.inputs)
