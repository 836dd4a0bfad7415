#!/usr/bin/env python3
"""Sa, Sq, Sz, Sp, Sv, Ssk, Sku, Sdq and Sdr of height maps, computed here from the definitions, beside those of `asperity
measure`. Usage: roughness.py ASPERITY FILE...

Each file is converted to .gsf, which is read here, byte by byte; no code is shared with the
program. Sums are exactly rounded (math.fsum)."""

import json
import math
import pathlib
import re
import struct
import subprocess
import sys
import tempfile

TOLERANCE = 1e-12  # relative


def read_gsf(path):
    """Columns, rows, sides [m] and the heights, top row first [m]; nan: no data."""
    data = path.read_bytes()
    end = data.index(b"\0")
    fields = dict(re.findall(r"^(\w+)\s*=\s*(.*)$", data[:end].decode(), re.MULTILINE))
    columns, rows = int(fields["XRes"]), int(fields["YRes"])
    start = end + 4 - end % 4
    heights = struct.unpack_from(f"<{columns * rows}f", data, start)
    return columns, rows, float(fields["XReal"]), float(fields["YReal"]), heights


def triangle(a, b, c):
    """Area of a triangle in space."""
    u = [q - p for p, q in zip(a, b)]
    v = [q - p for p, q in zip(a, c)]
    cross = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
    return 0.5 * math.sqrt(sum(part * part for part in cross))


def surplus_area(columns, rows, width, height, z):
    """Sdr: mean of both ways to split each square of four pixels into two triangles."""
    dx, dy = width / columns, height / rows
    areas, squares = [], 0
    for row in range(rows - 1):
        for column in range(columns - 1):
            i = row * columns + column
            corners = [(0.0, 0.0, z[i]), (dx, 0.0, z[i + 1]),
                       (dx, dy, z[i + columns + 1]), (0.0, dy, z[i + columns])]
            if any(math.isnan(corner[2]) for corner in corners):
                continue
            a, b, c, d = corners
            areas.append(0.5 * (triangle(a, b, c) + triangle(a, c, d)))
            areas.append(0.5 * (triangle(a, b, d) + triangle(b, c, d)))
            squares += 1
    return math.fsum(areas) / (squares * dx * dy) - 1.0


def gradient(columns, rows, width, height, z):
    """Sdq: of the same triangles, the slopes of whose planes are those of their sides along x and y."""
    dx, dy = width / columns, height / rows
    squares, triangles = [], 0
    for row in range(rows - 1):
        for column in range(columns - 1):
            i = row * columns + column
            a, b, c, d = z[i], z[i + 1], z[i + columns + 1], z[i + columns]
            if any(math.isnan(corner) for corner in (a, b, c, d)):
                continue
            for along, across in ((b - a, c - b), (c - d, d - a), (b - a, d - a), (c - d, c - b)):
                squares.append((along / dx) ** 2 + (across / dy) ** 2)
                triangles += 1
    return math.sqrt(math.fsum(squares) / triangles)


def roughness(path):
    columns, rows, width, height, heights = read_gsf(path)
    data = [z for z in heights if not math.isnan(z)]
    mean = math.fsum(data) / len(data)
    sq = math.sqrt(math.fsum((z - mean) ** 2 for z in data) / len(data))
    return {"sa_m": math.fsum(abs(z - mean) for z in data) / len(data),
            "sq_m": sq,
            "sz_m": max(data) - min(data),
            "sp_m": max(data) - mean,
            "sv_m": mean - min(data),
            "ssk": math.fsum(((z - mean) / sq) ** 3 for z in data) / len(data),
            "sku": math.fsum(((z - mean) / sq) ** 4 for z in data) / len(data),
            "sdq": gradient(columns, rows, width, height, heights),
            "sdr": surplus_area(columns, rows, width, height, heights)}


def main(program, files):
    failures = 0
    with tempfile.TemporaryDirectory() as folder:
        gsf = pathlib.Path(folder) / "map.gsf"
        for file in files:
            subprocess.run([program, "convert", file, gsf, "--level", "plane", "--force"],
                           check=True, capture_output=True)
            answer = subprocess.run([program, "measure", gsf, "--level", "none", "--json"],
                                    check=True, capture_output=True)
            theirs = json.loads(answer.stdout)
            for name, ours in roughness(gsf).items():
                # An area less its outline has lost the digits of small slopes; a sum of cubes
                # about the mean, those of what cancels.
                scale = 1.0 + abs(ours) if name in ("sdr", "ssk") else ours
                error = abs(theirs[name] - ours) / scale
                failures += error > TOLERANCE
                print(f"{pathlib.Path(file).name}: {name} {ours:.15g}, "
                      f"measure {theirs[name]:.15g}, off by {error:.1e}")
    return failures


if __name__ == "__main__":
    sys.exit(min(main(sys.argv[1], sys.argv[2:]), 1))
