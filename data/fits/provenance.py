"""Rows of data/fits/fits.csv: how many numbers a fitted table holds, and their hash.

The hash is FNV-1a, 64 bits, over the little-endian bits of every float literal outside comments, in order, each read
as a double. tests/provenance.rs computes the same from the Rust source.
"""

import pathlib
import re
import struct
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
CSV = ROOT / "data" / "fits" / "fits.csv"
HEADER = "file,script,literals,hash"


def row(path, script, text):
    """The row of a table whose source is `text`."""
    code = "\n".join(line.split("//")[0] for line in text.splitlines())
    numbers = [float(word) for word in re.findall(r"-?\d+\.\d+(?:e[-+]?\d+)?", code)]
    value = 0xCBF29CE484222325
    for number in numbers:
        for byte in struct.pack("<d", number):
            value = (value ^ byte) * 0x100000001B3 % 2**64
    return f"{path.relative_to(ROOT).as_posix()},{script},{len(numbers)},{value:016x}"


def rows():
    return CSV.read_text().splitlines()[1:] if CSV.exists() else []


def current(path, script, text):
    """Whether the committed row is that of `text`."""
    return row(path, script, text) in rows()


def record(path, script, text):
    """Writes the row of `text`, in the place of the row of the same file."""
    made = row(path, script, text)
    file = made.split(",")[0]
    kept = [line for line in rows() if line.split(",")[0] != file]
    CSV.write_text("\n".join([HEADER, *sorted([*kept, made])]) + "\n")


def write_or_check(script, files):
    """Writes each (path, text) and its row; with --check, exits 1 where a committed file or row differs."""
    for path, text in files:
        if "--check" not in sys.argv:
            path.write_text(text)
            record(path, script, text)
            continue
        if path.read_text() != text:
            sys.exit(f"{path} is not what this script writes")
        if not current(path, script, text):
            sys.exit(f"the row of {path} in fits.csv is not what this script writes")
        print(f"{path.relative_to(ROOT).as_posix()}: current")
