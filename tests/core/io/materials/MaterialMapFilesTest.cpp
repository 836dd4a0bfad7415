#include "core/io/materials/MaterialMapFiles.h"

#include "tests/support/Refusal.h"
#include "tests/support/ScratchFolder.h"
#include "tests/support/TestScenes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

namespace asperity {
namespace {

using testing::HasSubstr;

/// A Gwyddion Simple Field of 2 rows.
std::string gsf(const std::vector<float>& values, const std::string& unit, double sizeX = 40e-9,
                double sizeY = 20e-9) {
    const std::size_t columns = values.size() / 2;
    std::string text = "Gwyddion Simple Field 1.0\nXRes = " + std::to_string(columns) +
                       "\nYRes = 2\nXReal = " + std::to_string(sizeX * 1e9) +
                       "e-9\nYReal = " + std::to_string(sizeY * 1e9) +
                       "e-9\nXYUnits = m\nTitle = M\n";
    text += unit.empty() ? "" : "ZUnits = " + unit + "\n";
    text.append(4 - text.size() % 4, '\0');
    text.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float));
    return text;
}

class MaterialMapFiles : public testing::Test {
protected:
    /// A scan of 4 x 2 pixels of 10 nm.
    static constexpr MapArea kScan{
        .columns = 4, .rows = 2, .pitchX = 10e-9, .pitchY = 10e-9, .part = {0, 0, 4, 2}};

    SceneDescription modulusFrom(const std::string& content) {
        SceneDescription scene = test::plainScene();
        scene.sample.material.maps.youngsModulus = MapSource{
            .file = scratch.write("map.gsf", content).string(), .channel = "", .sha256 = ""};
        scene.truth.material = scene.sample.material;
        return scene;
    }
    std::string refusal(SceneDescription scene, const MapArea& area = kScan) {
        return test::refusalOf([&] { (void)readSceneMaps(scene, area); });
    }

    test::ScratchFolder scratch;
};

TEST_F(MaterialMapFiles, CoverTheScanWithAnyPixelsAndAreReadOnceForBothSides) {
    SceneDescription scene = modulusFrom(gsf({1e9F, 3e9F, 1e9F, 3e9F}, "Pa"));
    const SceneMaps maps = readSceneMaps(scene, kScan);
    ASSERT_NE(maps.sample.youngsModulus, nullptr);
    EXPECT_EQ(maps.sample.youngsModulus, maps.truth.youngsModulus);
    EXPECT_NEAR(maps.sample.youngsModulus->at(20e-9, 10e-9), 2e9, 1.0);
    EXPECT_EQ(scene.sample.material.maps.youngsModulus->sha256.size(), 64U);
    EXPECT_EQ(scene.sample.material.maps.youngsModulus->channel, "M");
    EXPECT_EQ(scene.truth.material, scene.sample.material);
}

TEST_F(MaterialMapFiles, OfAPartAreCroppedWithIt) {
    SceneDescription scene =
        modulusFrom(gsf({1e9F, 2e9F, 3e9F, 4e9F, 5e9F, 6e9F, 7e9F, 8e9F}, "Pa"));
    MapArea part = kScan;
    part.part = {1, 0, 2, 1};
    const SceneMaps maps = readSceneMaps(scene, part);
    EXPECT_EQ(maps.sample.youngsModulus->columns(), 2);
    EXPECT_EQ(maps.sample.youngsModulus->at(0.0, 0.0), 2e9);
    EXPECT_EQ(maps.sample.youngsModulus->at(20e-9, 0.0), 3e9);
    SceneDescription coarse = modulusFrom(gsf({1e9F, 2e9F, 3e9F, 4e9F}, "Pa"));
    EXPECT_THAT(refusal(coarse, part), HasSubstr("the scan's 4 x 2 pixels"));
}

/// A part of 99 % was taken for the scan, and the map stretched.
TEST_F(MaterialMapFiles, OfAPartThatIsHardlySmallerAreCroppedToo) {
    std::vector<float> values(800);
    for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] = 1e9F + 1e6F * static_cast<float>(i % 400);
    }
    SceneDescription scene = modulusFrom(gsf(values, "Pa", 400e-9, 2e-9));
    const MapArea area{
        .columns = 400, .rows = 2, .pitchX = 1e-9, .pitchY = 1e-9, .part = {2, 0, 398, 2}};
    const auto map = readSceneMaps(scene, area).sample.youngsModulus;
    EXPECT_EQ(map->columns(), 398);
    EXPECT_NEAR(map->at(0.5e-9, 1e-9), 1.002e9, 1e3);
}

TEST_F(MaterialMapFiles, AMaskIsScaledByAllOfItWhateverItsUnit) {
    SceneDescription scene = test::plainScene();
    const std::vector<float> bytes{100.0F, 100.0F, 100.0F, 200.0F, 100.0F, 100.0F, 100.0F, 100.0F};
    scene.sample.material.maps.mask = MaterialMask{
        .source = {.file = scratch.write("mask.gsf", gsf(bytes, "nm")).string(),
                   .channel = "",
                   .sha256 = ""},
        .zero = {.youngsModulus = 1e9, .workOfAdhesion = 0.0, .frictionCoefficient = 0.0},
        .one = {.youngsModulus = 5e9, .workOfAdhesion = 0.0, .frictionCoefficient = 0.0}};
    MapArea part = kScan;
    part.part = {0, 0, 2, 2};
    EXPECT_NEAR(readSceneMaps(scene, part).sample.youngsModulus->highest(), 3e9, 1e3);
}

TEST_F(MaterialMapFiles, StiffnessIsNoAdhesionUnlessItIsNamed) {
    SceneDescription scene = test::plainScene();
    scene.sample.material.maps.workOfAdhesion =
        MapSource{.file = scratch.write("k.gsf", gsf({0.1F, 0.2F, 0.1F, 0.2F}, "N/m")).string(),
                  .channel = "",
                  .sha256 = ""};
    EXPECT_THAT(refusal(scene), HasSubstr("work of adhesion [J/m^2]"));
    scene.sample.material.maps.workOfAdhesion->channel = "M";
    EXPECT_NEAR(readSceneMaps(scene, kScan).sample.workOfAdhesion->highest(), 0.2, 1e-8);
}

TEST_F(MaterialMapFiles, HaveUnitsWithPrefixes) {
    SceneDescription scene = modulusFrom(gsf({1.0F, 3.0F, 1.0F, 3.0F}, "GPa"));
    EXPECT_NEAR(readSceneMaps(scene, kScan).sample.youngsModulus->highest(), 3e9, 1e3);
    SceneDescription adhesive = test::plainScene();
    adhesive.sample.material.maps.workOfAdhesion = MapSource{
        .file = scratch.write("w.gsf", gsf({50.0F, 70.0F, 50.0F, 70.0F}, "mJ/m^2")).string(),
        .channel = "M",
        .sha256 = ""};
    const SceneMaps maps = readSceneMaps(adhesive, kScan);
    EXPECT_NEAR(maps.sample.workOfAdhesion->lowest(), 0.05, 1e-8);
    EXPECT_EQ(maps.truth.workOfAdhesion, nullptr) << "the truth names none here";
}

TEST_F(MaterialMapFiles, PixelsWithoutDataGetABlendOfTheirSurroundings) {
    const float none = std::numeric_limits<float>::quiet_NaN();
    SceneDescription scene = modulusFrom(gsf({1e9F, none, 2e9F, 1e9F, none, 2e9F}, "Pa"));
    const auto map = readSceneMaps(scene, kScan).sample.youngsModulus;
    EXPECT_GT(map->at(20e-9, 5e-9), 1e9);
    std::vector<std::string> notes;
    (void)readSceneMaps(scene, kScan, nullptr, &notes);
    ASSERT_EQ(notes.size(), 1U) << "both sides have the same map";
    EXPECT_THAT(notes[0], HasSubstr("2 of 6 pixels of 'M' hold no data"));
    EXPECT_LT(map->at(20e-9, 5e-9), 2e9);
    EXPECT_THAT(refusal(modulusFrom(gsf({none, none, none, none}, "Pa"))),
                HasSubstr("no pixel has any"));
}

TEST_F(MaterialMapFiles, AMaskMixesTwoMaterials) {
    SceneDescription scene = test::plainScene();
    scene.sample.material.maps.mask = MaterialMask{
        .source = {.file = scratch.write("mask.gsf", gsf({0.0F, 1.0F, 0.0F, 1.0F}, "")).string(),
                   .channel = "",
                   .sha256 = ""},
        .zero = {.youngsModulus = 1e9, .workOfAdhesion = 0.02, .frictionCoefficient = 0.1},
        .one = {.youngsModulus = 5e9, .workOfAdhesion = 0.04, .frictionCoefficient = 0.5}};
    const MaterialMaps maps = readSceneMaps(scene, kScan).sample;
    EXPECT_EQ(maps.youngsModulus->at(0.0, 0.0), 1e9);
    EXPECT_EQ(maps.youngsModulus->at(40e-9, 0.0), 5e9);
    EXPECT_NEAR(maps.workOfAdhesion->at(20e-9, 5e-9), 0.03, 1e-9);
    EXPECT_NEAR(maps.friction->at(20e-9, 5e-9), 0.3, 1e-7);
}

TEST_F(MaterialMapFiles, RefuseWhatIsNoMapOfTheScan) {
    const std::vector<float> good{1e9F, 3e9F, 1e9F, 3e9F};
    EXPECT_THAT(refusal(modulusFrom(gsf(good, "m"))), HasSubstr("expected a channel of a modulus"));
    EXPECT_THAT(refusal(modulusFrom(gsf(good, "Pa", 50e-9))), HasSubstr("the size of the scan"));
    EXPECT_THAT(refusal(modulusFrom(gsf({1e9F, -3e9F, 1e9F, 3e9F}, "Pa"))),
                HasSubstr("row 0, column 1: -3e+09 is not a modulus"));
    SceneDescription named = modulusFrom(gsf(good, "Pa"));
    named.sample.material.maps.youngsModulus->channel = "E";
    EXPECT_THAT(refusal(named), HasSubstr("named 'E'; the file has 'M' (Pa)"));
    SceneDescription changed = modulusFrom(gsf(good, "Pa"));
    changed.sample.material.maps.youngsModulus->sha256 = std::string(64, '0');
    EXPECT_THAT(refusal(changed), HasSubstr("has changed since"));
}

}  // namespace
}  // namespace asperity
