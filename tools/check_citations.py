#!/usr/bin/env python3
"""Fails on a citation, a link or a reference table that does not exist (docs/theory.md, top).
Usage: check_citations.py [TREE]"""

import functools
import pathlib
import re
import sys

TOP = pathlib.Path(sys.argv[1] if sys.argv[1:] else pathlib.Path(__file__).parents[1]).resolve()
TABLES = TOP / "tests/reference"
# what git ignores (.gitignore), and what is read by tests alone
SKIPPED = re.compile(r"(\.git|build|out|\.cache|tests/reference|tests/fuzz/corpus)(/|$)")

# "docs/theory.md 2.9, 4.4", "`theory.md`, section 2.9", "(docs/theory.md) (2.9)", "theory.md 3.4,
# equation (3.3)", also where a comment breaks the line
NEXT = r"(?: +|\s+(?://+|#) *)"
NUMBER = r"\d+(?:\.\d+)*(?![\w%])"
NUMBERS = rf"{NUMBER}(?:(?:,{NEXT}?|{NEXT}and{NEXT}|[-–]){NUMBER})*"
CITATION = re.compile(r"(?<![\w./-])(?P<folder>(?:[\w.-]+/)*)(?P<page>[\w-]+\.md)\b"
                      r"(?:#[\w-]+)?[`)]*"
                      rf"(?:,?{NEXT}(?P<sections>{NUMBERS})"
                      r"|,?\s+(?:(?://+|#) *)?(?:[Ss]ections?|[Cc]hapters?|[Ss]ec\.|§+)"
                      rf"(?:{NEXT}|\s*)(?P<worded>{NUMBERS})"
                      rf"|,?{NEXT}\((?P<either>{NUMBERS})\))?"
                      rf"(?:,?{NEXT}eq(?:uations?|s?\.){NEXT}\((?P<equations>{NUMBERS})\))?")
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
def equations(page):
    """The numbers at the right margin of its formulas."""
    return set(re.findall(r"\((\d+\.\d+)\) *$", page.read_text(), re.MULTILINE))


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


def absent_numbers(page, match):
    """What a citation names and its page does not have."""
    known = {"sections": sections(page), "worded": sections(page), "equations": equations(page),
             "either": sections(page) | equations(page)}
    return [number for group, numbers in known.items()
            for number in re.findall(NUMBER, match.group(group) or "") if number not in numbers]


def citations(text):
    """Yields place and fault of each citation, the fault "" where page and numbers exist."""
    for match in CITATION.finditer(text):
        name = match.group("page")
        folder = re.sub(r"^(\.\.?/)+", "", match.group("folder"))
        numbered = any(match.group("sections", "worded", "either", "equations"))
        if "docs/" not in folder and not (numbered and folder == ""):
            continue  # a file's name, no citation
        page = (TOP / (folder or "docs/") / name).resolve()
        if TOP not in page.parents or not page.is_file():
            yield match.start(), f"{folder}{name} is no page of this repository"
            continue
        absent = ", ".join(absent_numbers(page, match))
        yield match.start(), f"{folder}{name} has no section or equation {absent}" if absent else ""


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
    """File and text of each file of the tree that holds text."""
    for file in sorted(TOP.rglob("*")):
        if SKIPPED.match(file.relative_to(TOP).as_posix()) or not file.is_file():
            continue
        text = file.read_bytes()
        if b"\0" not in text:
            yield file, text.decode(errors="replace")


def main():
    counts = {"citations": 0, "tables": 0, "links": 0}
    found = []
    for file, text in texts():
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
    return 1 if found or not any(counts.values()) else 0


if __name__ == "__main__":
    sys.exit(main())
