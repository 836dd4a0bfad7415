#!/usr/bin/env python3
"""Fails on an include against the arrows of the architecture (docs/architecture.md), on a folder
that no rule names, and on folders that include each other in a circle."""

import collections
import pathlib
import re
import sys

TOP = pathlib.Path(__file__).resolve().parent.parent

# layer -> layers that it may include, besides itself; a layer holds its sub-folders
ALLOWED = {
    "core": set(),
    "core/realtime": {"core"},
    "core/surface": {"core"},
    "core/contact": {"core", "core/surface"},
    "core/probe": {"core", "core/surface", "core/contact"},
    "core/scene": {"core", "core/surface", "core/contact", "core/probe"},
}
SCENE = {"core", "core/surface", "core/contact", "core/probe", "core/scene"}
ALLOWED["core/deformation"] = SCENE
ALLOWED["core/haptics"] = SCENE | {"core/realtime"}
ALLOWED["core/fidelity"] = SCENE | {"core/realtime", "core/deformation", "core/haptics"}
ENGINE = ALLOWED["core/fidelity"] | {"core/fidelity"}
ALLOWED["core/studies"] = ENGINE
ALLOWED["core/io"] = {"core"}
ALLOWED["core/io/tables"] = {"core", "core/io"}
ALLOWED["core/io/heightmap"] = {"core", "core/io", "core/surface"}
ALLOWED["core/io/fields"] = {"core", "core/io", "core/surface"}
ALLOWED["core/io/scene"] = SCENE | {"core/haptics", "core/io", "core/io/tables"}
ALLOWED["core/io/recording"] = SCENE | {"core/haptics", "core/io", "core/io/tables"}
ALLOWED["core/words"] = set(ALLOWED)
CORE = set(ALLOWED)
ALLOWED["vtkplugins"] = ENGINE
ALLOWED["hardware"] = ENGINE | {"core/io/scene", "core/words"}
ALLOWED["ui"] = ENGINE | {"core/studies", "core/words", "vtkplugins"}
ALLOWED["app"] = CORE | {"vtkplugins", "hardware", "ui"}
PRODUCT = set(ALLOWED)
ALLOWED["bench"] = PRODUCT | {"tests", "tools"}
ALLOWED["tools"] = PRODUCT
ALLOWED["examples"] = CORE
ALLOWED["tests"] = PRODUCT | {"bench", "tools"}
# The one file that starts the program: it includes what includes all others.
ROOTS = {"app/main.cpp"}

# system headers that belong to some places only
FOREIGN = {
    re.compile(r"^(vtk|QVTK)"): {"vtkplugins", "ui", "bench", "tests", "tools"},
    re.compile(r"^Q[A-Z]"): {"ui", "app", "bench", "tests", "tools"},
    re.compile(r"^hidapi"): {"hardware", "tests"},
    re.compile(r"^(Imf|OpenEXR)"): {"core/io/heightmap", "core/io/fields", "bench", "tests"},
    re.compile(r"^(tiff|png)"): {"core/io/heightmap", "app", "tests"},
    re.compile(r"^toml"): {"core/io/scene", "app", "tests"},
    re.compile(r"^openssl"): {"core/io"},
    re.compile(r"^nlohmann"): {"app", "bench", "tests"},
    re.compile(r"^CLI/"): {"app", "bench", "tests", "tools"},
}
INCLUDE = re.compile(r'^\s*#\s*include\s+(["<])([^">]+)[">]')
SOURCES = {".h", ".cpp", ".cxx"}


def layer_of(path):
    """The longest known layer that holds this path, e.g. core/io/heightmap."""
    folder = path.rpartition("/")[0]
    while folder and folder not in ALLOWED:
        folder = folder.rpartition("/")[0]
    # What lies below core must be named: core itself is what all may include.
    return None if folder == "core" and path.count("/") > 1 else folder or None


def includes_of(file):
    """(line number, is quoted, target) of each include."""
    for number, line in enumerate(file.read_text(errors="replace").splitlines(), 1):
        match = INCLUDE.match(line)
        if match:
            yield number, match.group(1) == '"', match.group(2)


def violations(file):
    name = file.relative_to(TOP).as_posix()
    own = layer_of(name)
    if own is None:
        yield f"{name}: no layer is known for this folder"
        return
    for number, quoted, target in includes_of(file):
        where = f"{name}:{number}"
        other = layer_of(target) if quoted else None
        if other and other != own and other not in ALLOWED[own]:
            yield f"{where}: {own} must not include {other}"
        if not other:
            for pattern, places in FOREIGN.items():
                if pattern.match(target) and own not in places:
                    yield f"{where}: {target} belongs to {', '.join(sorted(places))}"


def folder_graph(files):
    """folder -> {folder that it includes: the first include that does}"""
    graph = collections.defaultdict(dict)
    for file in files:
        name = file.relative_to(TOP).as_posix()
        if name in ROOTS:
            continue
        own = name.rpartition("/")[0]
        for number, quoted, target in includes_of(file):
            other = target.rpartition("/")[0]
            if quoted and other and other != own:
                graph[own].setdefault(other, f"{name}:{number}")
    return graph


def circles(graph):
    """One sentence for each pair of folders that reach each other, by their shortest way back."""
    for start in sorted(graph):
        way = {start: None}
        queue = collections.deque([start])
        while queue:
            folder = queue.popleft()
            for other in graph.get(folder, {}):
                if other not in way:
                    way[other] = folder
                    queue.append(other)
        for back in sorted(f for f in way if start in graph.get(f, {}) and f != start):
            steps = [start]
            folder = back
            while folder:
                steps.insert(1, folder)
                folder = way[folder] if way[folder] != start else None
            if start == min(steps):
                yield (f"{graph[back][start]}: folders include each other in a circle: "
                       f"{' -> '.join(steps)} -> {start}")


def main():
    files = [f for top in ("core", "vtkplugins", "hardware", "ui", "app", "bench", "tools", "tests",
                               "examples")
             for f in sorted((TOP / top).rglob("*")) if f.suffix in SOURCES]
    found = [line for f in files for line in violations(f)] + list(circles(folder_graph(files)))
    print("\n".join(found) if found else f"{len(files)} files keep to the layers")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
