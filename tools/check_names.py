#!/usr/bin/env python3
"""Fails where two files define a type of the same name in the same namespace: no compiler sees
both, and the linker keeps the members of one for the two (the One Definition Rule).
Usage: check_names.py [TREE]"""

import collections
import pathlib
import re
import sys

TREES = ("app", "bench", "core", "examples", "hardware", "tests", "tools", "ui", "vtkplugins")
SOURCES = {".h", ".hpp", ".inl", ".cpp", ".cxx"}
# As clang-format leaves them: what a namespace holds is not indented, its end is named.
OPENS = re.compile(r"(?:inline )?namespace( [\w:]+)? \{$")
CLOSES = re.compile(r"\}\s+// namespace")
DEFINES = re.compile(r"(?:struct|class|union|enum(?: class| struct)?) (?:\[\[\w+\]\] )?(?:alignas\([^)]*\) )?"
                     r"(\w+)(?: final)?(?: : [^;]*)?(?: \{.*| :)?$")


def types_of(text):
    """(line, qualified name) of each type that other files can see."""
    spaces = []
    lines = text.splitlines()
    for number, line in enumerate(lines, 1):
        if opened := OPENS.match(line):
            spaces.append((opened[1] or "").strip())
        elif CLOSES.match(line) and spaces:
            spaces.pop()
        elif (found := DEFINES.match(line)) and "" not in spaces:
            specialized = number > 1 and lines[number - 2].startswith("template <>")
            if not specialized:
                yield number, "::".join([*spaces, found[1]])


def main(tree):
    places = collections.defaultdict(list)
    for top in TREES:
        for file in sorted((tree / top).rglob("*")):
            if file.suffix in SOURCES:
                for number, name in types_of(file.read_text()):
                    places[name].append(f"{file.relative_to(tree)}:{number}")
    faults = [f"{place}: {name} is defined in {found[0]}, too"
              for name, found in sorted(places.items()) for place in found[1:]]
    print("\n".join(faults) or f"{len(places)} types, each name in one place")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1] if len(sys.argv) > 1
                               else pathlib.Path(__file__).resolve().parents[1])))
