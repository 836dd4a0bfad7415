"""tools/performance_table.py writes the figures of `asperity bench --json` into a page."""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

TOOL = pathlib.Path(__file__).resolve().parents[2] / "tools" / "performance_table.py"
PAGE = """# Speed

<!-- table: tools/performance_table.py -->
| old |
<!-- end of the table -->

after
"""
ROWS = [
    {"name": "fast", "value": 4.5678, "unit": "x", "goal": 3, "goal_is": "at_least", "met": True},
    {"name": "error", "value": 2.5e-12, "unit": "", "goal": 1e-11, "goal_is": "at_most",
     "met": True},
    {"name": "slow", "value": 16432.1, "unit": "x", "goal": 20000, "goal_is": "at_least",
     "met": False},
    {"name": "alone", "value": None, "unit": "x", "goal": 2, "goal_is": "at_least", "met": None},
]


class PerformanceTable(unittest.TestCase):
    def test_puts_each_row_between_the_marks_and_keeps_the_rest(self):
        with tempfile.TemporaryDirectory() as folder:
            rows = pathlib.Path(folder, "rows.json")
            page = pathlib.Path(folder, "page.md")
            rows.write_text(json.dumps({"rows": ROWS}))
            page.write_text(PAGE)
            for _ in range(2):  # again: in place of the first
                subprocess.run([sys.executable, TOOL, rows, page], check=True)
            lines = page.read_text().splitlines()
        self.assertEqual(lines[0], "# Speed")
        self.assertEqual(lines[-1], "after")
        self.assertEqual([line for line in lines if line.startswith("|")], [
            "| figure | measured | goal | met |", "|---|---|---|---|",
            "| fast | 4.57 x | ≥ 3 x | yes |",
            "| error | 2.5e-12 | ≤ 1.0e-11 | yes |",
            "| slow | 16,432 x | ≥ 20,000 x | no |",
            "| alone | not installed | ≥ 2 x | |"])

    def test_refuses_rows_of_a_part_and_leaves_the_page(self):
        with tempfile.TemporaryDirectory() as folder:
            rows = pathlib.Path(folder, "rows.json")
            page = pathlib.Path(folder, "page.md")
            rows.write_text(json.dumps({"rows": ROWS}))
            page.write_text(PAGE)
            subprocess.run([sys.executable, TOOL, rows, page], check=True)
            before = page.read_text()
            for part in (json.dumps({"rows": ROWS[:1]}), "no json", "{}"):
                rows.write_text(part)
                done = subprocess.run([sys.executable, TOOL, rows, page], capture_output=True,
                                      text=True, check=False)
                self.assertEqual(done.returncode, 1)
                self.assertIn("rows.json", done.stderr)
                self.assertNotIn("Traceback", done.stderr)
                self.assertEqual(page.read_text(), before)


if __name__ == "__main__":
    unittest.main()
