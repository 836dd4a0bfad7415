"""tools/check_citations.py finds what is planted into a small tree whose citations resolve."""

import unittest

from planted_tree import PlantedTree

PAGE = "docs/theory.md"
ABSENT = "no section or equation 99.9"
KEPT = {
    PAGE: "# Theory\n\n## 2. Contact\n\n### 2.9 Folds\n\n    P = a^3        (2.1)\n",
    "docs/physics.md": "[folds](theory.md#29-folds), [theory](theory.md) 2.9, `theory.md` 2\n",
    "core/Law.h": f"// {PAGE} 2, 2.9 and 2, equation (2.1)\n// Source: {PAGE},\n//   section 2.9\n",
    "build/Law.h": f"// {PAGE} 99.9\n",
    "data/scan.gsf": f"\0{PAGE} 99.9\n",
}


class CheckCitations(PlantedTree):
    tool = "check_citations.py"
    kept = KEPT

    def test_a_tree_whose_citations_resolve_passes(self):
        run = self.run_with({})
        self.assertEqual(run.returncode, 0, run.stdout)
        self.assertIn("4 citations, 0 tables, 2 links", run.stdout)

    def test_every_place(self):
        names = ("core/new/X.inl", "examples/x.cpp", "examples/x.toml", ".github/template.md",
                 ".github/x.yml", ".ci/run", "data/materials/x.toml", "data/udev/x.rules",
                 "newtop/X.h", "README.md", "CMakePresets.json")
        self.refuses({name: (f"# {PAGE} 99.9\n", ABSENT) for name in names})

    def test_every_wording(self):
        wordings = ("{} 99.9", "{} 2.9, 99.9", "{} 2.9,\n// 99.9", "{}\n// 99.9", "{} section 99.9",
                    "{}, sections 2.9 and 99.9", "{},\n// section 99.9", "{} chapter 99.9",
                    "{} §99.9", "{} (99.9)", "`{}` 99.9", "`{}`, section 99.9", "`{} 99.9`",
                    "`{}` (99.9)", "[theory]({}) 99.9", "{} 2.9, equation (99.9)", "{}, eq. (99.9)")
        for page in (PAGE, "theory.md", "../theory.md"):
            self.refuses({f"core/X{number}.h": (f"// {wording.format(page)} .\n", ABSENT)
                          for number, wording in enumerate(wordings)})

    def test_a_page_a_table_and_a_link_that_are_not_there(self):
        self.refuses({"examples/x.cpp": ("// `docs/{}.md`\n".format("nowhere"), "is no page"),
                      "data/x.toml": (f"# T{99}\n", "has no table"),
                      ".github/x.md": ("[x](nowhere.h)\n", "no such file"),
                      f"{PAGE[:5]}new.md": ("[x](theory.md#nothing)\n", "no such heading")})


if __name__ == "__main__":
    unittest.main()
