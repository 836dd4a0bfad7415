"""tools/check_words.py finds words of no AFM lab in texts and keys, and nothing in comments."""

import unittest

from planted_tree import PlantedTree


class CheckWords(PlantedTree):
    tool = "check_words.py"
    kept = {"ui/Panel.cpp": '#include "the hand/A foot.h"\n'
                            'add("closest_x_m", tr("Reset fault"));  // "the hand feels it"\n'
                            'add("handle_x_m", "footprint_m", "taken by hand");\n',
            "core/Quote.h": """char a = '"', b = 'x'; // "hand" \n""",
            "core/io/FormerKeys.h": 'row{"foot_x_m", "closest_x_m"}, {"hand_x_m", "device_x_m"};\n'}

    def test_former_keys_comments_and_plain_words_pass(self):
        run = self.run_with({})
        self.assertEqual(run.returncode, 0, run.stdout)

    def test_every_fault(self):
        texts = ("force at the hand", "three places", "begins anew", "a person at the device",
                 "no foot found", "certified feet", "models to reckon with",
                 "the device feels nothing", "what leads the tip", "it came to no rest",
                 "comes to rest", "Take &back a fault", "as the scene says")
        self.refuses({f"core/X{number}.h": (f'\nconst char* words = "{text}";\n', "write ")
                      for number, text in enumerate(texts)})

    def test_keys_and_single_words(self):
        keys = ("foot_x_m", "several_feet", "feet", "foot3_valid", "hand_fx_n", "max_hand_speed_m_s",
                "in_hand", "hand", "handForce", "\\nhand", "felt_n_m", "-foot", "tables with foot_x_m,foot_y_m")
        self.refuses({f"core/X{number}.h": (f'\nadd("{key}");\n', "write ")
                      for number, key in enumerate(keys)})

    def test_a_quote_as_a_character_hides_nothing(self):
        self.refuses({"core/X.h": ("char a = '\"'; auto b = \"hand\";\n", "'hand'")})

    def test_former_keys_stand_in_one_file(self):
        self.refuses({"app/FormerKeys.h": ('row{"foot_x_m", "closest_x_m"};\n', "'foot'")})

    def test_every_folder(self):
        self.refuses({f"{folder}/X.cpp": ('tell("the hand moves");\n', "'hand'")
                      for folder in ("app", "bench", "core", "examples", "hardware", "tools", "ui",
                                     "vtkplugins")})

    def test_sources_of_vtk(self):
        self.refuses({"vtkplugins/X.cxx": ('say("over the resting surface");\n', "'resting'")})


if __name__ == "__main__":
    unittest.main()
