#!/usr/bin/env python3
"""Puts the figures of `asperity bench --json ROWS.json` into the table of docs/performance.md.
Usage: performance_table.py ROWS.json [PAGE]"""

import json
import pathlib
import sys

BEGIN = "<!-- table: tools/performance_table.py -->"
END = "<!-- end of the table -->"


def figure(value, unit):
    """Three digits, without a power of ten where people read none."""
    text = f"{value:.3g}" if abs(value) < 1000 and (value == 0 or abs(value) >= 0.01) else (
        f"{value:,.0f}" if abs(value) >= 1000 else f"{value:.1e}")
    return f"{text} {unit}".rstrip()


def line(row):
    relation = "≥" if row["goal_is"] == "at_least" else "≤"
    goal = f"{relation} {figure(row['goal'], row['unit'])}"
    if row["value"] is None:
        return f"| {row['name']} | not installed | {goal} | |"
    return (f"| {row['name']} | {figure(row['value'], row['unit'])} | {goal} "
            f"| {'yes' if row['met'] else 'no'} |")


def table(rows):
    return "\n".join(["| figure | measured | goal | met |", "|---|---|---|---|",
                      *[line(row) for row in rows]])


def with_table(page, rows):
    before, rest = page.split(BEGIN)
    after = rest.split(END)[1]
    return f"{before}{BEGIN}\n\n{table(rows)}\n\n{END}{after}"


def names_in(page):
    """The figures of the table that the page has."""
    lines = page.split(BEGIN)[1].split(END)[0].strip().splitlines()[2:]
    return [line.split("|")[1].strip() for line in lines]


def rows_of(path):
    try:
        return json.loads(pathlib.Path(path).read_text())["rows"]
    except (OSError, ValueError, KeyError) as problem:
        sys.exit(f"{path}: no rows of asperity bench --json ({problem})")


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    rows = rows_of(sys.argv[1])
    top = pathlib.Path(__file__).resolve().parent.parent
    page = pathlib.Path(sys.argv[2]) if len(sys.argv) == 3 else top / "docs" / "performance.md"
    text = page.read_text()
    missing = sorted(set(names_in(text)) - {row["name"] for row in rows})
    if missing:
        sys.exit(f"{sys.argv[1]}: {len(missing)} figures of {page.name} are missing, such as "
                 f"'{missing[0]}': the table is that of one whole run, not --quick")
    page.write_text(with_table(text, rows))


if __name__ == "__main__":
    main()
