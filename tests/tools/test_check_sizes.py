"""tools/check_sizes.py refuses files of a bad size and functions that are too long, and only those."""

import unittest

from planted_tree import PlantedTree


def of(lines):
    return "// a line\n" * lines


def function(lines, head="void act(int value) {"):
    return of(25) + f"{head}\n" + "    step();\n" * lines + "}\n"


class CheckSizes(PlantedTree):
    tool = "check_sizes.py"
    kept = {
        "core/Usual.cpp": of(25),
        "core/Largest.h": of(600),
        "core/Long.cpp": function(60),
        "core/Many.h": of(25) + "int count(int of);\n" * 40,
        "core/Table.cpp": of(25) + "const Row kRows[] = {\n" + "    {f(1)},\n" * 80 + "};\n",
        "core/Wide.h": of(25) + "class Wide : public Base {\n" + "    int f() const { return 0; }\n" * 80 + "};\n",
        "tests/core/Small.cpp": of(3),
    }

    def test_a_tree_of_good_sizes_passes(self):
        run = self.run_with({})
        self.assertEqual(run.returncode, 0, run.stdout)

    def test_files(self):
        self.refuses({"core/Small.h": (of(24), "24 lines, fewer than 25"),
                      "ui/view/Large.cpp": (of(601), "601 lines, more than 600"),
                      "app/Full.h": (of(25) + "int count(int of);\n" * 41, "41 functions, more than 40")})

    def test_functions(self):
        heads = ("void act(int value) {", "Tip::Tip(double radius)\n    : radius_(radius)\n    , gap_(0.0) {",
                 "template <class Value>\nValue read(const Text& text) {", "bool Tip::isOpen() const noexcept {")
        for head in heads:
            begin = 26 + head.count("\n")
            self.refuses({"vtkplugins/module/Grid.cxx": (function(61, head), "a function of 61 lines")})
            run = self.run_with({"core/Tip.cpp": function(61, head)})
            self.assertIn(f"core/Tip.cpp:{begin}: ", run.stdout)
        inner = "class Tip {\npublic:\n    void act() {\n" + "        step();\n" * 61 + "    }\n};\n"
        self.refuses({"core/Inner.h": (of(25) + inner, "a function of 61 lines")})

    def test_braces_in_texts_and_comments(self):
        text = of(25) + 'void act() {\n    say("{{{"); // {{\n    say(R"({ {)");\n    mark(\'{\');\n}\n'
        run = self.run_with({"core/Texts.cpp": text + function(10, "void next() {")})
        self.assertEqual(run.returncode, 0, run.stdout)


if __name__ == "__main__":
    unittest.main()
