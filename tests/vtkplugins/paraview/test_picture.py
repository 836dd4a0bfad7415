#!/usr/bin/env python3
"""Map, tip and deformed surface render: no patches of black and white, as meters would give, and
the colors of all parts. Usage: test_picture.py [OUT.png]"""

import pathlib
import struct
import sys
import tempfile
import zlib

import paraview_setup as paraview

DISPLAY = ["xvfb-run", "-a", "-s", "-screen 0 800x600x24 -noreset"]


def pixels_of(path):
    """Red, green, blue of each pixel of an 8-bit RGB PNG."""
    data = path.read_bytes()
    at, packed = 8, b""
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + size]
        if kind == b"IHDR":
            width, height, _, color = struct.unpack(">IIBB", body[:10])
        packed += body if kind == b"IDAT" else b""
        at += size + 12
    depth = {2: 3, 6: 4}[color]
    raw, stride = zlib.decompress(packed), width * depth
    rows, above = [], bytearray(stride)
    for row in range(height):
        start = row * (stride + 1)
        line = unfiltered(raw[start], bytearray(raw[start + 1:start + 1 + stride]), above, depth)
        rows.append(line)
        above = line
    return [tuple(line[i:i + 3]) for line in rows for i in range(0, stride, depth)]


def unfiltered(kind, line, above, depth):
    for i, value in enumerate(line):
        left = line[i - depth] if i >= depth else 0
        corner = above[i - depth] if i >= depth else 0
        up = above[i]
        nearest = min((abs(up - corner), 0, left), (abs(left - corner), 1, up),
                      (abs(left + up - 2 * corner), 2, corner))[2]
        line[i] = (value + (0, left, up, (left + up) // 2, nearest)[kind]) & 255
    return line


def main():
    with tempfile.TemporaryDirectory() as name:
        out = pathlib.Path(sys.argv[1] if sys.argv[1:] else f"{name}/picture.png")
        scenes = paraview.TREE / "data"
        paraview.run([*DISPLAY, "pvbatch", paraview.HERE / "picture.py", paraview.plugin(),
                      scenes / "scenes/granular_film.toml", scenes / "samples/granular_film.gsf",
                      out])
        pixels = pixels_of(out)
        black = sum(max(pixel) < 16 for pixel in pixels) / len(pixels)
        colored = [pixel for pixel in pixels if max(pixel) - min(pixel) > 40]
        shades = len({tuple(value // 8 for value in pixel) for pixel in colored})
        share = len(colored) / len(pixels)
        print(f"black {black:.3f}, colored {share:.3f}, {shades} shades")
        assert black < 0.02 and share > 0.2 and shades > 200


if __name__ == "__main__":
    main()
