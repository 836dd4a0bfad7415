#!/usr/bin/env python3
"""Fails on a citation, a link or a reference table that does not exist (docs/theory.md, top)."""

import functools
import pathlib
import re
import sys

TOP = pathlib.Path(__file__).resolve().parent.parent
TABLES = TOP / "tests/reference"

PLACES = ["core", "vtkplugins", "hardware", "ui", "app", "tests", "bench", "tools", "cmake", "docs",
          "README.md", "CONTRIBUTING.md", "CHANGELOG.md"]
TEXTS = {".h", ".cpp", ".cxx", ".py", ".md", ".txt", ".cmake", ".sh", ".in"}
SKIPPED = [TABLES, TOP / "tests/fuzz/corpus"]

# "docs/theory.md 2.9, 4.4", also where a comment breaks the line before the number
SECTION = r"\d+(?:\.\d+)*(?![\w%])"
CITATION = re.compile(r"(?<![\w./-])(?P<folder>(?:[\w.-]+/)*)(?P<page>[\w-]+\.md)\b"
                      r"(?:,?(?: +|\s+(?://+|#) *)"
                      rf"(?P<sections>{SECTION}(?:(?:, ?| and |[-–]){SECTION})*))?")
TABLE = re.compile(r"(?<!\w)T\d\d[a-z]?(?:_\w+)?(?:\.csv)?(?!\w)")

HEADING = re.compile(r"^#{1,6} +(.+?) *#*$", re.MULTILINE)
CODE = re.compile(r"^```.*?^```|^(?: {4}|\t)[^\n]*$|`[^`\n]+`", re.MULTILINE | re.DOTALL)
LINK = re.compile(r"\]\(\s*<?([^)\s>]+)[^)]*\)|^\[[^\]]+\]:\s*(\S+)", re.MULTILINE)


def blank(match):
    """Spaces in place of a text, so that places and line numbers stay."""
    return re.sub(r"[^\n]", " ", match.group())


@functools.lru_cache(maxsize=None)
def headings(page):
    text = re.sub(r"^```.*?^```", blank, page.read_text(), flags=re.MULTILINE | re.DOTALL)
    return HEADING.findall(text)


@functools.lru_cache(maxsize=None)
def sections(page):
    """The numbers of its sections: `## 2. …` and `### 2.9 …`."""
    found = (re.match(r"(\d+(?:\.\d+)*)\.?(?:\s|$)", heading) for heading in headings(page))
    return {match.group(1) for match in found if match}


@functools.lru_cache(maxsize=None)
def anchors(page):
    """The anchors that GitHub makes of its headings."""
    found = {}
    for heading in headings(page):
        words = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", heading)
        slug = re.sub(r"[^\w\- ]", "", words.lower()).replace(" ", "-")
        known = found.get(slug, -1) + 1
        found[slug] = known
        if known:
            found[f"{slug}-{known}"] = 0
    return set(found)


def citations(text):
    """Yields place and fault of each citation, the fault "" where page and sections exist."""
    for match in CITATION.finditer(text):
        folder, name, numbers = match.group("folder", "page", "sections")
        if "docs/" not in folder and not (numbers and folder == ""):
            continue  # a file's name, no citation
        page = (TOP / (folder or "docs/") / name).resolve()
        if TOP not in page.parents or not page.is_file():
            yield match.start(), f"{folder}{name} is no page of this repository"
            continue
        absent = [n for n in re.findall(SECTION, numbers or "") if n not in sections(page)]
        yield match.start(), f"{folder}{name} has no section {', '.join(absent)}" if absent else ""


def tables(text):
    """Yields place and fault of each reference table that is named."""
    for match in TABLE.finditer(text):
        name = match.group()
        known = any(TABLES.glob(name if name.endswith(".csv") else f"{name}*.csv"))
        yield match.start(), "" if known else f"tests/reference has no table {name}"


def links(file, text):
    """Yields place and fault of each relative link of a Markdown page."""
    for match in LINK.finditer(CODE.sub(blank, text)):
        target = match.group(1) or match.group(2)
        if re.match(r"\w+:", target):
            continue
        path, _, anchor = target.partition("#")
        page = (file.parent / path).resolve() if path else file
        if not page.exists():
            yield match.start(), f"link to {target}: no such file"
        elif anchor and page.suffix == ".md" and anchor not in anchors(page):
            yield match.start(), f"link to {target}: no such heading"
        else:
            yield match.start(), ""


def texts():
    for place in (TOP / name for name in PLACES):
        for file in sorted(place.rglob("*")) if place.is_dir() else [place]:
            if file.suffix in TEXTS and not any(skip in file.parents for skip in SKIPPED):
                yield file


def main():
    counts = {"citations": 0, "tables": 0, "links": 0}
    found = []
    for file in texts():
        text = file.read_text()
        checks = {"citations": citations(text), "tables": tables(text),
                  "links": links(file, text) if file.suffix == ".md" else ()}
        for kind, results in checks.items():
            for place, fault in results:
                counts[kind] += 1
                if fault:
                    line = text.count("\n", 0, place) + 1
                    found.append(f"{file.relative_to(TOP)}:{line}: {fault}")
    summary = ", ".join(f"{count} {kind}" for kind, count in counts.items())
    print("\n".join(found) if found else f"{summary}: all resolve")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
