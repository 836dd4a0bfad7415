#!/usr/bin/env python3
"""Fails on words in texts of the program that an AFM lab does not use (CONTRIBUTING.md, Code).
Usage: check_words.py [TREE]"""

import pathlib
import re
import sys

TOP = pathlib.Path(sys.argv[1] if sys.argv[1:] else pathlib.Path(__file__).parents[1]).resolve()
FOLDERS = ("app", "core", "hardware", "tools", "ui", "vtkplugins")
INSTEAD = {
    r"(the|a|your|and) hands?|hand(?= and device)|persons?": "device, or operator",
    r"foot|feet": "closest point, contact point",
    r"reckon\w*": "compute, model",
    r"felt|feels?": "force on the device",
    r"leads? the tip|led": "drives, controls",
    r"(comes?|came) to (no )?rest": "settles, did not converge",
    r"takes? back": "reset",
    r"resting": "undeformed",
    r"scene says|law says|file says?": "as in the scene",
    r"rough word|none cheaper|no other beats": "approximate, Pareto-optimal",
}
FAULTS = {re.compile(rf"\b({words})\b", re.IGNORECASE): instead
          for words, instead in INSTEAD.items()}
LITERAL = re.compile(r'"((?:[^"\\\n]|\\.)*)"|//[^\n]*|^#include[^\n]*', re.MULTILINE)


def texts(source):
    """Line and text of each literal of more than one word; a single one may be a key of a file."""
    for match in LITERAL.finditer(source):
        text = (match.group(1) or "").replace("&", "")
        if " " in text.strip():
            yield source.count("\n", 0, match.start()) + 1, text


def main():
    files = [file for folder in FOLDERS for file in sorted((TOP / folder).rglob("*"))
             if file.suffix in (".cpp", ".cxx", ".h")]
    found = [f"{file.relative_to(TOP)}:{line}: '{word.group()}' in \"{text}\": write {instead}"
             for file in files for line, text in texts(file.read_text())
             for fault, instead in FAULTS.items() for word in fault.finditer(text)]
    print("\n".join(found) if found else f"{len(files)} files use the words of an AFM lab")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
