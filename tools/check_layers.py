#!/usr/bin/env python3
"""Fails on an include against the arrows of the architecture (docs/architecture.md), on a folder
that no rule names, and on folders that include each other in a circle.
Usage: check_layers.py [TREE]"""

import collections
import functools
import graphlib
import pathlib
import re
import sys

# folder -> the folders on which it stands: it includes these, and all on which they stand. "a/*": each
# folder right in a that has no line of its own; none includes another one, or is included but by name.
ARROWS = {
    "core": "",
    "core/realtime": "core",
    "core/curves": "core",
    "core/surface": "core",
    "core/surface/closest": "core/surface",
    "core/surface/deformation": "core/surface/closest",
    "core/surface/fit": "core/surface",
    "core/surface/imaging": "core/surface",
    "core/surface/leveling": "core/surface",
    "core/surface/measure": "core/surface/fit",
    "core/surface/nurbs": "core/surface/closest",
    "core/surface/synthetic": "core/surface",
    "core/surface/sample": "core/surface/nurbs",
    "core/contact": "core",
    "core/contact/numerics": "core",
    "core/contact/halfspace": "core",
    "core/contact/maugis": "core/contact core/contact/numerics",
    "core/contact/laws": "core/contact/maugis",
    "core/contact/displacement": "core/contact/laws core/surface",
    "core/probe": "core/contact/laws core/surface/sample",
    "core/probe/recorded": "core/curves core/probe",
    "core/scene": "core/contact/displacement core/probe core/surface/deformation core/surface/imaging"
                  " core/surface/leveling core/surface/measure core/surface/synthetic",
    "core/identify": "core/contact/laws core/curves",
    "core/identify/cycle": "core/identify",
    "core/deformation": "core/contact/halfspace core/scene",
    "core/haptics/cycle": "core/scene",
    "core/haptics/device": "core/realtime core/scene",
    "core/haptics/governor": "core/scene",
    "core/haptics/mapping": "core/scene",
    "core/haptics/fixtures": "core/haptics/mapping",
    "core/haptics/coupling": "core/haptics/device core/haptics/mapping",
    "core/haptics": "core/haptics/coupling core/haptics/cycle core/haptics/fixtures core/haptics/governor",
    "core/haptics/bench": "core/haptics/device",
    "core/haptics/blackbox": "core/haptics",
    "core/uncertainty": "core/haptics/cycle",
    "core/map": "core/uncertainty",
    "core/experiment": "core/haptics core/haptics/bench",
    "core/fidelity": "core/deformation core/haptics core/map",
    "core/studies": "core/fidelity",
    "core/studies/extremes": "core/fidelity core/haptics/bench",
    "core/words": "core/fidelity",
    "core/io": "core",
    "core/io/tables": "core/io",
    "core/io/zip": "core/io",
    "core/io/hdf5": "core/io",
    "core/io/hdf5/reader": "core/io/hdf5",
    "core/io/fields": "core/surface/deformation",
    "core/io/heightmap": "core/io core/surface",
    "core/io/heightmap/*": "core/io/heightmap",
    "core/io/heightmap/jpk": "core/io/heightmap/tiff",
    "core/io/heightmap/jpkarchive": "core/io/heightmap/jpk core/io/zip",
    "core/io/heightmap/nexus": "core/io/heightmap core/io/hdf5",
    "core/io/heightmap/park": "core/io/heightmap/tiff",
    "core/io/heightmap/x3p": "core/io/heightmap core/io/zip",
    "core/io/curves": "core/curves core/io/heightmap",
    "core/io/curves/igor": "core/io/curves core/io/heightmap/igor",
    "core/io/curves/jpk": "core/io/curves core/io/zip",
    "core/io/curves/nanoscope": "core/io/curves core/io/heightmap/nanoscope",
    "core/io/curves/nanosurf": "core/io/curves core/io/heightmap/nanosurf",
    "core/io/curves/text": "core/io/curves core/io/zip",
    "core/io/materials": "core/io/heightmap core/scene",
    "core/io/loading": "core/io/curves core/io/materials core/probe/recorded",
    "core/io/scene": "core/haptics core/io/tables",
    "core/io/experiment": "core/experiment core/io/scene",
    "core/io/recording": "core/haptics core/io/hdf5 core/io/tables",
    "vtkplugins/module": "core/surface/deformation",
    "vtkplugins/io": "core/io/heightmap core/surface/deformation",
    "vtkplugins/pictures": "vtkplugins/module",
    "vtkplugins/paraview/module": "core/deformation core/io/loading core/io/scene core/map vtkplugins/module",
    "hardware/driver": "core/haptics/device core/words",
    "hardware/*": "hardware/driver",
    "hardware/spacemouse": "hardware/hid",
    "hardware/woodenhaptics": "core/io/scene hardware/hid",
    "hardware": "core/haptics/bench hardware/piloted hardware/spacemouse hardware/woodenhaptics",
    "ui/widgets": "core/words vtkplugins/pictures",
    "ui/plot": "ui/widgets",
    "ui/view": "ui/plot",
    "ui/shell": "ui/view",
    "app/program": "core/io core/probe/recorded core/words",
    "app/runs": "app/program core/haptics/blackbox core/io/recording core/io/scene",
    "app/recording": "app/runs core/io/heightmap core/io/zip",
    "app/loading": "app/recording core/io/loading",
    "app/charts": "core/io vtkplugins/pictures",
    "app/curves": "app/charts app/runs core/identify/cycle core/io/curves core/io/heightmap/gwy"
                  " core/io/scene core/io/tables",
    "app/reports": "app/charts app/runs core/io/fields core/studies core/studies/extremes ui/view",
    "app/reports/page": "app/charts",
    "app/reports/run": "app/reports app/reports/page",
    "app/exports": "app/loading app/reports vtkplugins/io",
    "app/experiment": "app/exports core/io/experiment",
    "app/maps": "app/exports core/io/heightmap/exr core/io/heightmap/gwy core/io/heightmap/vti",
    "app/window/live": "ui/shell",
    "app/window": "app/exports app/window/live",
    "app/window/*": "app/window",
    "app/window/curve": "app/curves app/window",
    "app/window/device": "app/window hardware",
    "app/window/map": "app/maps app/window",
    "app/window/study": "app/experiment app/window hardware/driver",
    "app/window/lab": "app/window/curve app/window/device app/window/export app/window/fidelity"
                      " app/window/map app/window/measure app/window/recording app/window/scene"
                      " app/window/session app/window/study",
    "app/commands": "app/curves app/reports/run app/window/lab",
    "app": "app/commands",  # main
    "tools/samples": "app",
    "tools/screenshots": "app",
    "examples": "core/fidelity core/io/loading core/io/scene core/studies",
    "cmake": "",  # sources that CMake adds to programs
}
# folders that include whatever they measure or test; beside them each folder of the product has its tests
FREE = re.compile(r"bench(/(contact|curves|fidelity|haptics|io|map|probe|program|scaling|surface))?"
                  r"|tests/(bench(/scaling)?|fuzz|support|vtkplugins)")

# headers of others that belong to some places only
FOREIGN = {
    r"mpi\.h": "app/maps",
    r"(vtk|QVTK)": "vtkplugins/ ui/ bench/ tests/ tools/",
    r"(Q[A-Z]|Qt|q[a-z]+\.h|qwt_)": "ui/ app/charts app/exports app/window/ app/commands app/reports/ bench/ tests/"
               " tools/",
    r"(thread|mutex|fstream)$": "core/ app/ hardware/ vtkplugins/ bench/ tests/ tools/ examples/",
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
SOURCES = {".h", ".hpp", ".inl", ".tpp", ".ipp", ".c", ".cc", ".cpp", ".cxx"}
# Other ways of writing it (import, %:, a broken line) name no file that this reads, and are refused.
INCLUDE = re.compile(r'^\s*(?:#|%:)\s*(?:include(?:_next)?\b\s*(?:(["<])([^">]+)[">])?|import\b|in[a-z]*\\$)')
COMMENT = re.compile(r"/\*.*?\*/")


def line_of(folder):
    """The folders on which this one stands; None: no line names it."""
    line = ARROWS.get(folder, ARROWS.get(folder.rpartition("/")[0] + "/*"))
    return None if line is None else line.split()


@functools.cache
def beneath(folder):
    """All folders that this one may include."""
    return set(line_of(folder)).union(*map(beneath, line_of(folder)))


def is_free(folder):
    """Whether a folder may include all others."""
    tested = re.sub("^tests/", "", folder)
    return bool(FREE.fullmatch(folder)) or (tested != folder and line_of(tested) is not None)


def is_known(folder):
    return is_free(folder) or line_of(folder) is not None


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
        match = INCLUDE.match(COMMENT.sub("", line))
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
    if not is_known(other) or not (tree / target).is_file() or not quoted:
        return f'no source "{target}": quote its path from the top folder'
    if pathlib.Path(name).suffix not in SOURCES:
        return f"{target} has no suffix of a source"
    if other != own and not is_free(own) and other not in beneath(own):
        return f"{own} must not include {other}"
    return None


def violations(tree, name):
    own = name.rpartition("/")[0]
    if not is_known(own):
        yield f"{name}: no rule names this folder"
        return
    for number, quoted, target in includes_of(tree / name):
        fault = fault_of(tree, own, quoted, target)
        if fault:
            yield f"{name}:{number}: {fault}"


def circle(tree, names):
    """One sentence where folders include each other in a circle."""
    graph = collections.defaultdict(dict)  # folder -> {folder that it includes: the first include that does}
    for name in names:
        own = name.rpartition("/")[0]
        for number, quoted, target in includes_of(tree / name):
            other = target.rpartition("/")[0] if quoted and target else own
            if other != own:
                graph[own].setdefault(other, f"{name}:{number}")
    try:
        graphlib.TopologicalSorter(graph).prepare()
    except graphlib.CycleError as error:
        way = error.args[1][::-1]
        yield f"{graph[way[0]][way[1]]}: folders include each other in a circle: {' -> '.join(way)}"


def main(tree):
    names = list(sources_of(tree))
    found = [line for name in names for line in violations(tree, name)]
    found += circle(tree, names)
    print("\n".join(found) if found else f"{len(names)} files keep to the layers")
    return 1 if found or not names else 0


if __name__ == "__main__":
    own_tree = pathlib.Path(__file__).resolve().parent.parent
    sys.exit(main(pathlib.Path(sys.argv[1]) if sys.argv[1:] else own_tree))
