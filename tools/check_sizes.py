#!/usr/bin/env python3
"""Fails on a product source of too few or too many lines, on a header of too many functions and on a function that
is too long (CONTRIBUTING.md, Code). Small files that stand alone for a reason are listed here with it.
Usage: check_sizes.py [TREE]"""

import pathlib
import re
import sys

TOP = pathlib.Path(sys.argv[1] if sys.argv[1:] else pathlib.Path(__file__).parents[1]).resolve()
FOLDERS = ("app", "core", "hardware", "ui", "vtkplugins")
SUFFIXES = (".h", ".cpp", ".cxx")
LINES = range(25, 601)  # of a file; the fewest, of a header and its source together
FUNCTIONS = 40  # of a header, without private ones and those of one line
BODY = 60  # lines of a function
ALONE = {  # files that are small for a reason
    "core/SmoothStep.h": "governor, guide and pilot share it, which share nothing else",
    "core/Vector.h": "everything includes it",
    "core/Version.h": "only what names the version is compiled again with a new one",
    "core/contact/Within.h": "laws, tables and tips share it; nothing else of theirs is needed for it",
    "core/io/heightmap/Gwyddion.h": "what its readers import of the program Gwyddion, without the program",
    "core/probe/AfmController.h": "the interface of an instrument",
    "core/surface/LeastSquares.cpp": "Eigen's decomposition takes the compiler six seconds wherever it stands",
    "core/surface/LeastSquares.h": "the same",
    "core/surface/Provenance.h": "readers and reports share it",
    "core/surface/closest/Box.h": "searches, surfaces and rays share it",
    "ui/widgets/InputHelp.h": "widgets that share nothing else show it",
    "vtkplugins/paraview/module/AlgorithmProgress.h": "its filters share it",
}
HIDDEN = re.compile(r'R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])\'|//[^\n]*|^ *#[^\n]*|/\*.*?\*/',
                    re.DOTALL | re.MULTILINE)
SCOPE = re.compile(r"\b(namespace|class|struct|union|extern)\b[^()=]*(\([^()]*\)[^()=]*)?$")
DECLARED = re.compile(r"\)\s*(const)?\s*(noexcept)?\s*(override|final)?\s*(= \w+)?\s*$")


def functions_of(text):
    """Line and length of each function of a namespace or a class, and whether it is private. 0 long: it is only
    declared; -1: it is defined in one line, as an accessor."""
    code = HIDDEN.sub(lambda match: re.sub(r"[^\n]", " ", match[0]), text)
    inside, head = [], 0  # what each open brace begins: a function (its line), something else, or a scope (its access)
    for match in re.finditer(r"[{};]|\b(?:private|protected|public|Q_SIGNALS):", code):
        if match[0][-1] == ":":
            if inside:
                inside[-1] = match[0]
            continue
        before, head = re.sub(r"^ *template <.*>$", "", code[head:match.start()], flags=re.MULTILINE), match.end()
        line = code.count("\n", 0, match.start()) + 1
        is_outside = all(isinstance(kind, str) for kind in inside)
        if match[0] == "{":
            kind = "scope" if SCOPE.search(before) else None
            if kind is None and is_outside and ")" in before and not before.rstrip().endswith("="):
                kind = line
            inside.append(kind)
        elif match[0] == ";" and is_outside and DECLARED.search(before):
            yield line, 0, "private:" in inside
        elif match[0] == "}" and inside:
            kind = inside.pop()
            if isinstance(kind, int):
                yield kind, line - kind - 1, "private:" in inside


def faults_of(file, name):
    """What is wrong with a source, a sentence each."""
    text = file.read_text()
    lines = text.count("\n")
    if lines > LINES[-1]:
        yield f"{name}: {lines} lines, more than {LINES[-1]}: divide it"
    pair = sum(other.read_text().count("\n") for suffix in SUFFIXES
               if (other := file.with_suffix(suffix)).is_file())
    if pair < LINES[0] and name not in ALONE:
        yield f"{name}: {lines} lines, fewer than {LINES[0]}: put it with what it is read with"
    functions = list(functions_of(text))
    for begin, length, _ in functions:
        if length > BODY:
            yield f"{name}:{begin}: a function of {length} lines, more than {BODY}: divide it"
    count = sum(length >= 0 and not is_private for _, length, is_private in functions)
    if file.suffix == ".h" and count > FUNCTIONS:
        yield f"{name}: {count} functions, more than {FUNCTIONS}: divide it"


def main():
    files = [file for folder in FOLDERS for file in sorted((TOP / folder).rglob("*"))
             if file.suffix in SUFFIXES]
    found = [fault for file in files for fault in faults_of(file, str(file.relative_to(TOP)))]
    print("\n".join(found) if found else f"{len(files)} files and their functions are of a good size")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
