#include "core/io/scene/SceneKeys.h"

#include "core/io/TextValue.h"
#include "core/io/scene/SceneFile.h"
#include "core/scene/SceneFields.h"
#include "tests/support/Places.h"
#include "tests/support/Refusal.h"
#include "tests/support/ScratchFolder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <regex>
#include <set>
#include <string>

namespace asperity {
namespace {

/// All words in the sources of the readers that can be a key, and the keys of the list.
std::set<std::string> candidates() {
    const std::filesystem::path source = test::checkout();
    std::string text;
    for (const auto& file : std::filesystem::directory_iterator(source / "core/io/scene")) {
        text += test::contentOf(file.path());
    }
    std::set<std::string> words;
    const std::regex quoted("\"([a-z][a-z0-9_]*)\"");
    for (std::sregex_iterator word(text.begin(), text.end(), quoted), end; word != end; ++word) {
        words.insert((*word)[1]);
    }
    for (const SceneField& field : sceneFields()) {
        words.insert(field.key);
    }
    return words;
}

/// Returns whether readScene() accepts a key in a section, whatever else of the sample it says.
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

/// The scene after one key of a section.
SceneDescription sceneAfter(const SceneField& field, const std::string& value) {
    const std::string section = keyOf(field.group);
    const toml::table table = toml::parse("[" + section + "]\n" + field.key + " = " + value);
    TomlSection keys(table, "key.toml", section);
    SceneDescription scene = defaultScene();
    readKey(keys, field, scene);
    return scene;
}

/// File and page disagreed on at least eight of them.
TEST(SceneKeys, HaveTheLimitsOfTheList) {
    for (const SceneField& field : sceneFields()) {
        if (field.input != SceneInput::Number || field.ownForm ||
            field.group == SceneGroup::Shape) {
            continue;
        }
        for (const double end : {field.limits.low, field.limits.high}) {
            const SceneDescription scene = sceneAfter(field, exactText(end));
            EXPECT_NEAR(std::get<double>(field.get(scene)), end, 1e-15 * std::abs(end))
                << nameOf(field);
        }
        if (field.limits.orZero) {
            EXPECT_EQ(std::get<double>(field.get(sceneAfter(field, "0"))), 0.0) << nameOf(field);
        }
        const double beyond = field.limits.high + std::abs(field.limits.high);
        const std::string said =
            test::refusalOf([&] { (void)sceneAfter(field, exactText(beyond)); });
        EXPECT_NE(said.find(std::string("line 2, [") + keyOf(field.group) + "] " + field.key +
                            ": must " + field.limits.words),
                  std::string::npos)
            << nameOf(field) << ": " << said;
        EXPECT_NE(test::refusalOf([&] { (void)sceneAfter(field, "nan"); }), "") << nameOf(field);
    }
}

/// Each key that a file states comes back with its bits, whatever the value.
TEST(SceneKeys, KeepTheirBitsInAFile) {
    for (const SceneField& field : sceneFields()) {
        if (field.input != SceneInput::Number || field.ownForm ||
            field.group == SceneGroup::Shape) {
            continue;
        }
        SceneDescription scene = defaultScene();
        scene.truth.curve = "curve.csv";  // its stiffness is stated beside one
        field.set(scene, 0.3 * field.limits.high);
        toml::table table;
        insertKey(field, scene, table);
        const double* const stated = table[field.key].as_floating_point() != nullptr
                                         ? &table[field.key].as_floating_point()->get()
                                         : nullptr;
        ASSERT_NE(stated, nullptr) << nameOf(field);
        EXPECT_EQ(*stated, 0.3 * field.limits.high) << nameOf(field);
    }
}

TEST(SceneKeys, SayWhyOneMeansNothing) {
    const test::ScratchFolder folder;
    const auto file =
        folder.write("plane.toml", "[sample]\nshape = \"plane\"\nshape_radius_m = 1e-7\n");
    EXPECT_EQ(test::refusalOf([&] { (void)readScene(file); }),
              file.string() + ": line 3, [sample] shape_radius_m: A plane has no radius");
}

}  // namespace
}  // namespace asperity
