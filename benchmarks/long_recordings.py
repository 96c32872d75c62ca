"""What a long recording costs: memory and seconds of each stage, beside pandas alone that reads the same file.

    python benchmarks/long_recordings.py [--minutes 120] [--as parquet|csv|frames] [--stages ingest dataset ...]

makes a recording at 1 kHz (a twisted pair that creeps, a stroke a minute), takes it through each stage in a process of
its own, and prints what each needed at most. As frames it is one of the wire, which is committed first, as at the end
of a capture. What was measured stands in docs/scale.md.
"""

import argparse
import multiprocessing
import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pyarrow as pa
import pyarrow.csv
import pyarrow.parquet as pq
import yaml

ROOT = Path(__file__).parents[1]
if not __package__:  # as `python benchmarks/long_recordings.py`
    sys.path.insert(0, str(ROOT))

from pipeline.wire import Channel, Event, Hello, Kind, Reason, encode  # noqa: E402
from pipeline.wire.batch import checksum_rows  # noqa: E402
from pipeline.wire.frames import END, EVENT  # noqa: E402

RATE_HZ, STROKE_S = 1000.0, 60.0
PIECE = 1 << 20  # samples
STRING = {"material": "Z", "radius_mm": 0.4, "length_mm": 300.0, "stiffness_n_per_mm": 50.0}
NAMES = ("time_s", "motor_turns", "displacement_mm", "load_n")
SCHEMA = pa.schema([(name, pa.float64()) for name in NAMES])
CHANNELS = (
    Channel("motor_turns", "turns", "i32", 1.0 / 4096.0),
    Channel("displacement_mm", "mm", "i32", 1e-4),
    Channel("load_n", "N", "i32", 1e-3),
)


def motion(first: int, stop: int, generator: np.random.Generator) -> list[np.ndarray]:
    """Samples `first` to `stop` of a string that creeps, a column for each of NAMES."""
    time_s = np.arange(first, stop) / RATE_HZ
    turns = 25.0 * np.interp(
        time_s / STROKE_S % 1.0, [0.0, 0.05, 0.45, 0.55, 0.95, 1.0], [0.0, 0.0, 1.0, 1.0, 0.0, 0.0]
    )
    noise = generator.normal(0.0, 1.0, (2, len(time_s)))
    contraction_mm = 300.0 - np.sqrt(300.0**2 - (2.0 * np.pi * turns * 0.4) ** 2)
    creep_mm = 0.8 * (1.0 - np.exp(-time_s / 120.0))
    return [time_s, turns, contraction_mm - creep_mm + 0.02 * noise[0], 20.0 + 0.05 * noise[1]]


def record(folder: Path, minutes: float, form: str) -> None:
    """A run folder with a recording of so many minutes in one of FORMS, which is written piece by piece."""
    folder.mkdir(parents=True)
    FORMS[form](folder, round(60.0 * minutes * RATE_HZ))
    content = {"run": folder.name, "actuator": "twisted_pair", "string": STRING, "rig": {}}
    (folder / "run.yaml").write_text(yaml.safe_dump(content))


def tables(samples: int, decimals: int | None = None) -> Iterator[pa.Table]:
    """A recording of so many samples, a table for each piece; rounded as a logger prints it, where asked."""
    generator = np.random.default_rng(1)
    for first in range(0, samples, PIECE):
        columns = motion(first, min(first + PIECE, samples), generator)
        rounded = columns if decimals is None else [np.round(column, decimals) for column in columns]
        yield pa.Table.from_arrays([pa.array(column) for column in rounded], schema=SCHEMA)


def record_parquet(folder: Path, samples: int) -> None:
    """A recording.parquet of so many samples."""
    with pq.ParquetWriter(folder / "recording.parquet", SCHEMA) as to_file:
        for table in tables(samples):
            to_file.write_table(table)


def record_csv(folder: Path, samples: int) -> None:
    """A recording.csv of so many samples, each number with at most four decimals."""
    with pyarrow.csv.CSVWriter(folder / "recording.csv", SCHEMA) as to_file:
        for table in tables(samples, decimals=4):
            to_file.write_table(table)


def record_frames(folder: Path, samples: int) -> None:
    """A recording.frames of so many samples as a device sends them, two events a stroke; not committed."""
    generator, per_stroke = np.random.default_rng(1), round(STROKE_S * RATE_HZ)
    hello = Hello("a rig", "1.0", "00000001", RATE_HZ, -(-samples // per_stroke), CHANNELS)
    with (folder / "recording.frames").open("wb") as to_file:
        to_file.write(encode(Kind.HELLO, 0, hello.pack()))
        seq = 1
        for stroke, first in enumerate(range(0, samples, per_stroke), start=1):
            time_s, *columns = motion(first, min(first + per_stroke, samples), generator)
            rows = np.zeros(len(time_s), hello.sample_type)
            rows["t_us"] = np.round(time_s * 1e6).astype(np.int64) % 2**32
            for channel, values in zip(CHANNELS, columns, strict=True):
                rows[channel.name] = np.round((values - channel.offset) / channel.scale)
            begin, end = (EVENT.pack(int(rows["t_us"][at]), code, stroke) for at, code in
                          ((0, Event.STROKE_START), (-1, Event.STROKE_END)))  # fmt: skip
            to_file.write(encode(Kind.EVENT, seq, begin))
            to_file.write(encode_samples(seq + 1, rows))
            to_file.write(encode(Kind.EVENT, seq + 1 + len(rows), end))
            seq += len(rows) + 2
        to_file.write(encode(Kind.END, seq, END.pack(samples, Reason.COMPLETE)))


FORMS = {"parquet": record_parquet, "csv": record_csv, "frames": record_frames}


def encode_samples(seq: int, rows: np.ndarray) -> bytes:
    """What the wire's `encode` gives of SAMPLE frames from number `seq` on, side by side; raises ValueError if not."""
    size = rows.dtype.itemsize
    data = np.zeros((len(rows), 1 + 4 + size + 4 + 1), np.uint8)  # kind, number, sample, check, and a zero
    data[:, 0] = Kind.SAMPLE
    data[:, 1:5] = (seq + np.arange(len(rows), dtype="<u4"))[:, None].view(np.uint8)
    data[:, 5 : 5 + size] = np.ascontiguousarray(rows).view(np.uint8).reshape(len(rows), size)
    data[:, -5:-1] = checksum_rows(data[:, :-5]).astype("<u4")[:, None].view(np.uint8)
    stuffed, step = np.zeros((len(rows), data.shape[1] + 1), np.uint8), np.zeros(len(rows), np.uint8)
    for column in range(data.shape[1] - 1, -1, -1):  # each zero becomes the way to the next
        is_zero = data[:, column] == 0
        stuffed[:, column + 1] = np.where(is_zero, step, data[:, column])
        step = np.where(is_zero, 1, step + 1).astype(np.uint8)
    stuffed[:, 0] = step
    stuffed[:, -1] = 0
    if stuffed[0].tobytes() != encode(Kind.SAMPLE, seq, rows[0].tobytes()):
        raise ValueError(f"frame {seq} is not as the wire writes it; mend encode_samples")
    return stuffed.tobytes()


def cost(command: list[str], log: Path) -> tuple[float, float, float]:
    """Peak memory in MB, CPU seconds and seconds of a command; raises RuntimeError where it fails."""
    began = time.monotonic()
    with log.open("w") as out:
        process = subprocess.Popen(command, cwd=ROOT, stdout=out, stderr=out)
        _, status, usage = os.wait4(process.pid, 0)
    if status:
        raise RuntimeError(f"{' '.join(command)}: {log.read_text()[-2000:]}")
    return usage.ru_maxrss / 1024.0, usage.ru_utime + usage.ru_stime, time.monotonic() - began


def main() -> None:
    """Make the recording, and print what each stage needs."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--minutes", type=float, default=120.0)
    parser.add_argument("--as", dest="form", choices=FORMS, default="parquet", help="frames: with their commit")
    parser.add_argument("--stages", nargs="+", help="only these; default: all")
    arguments = parser.parse_args()
    minutes = arguments.minutes
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        run, stored = folder / "raw" / "long-01", folder / "processed"
        maker = multiprocessing.Process(target=record, args=(run, minutes, arguments.form))  # its memory is its own
        maker.start()
        maker.join()
        (stored / run.name).mkdir(parents=True)
        samples, strokes = (str(stored / run.name / f"{what}.parquet") for what in ("samples", "strokes"))
        recording = run / f"recording.{arguments.form}"
        reader = "read_csv" if arguments.form == "csv" else "read_parquet"
        verdict = str(folder / "out" / run.name / "diagnosis.json")
        first = {"pandas reads it": ["-c", f"import pandas; pandas.{reader}({str(recording)!r})"]}
        if arguments.form == "frames":
            first = {"commit": ["-m", "pipeline.capture", "--recover", str(run)]}
        commands = {
            **first,
            "ingest": ["-m", "pipeline.stages.ingest", str(run), "--out", samples, "--out-strokes", strokes],
            "dataset": ["-m", "pipeline.stages.dataset", str(run), "--processed", str(stored), "--out",
                        str(folder / "dataset.parquet")],
            "lifespan": ["-m", "pipeline.lifespan", str(run), "--out", str(folder / "lifespan")],
            "diagnose": ["-m", "pipeline.diagnose", str(run), "--out", str(folder / "out")],
            "simulate": ["-m", "pipeline.simulate", str(run), "--simulation", verdict, "--out",
                         str(folder / "simulated.parquet")],
        }  # fmt: skip
        print("| stage | peak memory (MB) | times pandas' | CPU s | times pandas' | seconds |\n|" + 6 * "---|")
        alone = (float("nan"),) * 3  # where pandas is not among the stages
        for stage, command in commands.items():
            if arguments.stages and stage not in arguments.stages:
                continue
            found = cost([sys.executable, *command], folder / "log")
            alone = found if stage == "pandas reads it" else alone
            peak_mb, cpu_s, seconds = found
            row = [f"{peak_mb:.0f}", f"{peak_mb / alone[0]:.1f}", f"{cpu_s:.1f}", f"{cpu_s / alone[1]:.1f}"]
            print(f"| {stage} | {' | '.join(row)} | {seconds:.1f} |", flush=True)


if __name__ == "__main__":
    main()
