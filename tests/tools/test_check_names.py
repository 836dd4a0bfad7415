"""tools/check_names.py refuses a second type of a name, and only that."""

import unittest

from planted_tree import PlantedTree


def inside(space, text):
    return f"namespace {space} {{\n\n{text}\n\n}}  // namespace {space}\n"


KEPT = {
    "core/Tip.h": inside("asperity", "struct Tip {\n    double radius = 0.0;\n};"),
    "core/Uses.h": inside("asperity", "struct Tip;\nenum class Mode : std::uint8_t;"),
    "core/Mode.h": inside("asperity", "enum class Mode : std::uint8_t {\n    Contact,\n};"),
    "core/Hidden.cpp": inside("asperity", "namespace {\n\nclass Tip {};\n\n}  // namespace"),
    "core/Inner.h": inside("asperity", "class Lever {\n    struct Tip {};\n};"),
    "core/Other.h": inside("asperity::test", "class Tip final : public Base {\n};"),
    "core/Row.h": inside("asperity", "template <class Value>\nstruct Row {};\n\n"
                                     "template <>\nstruct Row<double> {};"),
}


class CheckNames(PlantedTree):
    tool = "check_names.py"
    kept = KEPT

    def test_a_tree_without_a_second_one_passes(self):
        run = self.run_with({})
        self.assertEqual(run.returncode, 0, run.stdout)

    def test_every_kind_of_type(self):
        for kind in ("struct Tip {", "class Tip {", "class Tip final {", "class Tip : public Base {",
                     "enum class Tip : std::uint8_t {", "union Tip {", "struct alignas(64) Tip {"):
            self.refuses({"ui/Planted.h": (inside("asperity", f"{kind}\n}};"),
                                           "asperity::Tip is defined in core/Tip.h:3, too")})

    def test_in_sources_and_nested_namespaces(self):
        self.refuses({"tests/Planted.cpp": (inside("asperity", inside("test", "class Tip {\n};")),
                                            "asperity::test::Tip is defined in")})


if __name__ == "__main__":
    unittest.main()
