#!/usr/bin/env python3
"""Fails on an include that goes against the arrows of the architecture (docs/architecture.md)."""

import pathlib
import re
import sys

TOP = pathlib.Path(__file__).resolve().parent.parent

# layer -> layers that it may include, besides itself
ALLOWED = {
    "core": set(),
    "core/realtime": {"core"},
    "core/surface": {"core"},
    "core/contact": {"core", "core/surface"},
    "core/probe": {"core", "core/surface", "core/contact"},
    "core/scene": {"core", "core/surface", "core/contact", "core/probe"},
    "core/haptics": {"core", "core/surface", "core/contact", "core/probe", "core/scene",
                     "core/realtime"},
}
ENGINE = set(ALLOWED)
ALLOWED["core/experiment"] = ENGINE
ALLOWED["core/fidelity"] = ENGINE
CORE = set(ALLOWED)
ALLOWED["core/io"] = CORE
ALLOWED["vtkplugins"] = CORE
ALLOWED["hardware"] = CORE
ALLOWED["ui"] = CORE | {"vtkplugins"}
ALLOWED["app"] = CORE | {"core/io", "vtkplugins", "hardware", "ui"}

# system headers that belong to one place only
FOREIGN = {
    re.compile(r"^(vtk|QVTK)"): {"vtkplugins", "ui"},
    re.compile(r"^Q[A-Z]"): {"ui", "app"},
    re.compile(r"^hidapi"): {"hardware"},
    re.compile(r"^(Imf|OpenEXR|tiff|png|toml|nlohmann|openssl)"): {"core/io", "app"},
    re.compile(r"^CLI/"): {"app"},
}
INCLUDE = re.compile(r'^\s*#\s*include\s+(["<])([^">]+)[">]')
SOURCES = {".h", ".cpp", ".cxx"}


def layer_of(path):
    """The longest known layer that holds this path, e.g. core/surface."""
    parts = path.split("/")
    for depth in (2, 1):
        name = "/".join(parts[:depth])
        if len(parts) > depth and name in ALLOWED:
            return name
    return None


def violations(file):
    own = layer_of(file.relative_to(TOP).as_posix())
    if own is None:
        yield f"{file.relative_to(TOP)}: no layer is known for this folder"
        return
    for number, line in enumerate(file.read_text().splitlines(), 1):
        match = INCLUDE.match(line)
        if not match:
            continue
        quoted, target = match.group(1) == '"', match.group(2)
        where = f"{file.relative_to(TOP)}:{number}"
        other = layer_of(target) if quoted else None
        if other and other != own and other not in ALLOWED[own]:
            yield f"{where}: {own} must not include {other}"
        if not other:
            for pattern, places in FOREIGN.items():
                if pattern.match(target) and own not in places:
                    yield f"{where}: {target} belongs to {', '.join(sorted(places))}"


def main():
    files = [f for top in ("core", "vtkplugins", "hardware", "ui", "app")
             for f in sorted((TOP / top).rglob("*")) if f.suffix in SOURCES]
    found = [line for f in files for line in violations(f)]
    print("\n".join(found) if found else f"{len(files)} files keep to the layers")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
