"""tools/check_words.py finds words of no AFM lab in texts, and nothing in keys and comments."""

import unittest

from planted_tree import PlantedTree


class CheckWords(PlantedTree):
    tool = "check_words.py"
    kept = {"ui/Panel.cpp": '#include "the hand/A foot.h"\n'
                            'add("foot_x_m", tr("Reset fault"));  // "the hand feels it"\n'}

    def test_keys_comments_and_plain_words_pass(self):
        run = self.run_with({})
        self.assertEqual(run.returncode, 0, run.stdout)

    def test_every_fault(self):
        texts = ("force at the hand", "a person at the device", "no foot found", "certified feet",
                 "models to reckon with", "the device feels nothing", "what leads the tip",
                 "it came to no rest", "comes to rest", "Take &back a fault", "as the scene says")
        self.refuses({f"core/X{number}.h": (f'\nconst char* words = "{text}";\n', "write ")
                      for number, text in enumerate(texts)})

    def test_every_folder(self):
        self.refuses({f"{folder}/X.cpp": ('tell("the hand moves");\n', "'the hand'")
                      for folder in ("app", "core", "hardware", "tools", "ui", "vtkplugins")})

    def test_sources_of_vtk(self):
        self.refuses({"vtkplugins/X.cxx": ('say("over the resting surface");\n', "'resting'")})


if __name__ == "__main__":
    unittest.main()
