"""tools/check_citations.py finds what is planted into a small tree whose citations resolve."""

import unittest

from planted_tree import outcome

PAGE = "docs/theory.md"
KEPT = {
    PAGE: "# Theory\n\n## 2. Contact\n\n### 2.9 Folds\n\n    P = a^3        (2.1)\n",
    "docs/physics.md": "[folds](theory.md#29-folds), [theory](theory.md) 2.9, `theory.md` 2\n",
    "core/Law.h": f"// {PAGE} 2, 2.9 and 2, equation (2.1)\n// Source: {PAGE},\n//   section 2.9\n",
    "build/Law.h": f"// {PAGE} 99.9\n",
    "data/scan.gsf": f"\0{PAGE} 99.9\n",
}


class CheckCitations(unittest.TestCase):
    def refuses(self, planted, fault):
        """Each planted file has the fault in its first line, and nothing else is found."""
        run = outcome("check_citations.py", KEPT | planted)
        self.assertEqual((run.returncode, run.stderr), (1, ""), run.stdout)
        lines = run.stdout.splitlines()
        for name, text in planted.items():
            with self.subTest(text=text):
                self.assertTrue(any(line.startswith(f"{name}:1: ") and fault in line
                                    for line in lines), run.stdout)
        self.assertEqual(len(lines), len(planted), run.stdout)

    def test_a_tree_whose_citations_resolve_passes(self):
        run = outcome("check_citations.py", KEPT)
        self.assertEqual((run.returncode, run.stderr), (0, ""), run.stdout)
        self.assertIn("4 citations, 0 tables, 2 links", run.stdout)

    def test_every_place(self):
        names = ("core/new/X.inl", "examples/x.cpp", "examples/x.toml", ".github/template.md",
                 ".github/x.yml", ".ci/run", "data/materials/x.toml", "data/udev/x.rules",
                 "newtop/X.h", "README.md", "CMakePresets.json")
        self.refuses({name: f"# {PAGE} 99.9\n" for name in names}, "no section or equation 99.9")

    def test_every_wording(self):
        wordings = ("{} 99.9", "{} 2.9, 99.9", "{} 2.9,\n// 99.9", "{}\n// 99.9", "{} section 99.9",
                    "{}, sections 2.9 and 99.9", "{},\n// section 99.9", "{} chapter 99.9",
                    "{} §99.9", "{} (99.9)", "`{}` 99.9", "`{}`, section 99.9", "`{} 99.9`",
                    "`{}` (99.9)", "[theory]({}) 99.9", "{} 2.9, equation (99.9)", "{}, eq. (99.9)")
        for page in (PAGE, "theory.md", "../theory.md"):
            self.refuses({f"core/X{number}.h": f"// {wording.format(page)} .\n"
                          for number, wording in enumerate(wordings)},
                         "no section or equation 99.9")

    def test_a_page_a_table_and_a_link_that_are_not_there(self):
        self.refuses({"examples/x.cpp": "// `docs/{}.md`\n".format("nowhere")}, "is no page")
        self.refuses({"data/x.toml": f"# T{99}\n"}, "has no table")
        self.refuses({".github/x.md": "[x](nowhere.h)\n"}, "no such file")
        self.refuses({f"{PAGE[:5]}new.md": "[x](theory.md#nothing)\n"}, "no such heading")


if __name__ == "__main__":
    unittest.main()
