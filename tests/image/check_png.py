#!/usr/bin/env python3
"""Decode a PNG with nothing but zlib, and compare it with what it should hold.

usage: check_png.py FILE WIDTH HEIGHT BITS SAMPLES TEXTS

SAMPLES is a file of RGB samples as PNG stores them (big-endian); TEXTS is one of key, NUL, value, NUL, ...
in UTF-8. Exits with a message when anything differs.
"""
import struct
import sys
import zlib


def chunks(data):
    """Yield (type, content) of every chunk, after checking its CRC."""
    assert data[:8] == b"\x89PNG\r\n\x1a\n", "no PNG signature"
    at = 8
    while at < len(data):
        (length,) = struct.unpack(">I", data[at:at + 4])
        kind, content = data[at + 4:at + 8], data[at + 8:at + 8 + length]
        (crc,) = struct.unpack(">I", data[at + 8 + length:at + 12 + length])
        assert crc == zlib.crc32(kind + content), f"wrong CRC in {kind}"
        yield kind, content
        at += 12 + length


def paeth(a, b, c):
    p = a + b - c
    return min((abs(p - a), 0, a), (abs(p - b), 1, b), (abs(p - c), 2, c))[2]


def unfilter(raw, row_bytes, pixel_bytes):
    """The samples of all rows (PNG specification, clause 9)."""
    rows, previous = [], bytes(row_bytes)
    for at in range(0, len(raw), row_bytes + 1):
        kind, row = raw[at], bytearray(raw[at + 1:at + 1 + row_bytes])
        for i in range(row_bytes):
            a = row[i - pixel_bytes] if i >= pixel_bytes else 0
            c = previous[i - pixel_bytes] if i >= pixel_bytes else 0
            b = previous[i]
            row[i] = (row[i] + (0, a, b, (a + b) // 2, paeth(a, b, c))[kind]) & 0xFF
        rows.append(bytes(row))
        previous = row
    return b"".join(rows)


def text(kind, content):
    """Key and value of a text chunk."""
    key, rest = content.split(b"\0", 1)
    if kind == b"tEXt":
        return key, rest
    if kind == b"zTXt":
        return key, zlib.decompress(rest[1:])
    value = rest[2:].split(b"\0", 2)[2]  # after the language and the translated key
    return key, zlib.decompress(value) if rest[0] else value


def main():
    path, width, height, bits = sys.argv[1], *map(int, sys.argv[2:5])
    samples, texts = (open(name, "rb").read() for name in sys.argv[5:7])
    found = list(chunks(open(path, "rb").read()))
    kinds = [kind for kind, _ in found]
    assert kinds[0] == b"IHDR" and kinds[-1] == b"IEND", kinds
    assert found[0][1] == struct.pack(">IIBBBBB", width, height, bits, 2, 0, 0, 0), found[0]

    # The fallback values beside sRGB are those that the PNG specification gives for that chunk.
    only = dict(found)
    assert kinds.index(b"sRGB") < kinds.index(b"IDAT"), kinds
    assert only[b"gAMA"] == struct.pack(">I", 45455), only[b"gAMA"]
    assert only[b"cHRM"] == struct.pack(">8I", 31270, 32900, 64000, 33000, 30000, 60000, 15000, 6000), only[b"cHRM"]

    pairs = [text(kind, content) for kind, content in found if kind in (b"tEXt", b"zTXt", b"iTXt")]
    assert b"".join(key + b"\0" + value + b"\0" for key, value in pairs) == texts, "texts differ"

    pixel_bytes = 3 * bits // 8
    raw = zlib.decompress(b"".join(content for kind, content in found if kind == b"IDAT"))
    assert len(raw) == height * (1 + width * pixel_bytes), len(raw)
    assert unfilter(raw, width * pixel_bytes, pixel_bytes) == samples, "samples differ"


if __name__ == "__main__":
    try:
        main()
    except (AssertionError, KeyError, ValueError, zlib.error, struct.error) as problem:
        sys.exit(f"check_png.py: {sys.argv[1]}: {problem!r}")
