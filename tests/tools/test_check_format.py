"""tools/check_format.sh where clang-format is not installed."""

import pathlib
import shutil
import subprocess
import tempfile
import unittest

from planted_tree import TOOLS


class CheckFormat(unittest.TestCase):
    def exit_code(self, **environment):
        """Of a run that finds these few programs, and no clang-format."""
        with tempfile.TemporaryDirectory() as programs:
            for name in ("bash", "dirname", "env"):
                pathlib.Path(programs, name).symlink_to(shutil.which(name))
            run = subprocess.run([TOOLS / "check_format.sh"], env={"PATH": programs} | environment,
                                 capture_output=True, text=True)
        self.assertIn("clang-format is missing", run.stdout, run.stderr)
        return run.returncode

    def test_is_skipped_by_those_who_only_test(self):
        self.assertEqual(self.exit_code(), 77)

    def test_fails_in_a_run_of_the_gates(self):
        self.assertEqual(self.exit_code(ASPERITY_GATES="1"), 1)


if __name__ == "__main__":
    unittest.main()
