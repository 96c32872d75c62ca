"""Damaged and hostile input, drawn from a seed: mutations of bytes, and of the values of a run.yaml."""

import copy
import random
from collections.abc import Iterator
from typing import Any

HOSTILE: list[Any] = [
    None, True, False, 0, -1, 1, 3, 10**30, -(10**30), 1e-300, 1e300, 0.5, float("nan"), float("inf"), "", " ", "x",
    "yes", "nan", "1e400", "../../x", "/etc/passwd", "a\0b", "a\nb", "a{b}c", "$(id)", "<b>", "é" * 200, "x" * 5000,
    "undefined", "punycode", "utf-16", "latin1", "utf-7", "\r", "\n", "\t", ";", '"', "§", "0300", "5:00",
    "2026-11-22", "rad", "count", "Pa", "K", "twisted_pair", "cable_drive", "moving_mass", [], {}, [[]], [1],
    {"a": 1}, [{"id": [1]}], [{"id": "creep"}], [{"id": "creep", "parameters": {"tau_s": 1e18}}], {"column": 0},
    {"column": -1}, {"column": "time_s"}, {"unit": "deg"}, {"unit": "count", "counts_per_turn": 1e-9}, {"scale": 0},
    {"scale": 1e18}, {"offset": -1e18}, {"scale": -1},
]  # fmt: skip
KEYS = [
    "run", "actuator", "string", "rig", "tolerance", "simulation", "file", "channels", "mended", "material",
    "radius_mm", "length_mm", "stiffness_n_per_mm", "id", "strokes_before", "torsion_zone_mm", "separator_mm",
    "load_n", "radius", "delimiter", "header", "comment", "encoding", "time_s", "motor_turns", "displacement_mm",
    "temperature_c", "column", "unit", "scale", "offset", "counts_per_turn", "angle_turns", "mass_kg", "gear_ratio",
    "<<", "", "é", 7,
]  # fmt: skip
YAML = [
    b"&a", b"*a", b"!!int ", b"!!python/none ", b"? ", b": ", b"- ", b"[", b"{", b"]", b"}", b"'", b'"', b"|\n",
    b">\n", b"---\n", b"...\n", b"%YAML 1.1\n", b"#", b"\t", b"\0", b"\xff", b"\xef\xbb\xbf", b"\xc2\x85", b"0300",
    b"5:00", b".nan", b"1.0e-300", b"9" * 5000, b"[" * 3000, b"2026-13-45", b"<<: *a\n", b"\r", b"{a: b, a: c}",
]  # fmt: skip


def damaged(content: bytes, chance: random.Random, words: list[bytes]) -> bytes:
    """Content with one to four of its places overwritten, cut, doubled, moved, or with a word put in."""
    data = bytearray(content)
    for _ in range(chance.randint(1, 4)):
        at = chance.randrange(len(data) + 1)
        until = min(len(data), at + chance.choice((1, 1, 2, 8, 60)))
        kind = chance.randrange(6)
        if kind == 0 and at < len(data):
            data[at] ^= 1 << chance.randrange(8)
        elif kind == 1:
            del data[at:until]
        elif kind == 2:
            data[at:at] = data[at:until]
        elif kind == 3:
            data[at:until] = chance.randbytes(until - at)
        elif kind == 4 and words:
            data[at:at] = chance.choice(words)
        elif chance.random() < 0.2:
            del data[at:]
    return bytes(data)


def flips_and_cuts(whole: bytes) -> Iterator[bytes]:
    """Content with one bit the other way, 300 times, and cut off, 20 times."""
    draw = random.Random(0)
    for _ in range(300):
        at, content = draw.randrange(8 * len(whole)), bytearray(whole)
        content[at // 8] ^= 1 << at % 8
        yield bytes(content)
    for _ in range(20):
        yield whole[: draw.randrange(len(whole))]


def places(content: Any, path: tuple[Any, ...] = ()) -> Iterator[tuple[Any, ...]]:
    """Path of every value in nested dicts and lists."""
    items = content.items() if isinstance(content, dict) else enumerate(content) if isinstance(content, list) else ()
    for key, value in items:
        yield (*path, key)
        yield from places(value, (*path, key))


def twisted(content: dict[str, Any], chance: random.Random) -> dict[str, Any]:
    """Nested content with one to three of its values replaced, removed, or beside a new key."""
    content = copy.deepcopy(content)
    for _ in range(chance.randint(1, 3)):
        paths = list(places(content))
        if not paths:
            break
        *above, key = chance.choice(paths)
        parent: Any = content
        for step in above:
            parent = parent[step]
        kind = chance.randrange(4)
        if kind == 0 and isinstance(parent, dict):
            parent[chance.choice(KEYS)] = copy.deepcopy(chance.choice(HOSTILE))
        elif kind == 1:
            del parent[key]
        else:
            parent[key] = copy.deepcopy(chance.choice(HOSTILE))
    return content
