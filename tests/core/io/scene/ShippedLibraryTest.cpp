#include "core/io/scene/ProbeFile.h"
#include "core/io/scene/SceneFile.h"
#include "core/io/scene/TomlFile.h"
#include "tests/support/Places.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace asperity {
namespace {

/// The files of a kind that come with the program.
std::vector<std::filesystem::path> shipped(const char* kind) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(test::dataFolder() / kind)) {
        files.push_back(entry.path());
    }
    return files;
}

bool statesItsSource(const std::filesystem::path& file) {
    return notesOf(file).find("Source:") != std::string::npos;
}

/// [N/m] "tapping_7_4_n_m.toml": 7.4
double stiffnessInName(const std::filesystem::path& file) {
    const std::string stem = file.stem().string();
    std::smatch found;
    if (!std::regex_search(stem, found, std::regex("_([0-9]+(_[0-9]+)?)_n_m$"))) {
        return 0.0;
    }
    std::string number = found[1].str();
    std::ranges::replace(number, '_', '.');
    return std::stod(number);
}

TEST(ShippedMaterials, AreTwelveOrMoreThatASceneAccepts) {
    std::set<std::string> names;
    for (const std::filesystem::path& file : shipped("materials")) {
        const SampleMaterial material = readMaterialFile(file);
        EXPECT_NO_THROW(checkScene(withMaterial(defaultScene(), material))) << file;
        EXPECT_GT(material.workOfAdhesion, 0.0) << file;
        EXPECT_TRUE(names.insert(material.name).second) << file << ": two of one name";
        EXPECT_TRUE(statesItsSource(file)) << file;
    }
    EXPECT_GE(names.size(), 12U);
}

TEST(ShippedProbes, AreTwelveOrMoreNamedByTheirStiffness) {
    const std::vector<std::filesystem::path> files = shipped("probes");
    EXPECT_GE(files.size(), 12U);
    for (const std::filesystem::path& file : files) {
        const double named = stiffnessInName(file);
        EXPECT_GT(named, 0.0) << file;
        EXPECT_NEAR(Cantilever(readProbe(file).lever).stiffness(), named, 0.02 * named) << file;
        EXPECT_TRUE(statesItsSource(file)) << file;
    }
}

}  // namespace
}  // namespace asperity
