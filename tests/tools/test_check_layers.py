"""tools/check_layers.py refuses what is planted into a small tree that keeps to the layers."""

import unittest

from planted_tree import PlantedTree

KEPT = {
    "core/Vector.h": "",
    "core/contact/laws/ContactLaw.h": '#include "core/Vector.h"\n',
    "core/haptics/HapticLoop.h": "",
    "core/scene/Scene.h": "#include <Eigen/Core>\n",
    "vtkplugins/module/Grid.cxx": '#include "vtkAsperityModule.h"\n#include <vtkPoints.h>\n',
    "ui/view/View.h": "",
    "app/program/Program.h": '#include "core/scene/Scene.h"\n',
    "app/window/lab/Features.h": '#include "app/program/Program.h"\n',
    "app/commands/Commands.h": '#include "app/window/lab/Features.h"\n',
    "app/main.cpp": '#include "app/commands/Commands.h"\n',
    "tests/core/scene/SceneTest.cpp": '#include "core/scene/Scene.h"\n',
    "build/out.cpp": '#include "nowhere.h"\n',
}
FEATURES = '#include "app/window/lab/Features.h"\n'


class CheckLayers(PlantedTree):
    tool = "check_layers.py"
    kept = KEPT

    def test_a_tree_that_keeps_to_the_layers_passes(self):
        run = self.run_with({})
        self.assertEqual(run.returncode, 0, run.stdout)

    def test_a_folder_without_a_rule(self):
        self.refuses({name: (FEATURES, "no rule names this folder") for name in (
            "newtop/Z.cpp", "Loose.cpp", "core/newroom/X.h", "core/contact/newroom/X.h",
            "hardware/newdrv/deep/Y.h", "ui/view/sub/Z.hpp",
            "app/window/map/newroom/Q.inl", "newroom/Q.inl", "tests/newroom/X.cpp",
            "tests/core/newroom/X.cc", "bench/newroom/X.c", "tools/newroom/X.cxx",
            "examples/newroom/X.cpp", "cmake/newroom/X.cpp")})

    def test_a_room_of_a_kind_has_the_arrows_of_its_kind(self):
        run = self.run_with({"app/window/newroom/Q.h": '#include "app/program/Program.h"\n'})
        self.assertEqual(run.returncode, 0, run.stdout)
        self.refuses({
            "app/window/newroom/R.h": (FEATURES, "app/window/newroom must not include app/window/lab"),
            "app/window/measure/R.h": ('#include "app/window/newroom/R.h"\n',
                                       "app/window/measure must not include app/window/newroom"),
            "core/io/heightmap/newformat/X.cpp": (
                '#include "core/scene/Scene.h"\n',
                "core/io/heightmap/newformat must not include core/scene")})

    def test_every_suffix_of_a_source(self):
        self.refuses({f"core/Planted.{suffix}": (FEATURES, "core must not include app/window/lab")
                      for suffix in ("h", "hpp", "inl", "c", "cc", "cpp", "cxx")})

    def test_an_include_against_the_arrows(self):
        arrows = (("core/contact/laws", "core/scene", "Scene.h"),
                  ("core/scene", "core/haptics", "HapticLoop.h"),
                  ("core/surface/fit", "core/scene", "Scene.h"),
                  ("hardware/hid", "ui/view", "View.h"),
                  ("ui/view", "app/window/lab", "Features.h"),
                  ("app/program", "app/window/lab", "Features.h"),
                  ("app/reports", "app/window/lab", "Features.h"),
                  ("app/recording", "app/window/lab", "Features.h"),
                  ("app/window/lab", "app/commands", "Commands.h"),
                  ("examples", "ui/view", "View.h"),
                  ("cmake", "core", "Vector.h"))
        self.refuses({f"{own}/Planted.h": (f'#include "{other}/{name}"\n',
                                           f"{own} must not include {other}")
                      for own, other, name in arrows})

    def test_an_include_that_hides_its_folder(self):
        targets = ('"../../../app/window/lab/Features.h"', '"core/../app/window/lab/Features.h"',
                   '"app//window/lab/Features.h"', '"./app/window/lab/Features.h"', '"Scene.h"',
                   '<app/window/lab/Features.h>', '<../app/window/lab/Features.h>',
                   '"app/window/lab/NoSuchFile.h"', '"newtop/Z.h"')
        self.refuses({f"core/scene/Planted{number}.h": (f"#include {target}\n", "no source")
                      for number, target in enumerate(targets)})
        self.refuses({"core/scene/Close.h": ('#include"app/window/lab/Features.h"\n',
                                             "core/scene must not include app/window/lab"),
                      "core/scene/Macro.h": ("#include HIDDEN\n", "must name its file"),
                      "core/scene/Import.h": ('#import "core/Vector.h"\n', "must name its file"),
                      "core/scene/Broken.h": ('#in\\\nclude "core/Vector.h"\n', "must name its file"),
                      "core/scene/Comment.h": ('/* */ #include "app/window/lab/Features.h"\n',
                                               "core/scene must not include app/window/lab"),
                      "core/scene/Digraph.h": ('%:include "app/window/lab/Features.h"\n',
                                               "core/scene must not include app/window/lab")})

    def test_a_header_of_others_outside_its_place(self):
        targets = ("vtkPoints.h", "QString", "QtWidgets/QWidget", "qstring.h", "qwt_plot.h",
                   "hidapi/hidapi.h", "tiffio.h", "CLI/CLI.hpp")
        self.refuses({f"core/scene/Planted{number}.h": (f"#include <{target}>\n", "belongs to")
                      for number, target in enumerate(targets)} |
                     {f"ui/view/Planted{number}.h": (f"#include <{target}>\n", "belongs to")
                      for number, target in enumerate(("thread", "fstream"))})

    def test_folders_that_include_each_other(self):
        run = self.run_with({"tests/app/A.h": '#include "tests/support/B.h"\n',
                             "tests/support/B.h": '#include "tests/app/A.h"\n'})
        self.assertEqual(run.returncode, 1)
        self.assertIn("in a circle: tests/app -> tests/support -> tests/app", run.stdout)


if __name__ == "__main__":
    unittest.main()
