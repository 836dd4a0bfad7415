#!/usr/bin/env python3
"""Fails on words in texts and keys of the program that an AFM lab does not use (CONTRIBUTING.md, Code).
Usage: check_words.py [TREE]"""

import pathlib
import re
import sys

TOP = pathlib.Path(sys.argv[1] if sys.argv[1:] else pathlib.Path(__file__).parents[1]).resolve()
FOLDERS = ("app", "bench", "core", "examples", "hardware", "tools", "ui", "vtkplugins")
INSTEAD = {
    r"(?<!by )hands?|persons?": "device, or operator",
    r"places": "points, positions",
    r"anew|likewise|meanwhile": "again, also",
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
KEY_OF_A_DEVICE = re.compile(r"(?<![a-z])hand_|_hand(?![a-z])")
FORMER_KEYS = "core/io/FormerKeys.h"  # the only list of keys that earlier files have
LITERAL = re.compile(r"'(?:[^'\\\n]|\\.)'|" r'"((?:[^"\\\n]|\\.)*)"|//[^\n]*|^#include[^\n]*', re.MULTILINE)


def texts(source):
    """Line and text of each literal: sentences, single words and keys of files."""
    for match in LITERAL.finditer(source):
        text = (match.group(1) or "").replace("&", "")
        yield source.count("\n", 0, match.start()) + 1, text


def faults_in(text):
    """Each fault, and what to write instead; the parts of a key (foot0_x_m) are words, too."""
    words = re.sub(r"[_\d]+|\\[nt]|(?<=[a-z])(?=[A-Z])", " ", text)
    for fault, instead in FAULTS.items():
        for word in fault.finditer(words):
            yield word.group(), instead
    for key in KEY_OF_A_DEVICE.finditer(text):
        yield key.group(), "device"


def main():
    files = [file for folder in FOLDERS for file in sorted((TOP / folder).rglob("*"))
             if file.suffix in (".cpp", ".cxx", ".h") and file != TOP / FORMER_KEYS]
    found = [f"{file.relative_to(TOP)}:{line}: '{word}' in \"{text}\": write {instead}"
             for file in files for line, text in texts(file.read_text())
             for word, instead in faults_in(text)]
    print("\n".join(found) if found else f"{len(files)} files use the words of an AFM lab")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
