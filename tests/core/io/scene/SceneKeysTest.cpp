#include "core/io/scene/SceneFile.h"
#include "core/scene/SceneFields.h"
#include "tests/support/Places.h"
#include "tests/support/Refusal.h"
#include "tests/support/ScratchFolder.h"

#include <gtest/gtest.h>

#include <regex>
#include <set>
#include <string>

namespace asperity {
namespace {

/// All words in the sources of the readers that can be a key.
std::set<std::string> candidates() {
    const std::filesystem::path source = test::checkout();
    std::string text = test::contentOf(source / "core/scene/ModelTerm.h") +
                       test::contentOf(source / "core/scene/Uncertainty.h");
    for (const auto& file : std::filesystem::directory_iterator(source / "core/io/scene")) {
        text += test::contentOf(file.path());
    }
    std::set<std::string> words;
    const std::regex quoted("\"([a-z][a-z0-9_]*)\"");
    for (std::sregex_iterator word(text.begin(), text.end(), quoted), end; word != end; ++word) {
        words.insert((*word)[1]);
    }
    return words;
}

/// Whether readScene() takes a key in a section, whatever else of the sample it says.
bool isRead(const test::ScratchFolder& folder, const std::string& section, const std::string& key) {
    for (const char* sample : {"file = \"a.gsf\"", "shape = \"sphere\"", "shape = \"plane\""}) {
        const std::string own = key + " = {}\n";
        const std::string text = std::string("[sample]\n") + sample + "\n" +
                                 (section == "sample" ? own : "[" + section + "]\n" + own);
        const std::string said =
            test::refusalOf([&] { (void)readScene(folder.write("probe.toml", text)); });
        EXPECT_NE(said, "") << section << "." << key << " is no table";
        if (said.find("unknown key '" + key + "'") == std::string::npos) {
            return true;
        }
    }
    return false;
}

/// A key that the reader knows and the panel does not could be changed in a file only.
TEST(SceneKeys, ThoseThatTheReaderReadsAreThoseOfTheList) {
    const test::ScratchFolder folder;
    std::set<std::string> read;
    for (const char* section : {"sample", "tip", "probe", "truth", "physics", "fidelity",
                                "uncertainty", "approach", "view"}) {
        for (const std::string& key : candidates()) {
            if (isRead(folder, section, key)) {
                read.insert(std::string(section) + "." + key);
            }
        }
    }
    // Libraries, what names two materials, and a name that another key had.
    std::set<std::string> listed{"sample.material",     "truth.material",
                                 "probe.file",          "sample.material_mask",
                                 "truth.material_mask", "probe.normal_deviation_rad"};
    for (const SceneField& field : sceneFields()) {
        listed.insert(nameOf(field));
    }
    EXPECT_EQ(read, listed);
    EXPECT_GT(read.size(), 60U);
}

}  // namespace
}  // namespace asperity
