"""What the scripts of this folder share: the program's answers as numbers, scans and scenes to ask it
about, comparisons, and formulas that more than one script needs. The formulas are those of
docs/theory.md, evaluated with mpmath and without the program's code."""

import csv
import pathlib
import re
import struct
import subprocess
import sys
import tempfile

import mpmath
from mpmath import mp, mpf

mp.dps = 25

DATA = pathlib.Path(__file__).resolve().parents[2] / "data"
COHESIVE_RANGE = mpf("0.165e-9") * (mpmath.sqrt(10) - 1)  # h0, docs/theory.md 1 (H357) [m]


class Checks:
    """Compares numbers, prints each comparison, and says at the end whether all agree."""

    def __init__(self):
        self.made = 0
        self.wrong = 0

    def holds(self, name, is_true, found):
        self.made += 1
        self.wrong += not is_true
        print(f"{'ok   ' if is_true else 'WRONG'} {name}: {found}")

    def near(self, name, value, expected, tolerance, size=None):
        """Whether `value` differs from `expected` by at most `tolerance` of `size` (of `expected`)."""
        size = abs(mpf(expected)) if size is None else abs(mpf(size))
        error = abs(mpf(value) - mpf(expected))
        self.holds(name, error <= tolerance * size,
                   f"{float(value):.10g}, expected {float(expected):.10g} "
                   f"(to {tolerance:g} of {float(size):.3g})")

    def finish(self):
        print(f"{self.made} comparisons, {self.wrong} wrong")
        sys.exit(1 if self.wrong else 0)


def table(text):
    """Rows of a CSV table with comments, each a dictionary of texts."""
    return list(csv.DictReader(line for line in text.splitlines() if not line.startswith("#")))


class Program:
    """The program under test, in a folder of its own."""

    def __init__(self, path):
        self.path = str(pathlib.Path(path).resolve())
        self._temporary = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self._temporary.name)

    def run(self, *arguments):
        done = subprocess.run([self.path, *map(str, arguments)], cwd=self.folder, text=True,
                              capture_output=True)
        if done.returncode != 0:
            sys.exit(f"asperity {' '.join(map(str, arguments))} failed:\n{done.stderr}")
        return done

    def contact(self, cases):
        """Rows of `asperity contact` for cases, dictionaries with the same keys."""
        with (self.folder / "cases.csv").open("w", newline="") as file:
            writer = csv.DictWriter(file, cases[0].keys())
            writer.writeheader()
            writer.writerows(cases)
        return table(self.run("contact", "--cases", "cases.csv").stdout)

    def curve(self, *arguments):
        """Summary and rows of `asperity curve`."""
        done = self.run("curve", *arguments)
        return done.stderr, table(done.stdout)

    def explore(self, scene, path):
        """Rows of the log of a run along base positions: (time, x, y, z)."""
        with (self.folder / "path.csv").open("w") as file:
            file.write("time_s,x_m,y_m,z_m\n")
            file.writelines(",".join(repr(float(value)) for value in row) + "\n" for row in path)
        self.run("explore", scene, "--path", "path.csv", "--out", "run", "--force")
        return table((self.folder / "run/force_log.csv").read_text())

    def map(self, scene, region, grid="1x1", setpoint=None):
        """Quantities of `asperity map` by their keys, each a list of its pixels."""
        limit = [] if setpoint is None else ["--setpoint", repr(float(setpoint))]
        self.run("map", scene, "--out", "map.gwy", "--force", "--no-pictures", "--grid", grid,
                 "--region", ",".join(repr(float(value)) for value in region), *limit)
        data = (self.folder / "map.vti").read_bytes()
        start = data.index(b"_", data.index(b"<AppendedData")) + 1
        quantities = {}
        for name, offset in re.findall(rb'Float64" Name="([^"]*)"[^>]* offset="(\d+)"', data):
            begin = start + int(offset)
            size, = struct.unpack_from("<Q", data, begin)
            quantities[name.decode()] = struct.unpack_from(f"<{size // 8}d", data, begin + 8)
        return quantities

    def write_scan(self, name, rows, pitch):
        """Writes heights [m], the top row first, as a .gsf file of square pixels: single precision."""
        header = (f"Gwyddion Simple Field 1.0\nXRes = {len(rows[0])}\nYRes = {len(rows)}\n"
                  f"XReal = {len(rows[0]) * pitch!r}\nYReal = {len(rows) * pitch!r}\n"
                  "XYUnits = m\nZUnits = m\n").encode()
        heights = [float(height) for row in rows for height in row]
        (self.folder / name).write_bytes(header + b"\0" * (4 - len(header) % 4) +
                                         struct.pack(f"<{len(heights)}f", *heights))

    def write_scene(self, name, sections):
        """Writes a scene file from dictionaries of its sections' keys."""
        text = ""
        for section, keys in sections.items():
            text += f"[{section}]\n"
            for key, value in keys.items():
                text += f"{key} = " + (f'"{value}"' if isinstance(value, str) else
                                       repr(value if isinstance(value, bool) else float(value)))
                text += "\n"
        (self.folder / name).write_text(text.replace("True", "true").replace("False", "false"))
        return name


def read_scan(path):
    """Rows of heights and pitch of a .gsf file [m]."""
    data = pathlib.Path(path).read_bytes()
    end = data.index(b"\0")
    fields = dict(re.findall(r"^(\w+) *= *(.*)$", data[:end].decode(), re.M))
    columns, lines = int(fields["XRes"]), int(fields["YRes"])
    values = struct.unpack_from(f"<{columns * lines}f", data, end + 4 - end % 4)
    return ([values[i * columns:(i + 1) * columns] for i in range(lines)],
            float(fields["XReal"]) / columns)


def reduced_modulus(sample, tip=(169e9, 0.27)):
    """E* of two bodies, each (E, nu). docs/theory.md (1.1)"""
    return 1 / sum((1 - mpf(nu)**2) / mpf(modulus) for modulus, nu in (sample, tip))


class Maugis:
    """Maugis and Dugdale's contact, dimensional. docs/theory.md 1, 2.3, 2.4"""

    def __init__(self, radius, modulus, work, stress):
        radius, modulus, work, stress = map(mpf, (radius, modulus, work, stress))
        elastic = 4 * modulus / 3  # K
        self.unit_radius = mpmath.cbrt(mp.pi * work * radius**2 / elastic)
        self.unit_force = mp.pi * work * radius
        self.unit_length = self.unit_radius**2 / radius
        self.transition = 2 * stress * mpmath.cbrt(radius / (mp.pi * work * elastic**2))

    def at(self, phi):
        """(a, c, P, delta) of a state with contact, in units. (2.3) to (2.5)"""
        transition = self.transition
        sine, cosine = mpmath.sin(phi), mpmath.cos(phi)
        first = mpmath.sin(2 * phi) / 2 - phi * mpmath.cos(2 * phi)
        second = phi * sine - 2 * mpmath.sin(phi / 2)**2
        half = mpf(4) / 3 * transition**2 * second
        outer = 2 / (half + mpmath.sqrt(half**2 + 2 * transition * first))
        radius = outer * cosine
        return (radius, outer, radius**3 - transition * outer**2 * (phi + sine * cosine),
                radius**2 - mpf(4) / 3 * transition * outer * sine)

    def apart(self, outer):
        """(P, delta) of a cohesive zone without contact, in units. (2.6)"""
        transition = self.transition
        return (-mp.pi / 2 * transition * outer**2,
                outer**2 / 2 - 8 * transition / (3 * mp.pi) * outer - 2 / (mp.pi * transition))

    def phi_at(self, delta):
        """State with contact of the largest radius at an indentation in units."""
        low, high = mpf("1e-6"), mp.pi / 2
        phi = low  # delta falls from infinity: the first crossing is the stable state
        while self.at(phi)[3] > delta and phi < high:
            low, phi = phi, phi + mpf("0.01")
        return bisected(lambda at: self.at(at)[3] - delta, low, phi)

    def strongest_pull(self):
        """-P at the minimum of the force over all states with contact, in units."""
        best = min(((self.at(mpf(i) / 1000)[2], mpf(i) / 1000) for i in range(2, 1570)))[1]
        low, high = best - mpf("0.001"), best + mpf("0.001")
        ratio = (mpmath.sqrt(5) - 1) / 2
        for _ in range(80):
            left, right = high - ratio * (high - low), low + ratio * (high - low)
            if self.at(left)[2] < self.at(right)[2]:
                high = right
            else:
                low = left
        return -self.at((low + high) / 2)[2]


def bisected(function, low, high):
    """The zero of a function between two positions where its signs differ."""
    low, high = mpf(low), mpf(high)
    rises = function(high) > 0
    for _ in range(90):
        middle = (low + high) / 2
        if (function(middle) > 0) == rises:
            high = middle
        else:
            low = middle
    return (low + high) / 2
