#!/usr/bin/env python3
"""Fails on an include against the arrows of the architecture (docs/architecture.md), on a folder
that no rule names, and on folders that include each other in a circle.
Usage: check_layers.py [TREE]"""

import collections
import pathlib
import re
import sys

# folder -> folders that its sources may include besides itself; "core/io/": with all below it.
# A new folder is a new line: a rule holds for the folder that it names, for none below.
CONTACT = "core core/surface/"
LAWS = f"{CONTACT} core/contact core/contact/numerics"
PROBE = f"{CONTACT} core/contact/"
SCENE = f"{PROBE} core/probe"
LOOP = f"{SCENE} core/scene core/realtime"
ENGINE = f"{LOOP} core/deformation core/haptics/"
MODEL = f"{ENGINE} core/fidelity"
FILES = "core core/io"
READERS = f"{FILES} core/surface/ core/io/heightmap"
RUNS = f"{SCENE} core/scene core/haptics/ core/io core/io/tables"
DRIVER = f"{MODEL} core/io/scene core/words hardware/driver hardware/hid"
WINDOW = f"{MODEL} core/studies/ core/words vtkplugins/ ui"
BELOW_APP = "core/ vtkplugins/ hardware/ ui/"
PRODUCT = f"{BELOW_APP} app/"
BENCH = f"{PRODUCT} tests/ tools/"
TESTS = f"{BENCH} bench/"
RULES = {
    "core": "",
    "core/realtime": "core",
    "core/surface": "core",
    "core/curves": "core",
    "core/surface/closest": "core core/surface",
    "core/surface/deformation": "core core/surface core/surface/closest",
    "core/surface/fit": "core core/surface",
    "core/surface/imaging": "core core/surface",
    "core/surface/leveling": "core core/surface",
    "core/surface/measure": "core core/surface core/surface/fit",
    "core/surface/nurbs": "core core/surface core/surface/closest",
    "core/surface/synthetic": "core core/surface",
    "core/surface/sample": "core core/surface core/surface/closest core/surface/nurbs",
    "core/contact": CONTACT,
    "core/contact/numerics": CONTACT,
    "core/contact/halfspace": CONTACT,
    "core/contact/maugis": LAWS,
    "core/contact/laws": f"{LAWS} core/contact/maugis",
    "core/contact/displacement": f"{LAWS} core/contact/laws",
    "core/probe": PROBE,
    "core/scene": SCENE,
    "core/deformation": f"{SCENE} core/scene",
    "core/map": f"{SCENE} core/scene core/uncertainty",
    "core/uncertainty": f"{SCENE} core/scene core/haptics/cycle",
    "core/haptics/cycle": LOOP,
    "core/haptics/device": LOOP,
    "core/haptics/governor": LOOP,
    "core/haptics/mapping": LOOP,
    "core/haptics/fixtures": f"{LOOP} core/haptics/mapping",
    "core/haptics/coupling": f"{LOOP} core/haptics/device core/haptics/mapping",
    "core/haptics": f"{LOOP} core/haptics/device core/haptics/governor core/haptics/mapping"
                    " core/haptics/fixtures core/haptics/coupling core/haptics/cycle",
    "core/haptics/bench": f"{LOOP} core/haptics core/haptics/device",
    "core/haptics/blackbox": f"{LOOP} core/haptics",
    "core/experiment": f"{LOOP} core/haptics/",
    "core/fidelity": f"{ENGINE} core/map",
    "core/studies": MODEL,
    "core/studies/extremes": f"{MODEL} core/studies",
    "core/io": "core",
    "core/io/tables": FILES,
    "core/io/curves": f"{FILES} core/curves core/io/heightmap",
    "core/io/fields": f"{FILES} core/surface/",
    "core/io/hdf5": FILES,
    "core/io/hdf5/reader": f"{FILES} core/io/hdf5",
    "core/io/zip": FILES,
    "core/io/heightmap": f"{FILES} core/surface/",
    "core/io/heightmap/bcr": READERS,
    "core/io/heightmap/digitalsurf": READERS,
    "core/io/heightmap/exr": READERS,
    "core/io/heightmap/gsf": READERS,
    "core/io/heightmap/gwy": READERS,
    "core/io/heightmap/gwyddion": READERS,
    "core/io/heightmap/igor": READERS,
    "core/io/heightmap/jpk": f"{READERS} core/io/heightmap/tiff",
    "core/io/heightmap/jpkarchive": f"{READERS} core/io/heightmap/jpk core/io/zip",
    "core/io/heightmap/nanonis": READERS,
    "core/io/heightmap/nanoscope": READERS,
    "core/io/heightmap/nanosurf": READERS,
    "core/io/heightmap/nexus": f"{READERS} core/io/hdf5",
    "core/io/heightmap/park": f"{READERS} core/io/heightmap/tiff",
    "core/io/heightmap/picoview": READERS,
    "core/io/heightmap/png": READERS,
    "core/io/heightmap/sdf": READERS,
    "core/io/heightmap/text": READERS,
    "core/io/heightmap/tiff": READERS,
    "core/io/heightmap/vti": READERS,
    "core/io/heightmap/wsxm": READERS,
    "core/io/heightmap/x3p": f"{READERS} core/io/zip",
    "core/io/materials": f"{SCENE} core/scene core/io core/io/heightmap",
    "core/io/loading": f"{SCENE} core/scene core/io core/io/heightmap core/io/materials",
    "core/io/scene": RUNS,
    "core/io/experiment": f"{RUNS} core/experiment core/io/scene",
    "core/io/recording": f"{RUNS} core/io/hdf5",
    "core/words": "core/",
    "vtkplugins/module": MODEL,
    "vtkplugins/io": f"{MODEL} core/io/heightmap",
    "vtkplugins/paraview/module": f"{MODEL} core/map core/io core/io/heightmap core/io/loading"
                                  " core/io/scene vtkplugins/module",
    "vtkplugins/pictures": f"{MODEL} vtkplugins/module",
    "hardware/driver": f"{MODEL} core/io/scene core/words",
    "hardware/hid": f"{MODEL} core/io/scene core/words hardware/driver",
    "hardware/piloted": DRIVER,
    "hardware/spacemouse": DRIVER,
    "hardware/woodenhaptics": DRIVER,
    "hardware": f"{DRIVER} hardware/",
    "ui": f"{MODEL} core/studies/ core/words vtkplugins/",
    "ui/help": f"{WINDOW} ui/panels ui/view",
    "ui/panels": f"{WINDOW} core/uncertainty",
    "ui/view": WINDOW,
    "ui/measure": f"{WINDOW} core/map core/uncertainty ui/panels",
    "ui/playback": f"{WINDOW} ui/panels ui/measure",
    "ui/experiment": f"{WINDOW} ui/panels ui/measure",
    "ui/window": f"{WINDOW} ui/help ui/panels ui/view",
    "app/program": "core/",
    "app/runs": "core/ app/program",
    "app/recording": "core/ app/program app/runs",
    "app/loading": "core/ app/program app/runs app/recording",
    "app/reports/page": "core/ vtkplugins/pictures",
    "app/reports": f"{BELOW_APP} app/program app/runs",
    "app/exports": f"{BELOW_APP} app/program app/runs app/reports app/recording app/loading",
    "app/experiment": f"{BELOW_APP} app/program app/runs app/recording app/loading app/exports",
    "app/maps": f"{BELOW_APP} app/program app/exports",
    "app/session": f"{BELOW_APP} app/program app/runs app/reports app/recording app/loading"
                   " app/exports app/experiment app/maps",
    "app/commands": f"{BELOW_APP} app/program app/runs app/reports/ app/recording app/loading"
                    " app/exports app/experiment app/maps app/session",
    "app/reports/run": f"{BELOW_APP} app/program app/runs app/reports app/reports/page",
    "app": PRODUCT,  # main
}
RULES |= {f"tests/{folder}": TESTS for folder in RULES} | {
    "tests/app/window": TESTS,
    "tests/bench": TESTS,
    "tests/bench/scaling": TESTS,
    "tests/fuzz": TESTS,
    "tests/support": TESTS,
    "tests/vtkplugins": TESTS,
    "bench": BENCH,
    "bench/contact": f"{BENCH} bench",
    "bench/fidelity": f"{BENCH} bench",
    "bench/haptics": f"{BENCH} bench",
    "bench/io": f"{BENCH} bench",
    "bench/map": f"{BENCH} bench",
    "bench/probe": f"{BENCH} bench",
    "bench/program": f"{BENCH} bench",
    "bench/scaling": f"{BENCH} bench bench/surface",
    "bench/surface": f"{BENCH} bench",
    "tools/samples": PRODUCT,
    "tools/screenshots": PRODUCT,
    "examples": "core/",
    "cmake": "",  # sources that CMake adds to programs
}

# headers of others that belong to some places only
FOREIGN = {
    r"mpi\.h": "app/maps",
    r"(vtk|QVTK)": "vtkplugins/ ui/ bench/ tests/ tools/",
    r"Q[A-Z]": "ui/ app/exports app/session app/commands app/reports/page bench/ tests/ tools/",
    r"hidapi": "hardware/ tests/",
    r"(Imf|OpenEXR)": "core/io/heightmap/ core/io/fields bench/ tests/",
    r"(tiff|png)": "core/io/heightmap/ app/ tests/",
    r"zip": "core/io/zip tests/",
    r"pugixml": "core/io/heightmap/ tests/",
    r"hdf5": "core/io/hdf5/ tests/",
    r"toml": "core/io/scene app/ tests/",
    r"openssl": "core/io",
    r"nlohmann": "app/ bench/ tests/",
    r"CLI/": "app/ bench/ tests/ tools/",
}
GENERATED = {"vtkAsperityModule.h", "vtkAsperityParaViewModule.h"}  # by CMake, included by its name alone
SOURCES = {".h", ".hpp", ".inl", ".c", ".cc", ".cpp", ".cxx"}
INCLUDE = re.compile(r'^\s*#\s*include\b\s*(?:(["<])([^">]+)[">])?')


def is_in(folder, places):
    """Whether one of the places is this folder, or ends in a slash and holds it."""
    return any(place in (folder, folder + "/") or (place[-1] == "/" and folder.startswith(place))
               for place in places.split())


def sources_of(tree):
    """All sources of the tree but those that are built or hidden (.gitignore)."""
    for file in sorted(tree.rglob("*")):
        name = file.relative_to(tree)
        if file.suffix in SOURCES and not re.match(r"(build|out|\.[^/]*)/", name.as_posix()):
            yield name.as_posix()


def includes_of(file):
    """(line number, is quoted, target or None) of each include."""
    for number, line in enumerate(file.read_text(errors="replace").splitlines(), 1):
        match = INCLUDE.match(line)
        if match:
            yield number, match.group(1) == '"', match.group(2)


def fault_of(tree, own, quoted, target):
    """What is wrong with an include by a file of the folder `own`; None: nothing."""
    if target is None:
        return "an include must name its file"
    if target in GENERATED:
        return None
    if not quoted and not target.startswith(".") and not (tree / target).is_file():
        places = next((p for start, p in FOREIGN.items() if re.match(start, target)), None)
        return None if places is None or is_in(own, places) else f"{target} belongs to {places}"
    other, _, name = target.rpartition("/")
    if other not in RULES or not (tree / target).is_file() or not quoted:
        return f'no source "{target}": quote its path from the top folder'
    if pathlib.Path(name).suffix not in SOURCES:
        return f"{target} has no suffix of a source"
    if other != own and not is_in(other, RULES[own]):
        return f"{own} must not include {other}"
    return None


def violations(tree, name):
    own = name.rpartition("/")[0]
    if own not in RULES:
        yield f"{name}: no rule names this folder"
        return
    for number, quoted, target in includes_of(tree / name):
        fault = fault_of(tree, own, quoted, target)
        if fault:
            yield f"{name}:{number}: {fault}"


def folder_graph(tree, names):
    """folder -> {folder that it includes: the first include that does}"""
    graph = collections.defaultdict(dict)
    for name in names:
        own = name.rpartition("/")[0]
        for number, quoted, target in includes_of(tree / name):
            other = target.rpartition("/")[0] if quoted else None
            if other and other != own:
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


def main(tree):
    names = list(sources_of(tree))
    found = [line for name in names for line in violations(tree, name)]
    found += circles(folder_graph(tree, names))
    print("\n".join(found) if found else f"{len(names)} files keep to the layers")
    return 1 if found or not names else 0


if __name__ == "__main__":
    own_tree = pathlib.Path(__file__).resolve().parent.parent
    sys.exit(main(pathlib.Path(sys.argv[1]) if sys.argv[1:] else own_tree))
