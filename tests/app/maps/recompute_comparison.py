#!/usr/bin/env python3
"""Every number of `asperity map --compare`, computed again from the definitions: a map of the true
instrument, whose material differs, against the believed model; one with a known linear relation
and noise; and a recorded height on another grid, tilted. Usage: recompute_comparison.py ASPERITY
SCAN

Maps are read here from .gwy, byte by byte, and written as .gsf; no code is shared with the
program."""

import json
import math
import pathlib
import random
import struct
import subprocess
import sys
import tempfile

TOLERANCE = 1e-9  # relative
GRID = (24, 18)
REGION = (100e-9, 120e-9, 340e-9, 300e-9)
SCENE = """[sample]
file = "{scan}"
youngs_modulus_pa = 72e9
poisson_ratio = 0.17
work_of_adhesion_j_m2 = 0.25

[tip]
radius_m = 30e-9

[approach]
setpoint_n = 5e-9

[truth]
youngs_modulus_pa = 20e9
poisson_ratio = 0.17
work_of_adhesion_j_m2 = 0.2
"""


class Gwy:
    """The images of a .gwy: title, (columns, rows), size [m], values; nan: masked."""

    def __init__(self, path):
        self.data = path.read_bytes()
        assert self.data[:4] == b"GWYP"
        _, items = self.object(4)[0]
        self.images = {}
        for key, field in items.items():
            if key.endswith("/data"):
                number = key.split("/")[1]
                values = list(field["data"])
                if mask := items.get(f"/{number}/mask"):
                    values = [math.nan if m > 0.5 else v for v, m in zip(values, mask["data"])]
                self.images[items[f"/{number}/data/title"]] = (
                    (field["xres"], field["yres"]), (field["xreal"], field["yreal"]), values)

    def text(self, at):
        end = self.data.index(b"\0", at)
        return self.data[at:end].decode(), end + 1

    def object(self, at):
        name, at = self.text(at)
        end = at + 4 + struct.unpack_from("<I", self.data, at)[0]
        at += 4
        items = {}
        while at < end:
            key, at = self.text(at)
            kind, at = chr(self.data[at]), at + 1
            if kind == "o":
                (_, items[key]), at = self.object(at)
            elif kind == "s":
                items[key], at = self.text(at)
            elif kind == "D":
                count = struct.unpack_from("<I", self.data, at)[0]
                items[key] = struct.unpack_from(f"<{count}d", self.data, at + 4)
                at += 4 + 8 * count
            else:
                size = {"b": 1, "i": 4, "d": 8}[kind]
                items[key] = struct.unpack_from({"b": "?", "i": "<i", "d": "<d"}[kind], self.data, at)[0]
                at += size
        return (name, items), at


def write_gsf(path, title, unit, grid, size, values):
    """Single precision. @return the values as they are in the file"""
    fields = {"XRes": grid[0], "YRes": grid[1], "XReal": repr(size[0]), "YReal": repr(size[1]),
              "XYUnits": "m", "ZUnits": unit, "Title": title}
    head = "Gwyddion Simple Field 1.0\n" + "".join(f"{k} = {v}\n" for k, v in fields.items())
    body = struct.pack(f"<{len(values)}f", *values)
    path.write_bytes(head.encode() + b"\0" * (4 - len(head) % 4) + body)
    return list(struct.unpack(f"<{len(values)}f", body))


def close(a, b, scale=None):
    return abs(a - b) <= TOLERANCE * (scale if scale is not None else max(abs(a), abs(b)))


def mean(values):
    return math.fsum(values) / len(values)


def check(channel, predicted, measured, end):
    """The numbers of a channel against values of all pixels, heights without their plane."""
    pairs = [(p, m) for p, m in zip(predicted, measured) if math.isfinite(p) and math.isfinite(m)]
    assert channel["pixels"] == len(predicted)
    assert channel["compared_pixels"] == len(pairs), channel
    assert channel["pixels_without_prediction"] == sum(math.isnan(p) for p in predicted)
    assert channel["pixels_without_measurement"] == sum(math.isnan(m) for m in measured)
    p, m = zip(*pairs)
    mean_p, mean_m = mean(p), mean(m)
    var_p = mean([(x - mean_p) ** 2 for x in p])
    var_m = mean([(y - mean_m) ** 2 for y in m])
    covariance = mean([(x - mean_p) * (y - mean_m) for x, y in pairs])
    slope = covariance / var_p
    offset = mean_m - slope * mean_p
    differences = [y - x for x, y in pairs]
    expected = {
        "measured_mean" + end: mean_m, "predicted_mean" + end: mean_p,
        "measured_standard_deviation" + end: math.sqrt(var_m),
        "predicted_standard_deviation" + end: math.sqrt(var_p),
        "mean_difference" + end: mean(differences),
        "rms_difference" + end: math.sqrt(mean([d * d for d in differences])),
        "line_offset" + end: offset,
        "line_rms_residual" + end: math.sqrt(mean([(y - offset - slope * x) ** 2 for x, y in pairs]))}
    scale = max(math.sqrt(var_p), math.sqrt(var_m), abs(mean_p), abs(mean_m))
    for key, value in expected.items():
        assert close(channel[key], value, scale), (key, channel[key], value)
    variance_left = mean([(d - mean(differences)) ** 2 for d in differences])
    for key, value in {"line_slope": slope, "correlation": covariance / math.sqrt(var_p * var_m),
                       "share_explained_by_line": covariance ** 2 / (var_p * var_m),
                       "share_explained_as_predicted": 1.0 - variance_left / var_m}.items():
        assert close(channel[key], value), (key, channel[key], value)
    assert channel["remark"] is None
    return slope, offset


def same(values, expected):
    scale = max(abs(e) for e in expected if math.isfinite(e))
    return all(math.isnan(v) == math.isnan(e) and (math.isnan(v) or close(v, e, scale))
               for v, e in zip(values, expected))


def check_layers(images, name, channel, predicted, measured, line):
    slope, offset = line
    difference = images[f"{name}, '{channel}' minus predicted"][2]
    assert same(difference, [m - p for p, m in zip(predicted, measured)])
    residual = images[f"{name}, '{channel}' minus its line over the prediction"][2]
    assert same(residual, [m - offset - slope * p for p, m in zip(predicted, measured)])


class Maps:
    def __init__(self, program, scene, folder):
        self.program, self.scene, self.folder = program, scene, folder

    def map(self, out, *more):
        command = [self.program, "map", str(self.scene), "--grid", "{}x{}".format(*GRID), "--region",
                   ",".join(map(str, REGION)), "--no-pictures", "--out", str(self.folder / out), *more]
        subprocess.run(command, check=True, capture_output=True, timeout=300)
        return Gwy(self.folder / out).images

    def compare(self, out, measured, *channels):
        options = [word for channel in channels for word in ("--channel", channel)]
        images = self.map(out, "--compare", str(measured), *options)
        report = json.loads((self.folder / out).with_suffix(".compare.json").read_text())
        return images, {channel["quantity"]: channel for channel in report["channels"]}


def check_other_material(maps):
    truth = maps.map("true.gwy", "--truth")
    names = {"adhesion force": "_n", "contact stiffness": "_n_m", "indentation": "_m"}
    images, channels = maps.compare("belief.gwy", maps.folder / "true.gwy", *names)
    keys = dict(zip(names, ("adhesion_force", "stiffness", "indentation")))
    for name, end in names.items():
        predicted, measured = images[name][2], truth[name][2]
        line = check(channels[keys[name]], predicted, measured, end)
        check_layers(images, name, name, predicted, measured, line)
        share = channels[keys[name]]["share_explained_by_line"]
        if name != "indentation":  # in valleys it depends on the material in other ways
            assert share > 0.9, (name, share)  # the true material is the same everywhere, too
        assert channels[keys[name]]["rms_difference" + end] > 0.0
    return truth, images


def check_same(maps, images):
    _, channels = maps.compare("same.gwy", maps.folder / "belief.gwy", "adhesion force", "height at the setpoint")
    for channel, end in ((channels["adhesion_force"], "_n"), (channels["height"], "_m")):
        assert channel["correlation"] == 1.0 and channel["share_explained_by_line"] == 1.0, channel
        assert channel["share_explained_as_predicted"] == 1.0
        assert channel["rms_difference" + end] == 0.0


def check_noise(maps, images):
    """A share that is known beforehand, to what random numbers allow."""
    grid, size, predicted = images["adhesion force"]
    spread = math.sqrt(mean([(p - mean(predicted)) ** 2 for p in predicted]))
    random.seed(1)
    made = [2e-9 + 0.5 * p + random.gauss(0.0, 0.5 * spread) for p in predicted]
    made[5] = math.nan
    measured = write_gsf(maps.folder / "noisy.gsf", "Adhesion", "N", grid, size, made)
    compared, channels = maps.compare("noise.gwy", maps.folder / "noisy.gsf", "Adhesion")
    line = check(channels["adhesion_force"], predicted, measured, "_n")
    check_layers(compared, "adhesion force", "Adhesion", predicted, measured, line)
    share = channels["adhesion_force"]["share_explained_by_line"]
    # 1/2 of the variance; the standard error of a correlation is (1 - r^2) / sqrt(n).
    error = 2.0 * math.sqrt(0.5) * 0.5 / math.sqrt(len(predicted))
    assert abs(share - 0.5) < 4.0 * error, share


def sample(grid, values, x, y):
    """Bilinear; x and y from 0 to 1, from the upper left corner."""
    u = min(max(x * grid[0] - 0.5, 0.0), grid[0] - 1.0)
    v = min(max(y * grid[1] - 0.5, 0.0), grid[1] - 1.0)
    i, j = min(int(u), grid[0] - 2), min(int(v), grid[1] - 2)
    u, v = u - i, v - j
    row = lambda k: (1.0 - u) * values[k * grid[0] + i] + u * values[k * grid[0] + i + 1]
    return (1.0 - v) * row(j) + v * row(j + 1)


def check_tilted_height(maps, images):
    """A height on another grid, with a plane, compared with an explicit quantity."""
    (columns, rows), size, predicted = images["height at the setpoint"]
    grid = (31, 40)
    places = [((i % grid[0] + 0.5) / grid[0], (i // grid[0] + 0.5) / grid[1]) for i in range(grid[0] * grid[1])]
    made = [sample((columns, rows), predicted, x, y) + 3e-9 + 2e-8 * x + 1e-8 * y for x, y in places]
    stored = write_gsf(maps.folder / "tilted.gsf", "ZSensor", "m", grid, size, made)
    compared, channels = maps.compare("tilt.gwy", maps.folder / "tilted.gsf", "ZSensor:height")
    channel = channels["height"]
    plane = channel["removed_plane"]
    assert abs(plane["slope_x"] - 2e-8 / size[0]) < 0.01 * 2e-8 / size[0], plane
    assert abs(plane["slope_y"] + 1e-8 / size[1]) < 0.01 * 2e-8 / size[1], plane
    measured = [sample(grid, stored, (i % columns + 0.5) / columns, (i // columns + 0.5) / rows)
                for i in range(columns * rows)]
    lowered = []
    for i, value in enumerate(measured):  # the plane's mean is at the middle: all pixels have data
        x = ((i % columns + 0.5) / columns - 0.5) * size[0]
        y = (0.5 - (i // columns + 0.5) / rows) * size[1]
        lowered.append(value - plane["mean_m"] - plane["slope_x"] * x - plane["slope_y"] * y)
    both = channel["plane_removed_from_both"]
    level = []
    for values in (predicted, lowered):
        level.append([])
        for i, value in enumerate(values):
            x = ((i % columns + 0.5) / columns - 0.5) * size[0]
            y = (0.5 - (i // columns + 0.5) / rows) * size[1]
            level[-1].append(value - both["mean_m"] - both["slope_x"] * x - both["slope_y"] * y)
    predicted, lowered = level
    line = check(channel, predicted, lowered, "_m")
    check_layers(compared, "height at the setpoint", "ZSensor", predicted, lowered, line)
    left = [m - p for p, m in zip(predicted, lowered)]  # a least-squares plane leaves no plane
    for weights in ([1.0] * len(left), [i % columns for i in range(len(left))], [i // columns for i in range(len(left))]):
        assert abs(math.fsum(w * d for w, d in zip(weights, left))) < 1e-6 * math.fsum(w * abs(d) for w, d in zip(weights, left))


def main():
    program, scan = sys.argv[1], pathlib.Path(sys.argv[2]).resolve()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        scene = folder / "scene.toml"
        scene.write_text(SCENE.format(scan=scan))
        maps = Maps(program, scene, folder)
        _, images = check_other_material(maps)
        check_same(maps, images)
        check_noise(maps, images)
        check_tilted_height(maps, images)


if __name__ == "__main__":
    main()
