
#include "core/Error.h"
#include "core/io/scene/ProbeFile.h"
#include "core/io/scene/SceneFile.h"
#include "tests/support/Places.h"
#include "tests/support/ScratchFolder.h"

#include <gtest/gtest.h>

#include <string>

namespace asperity {
namespace {

class SceneSaving : public ::testing::Test {
protected:
    SceneDescription savedAndRead(const SceneDescription& scene,
                                  const std::filesystem::path& file) {
        saveScene(scene, file);
        return readScene(file);
    }

    test::ScratchFolder scratch;
};

TEST_F(SceneSaving, EveryShippedSceneIsReadBackEqual) {
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(test::dataFolder() / "scenes")) {
        const SceneDescription scene = readScene(entry.path());
        EXPECT_EQ(savedAndRead(scene, scratch.file("again.toml")), scene) << entry.path();
        ++count;
    }
    EXPECT_GE(count, 6);
}

TEST_F(SceneSaving, SoIsOneWithAllThatAUserCanChange) {
    SceneDescription scene = defaultScene();
    scene.sample.file = scratch.file("map.gsf");
    scene.sample.channel = "Höhe";
    scene.sample.scale = {.sizeX = 5e-6, .sizeY = 2e-6, .heightPerValue = 1e-9};
    scene.sample.leveling = {LevelingStep::Plane, LevelingStep::Zero};
    scene.sample.smoothingPixels = 0.0;
    scene.sample.smoothingLength = 3e-9;
    scene.sample.material.name = "mine (edited)";
    scene.sample.material.source = "a book";
    scene.probeSource = "curve 3 of µ.jpk-force";
    scene.truth.temperature = 296.0;
    scene.truth.curve = scratch.file("curve.csv");
    scene.truth.curveStiffness = 0.4;
    scene.detector.invOls = 62e-9;
    scene.choices.friction = false;
    scene.markers.push_back({.name = "grain", .x = 1e-7, .y = 1.0 / 3e7});
    EXPECT_EQ(savedAndRead(scene, scratch.file("mine.toml")), scene);
    scene.sample.smoothingLength = 0.0;
    for (const std::optional<double> pixels : {std::optional(1.2), std::optional<double>()}) {
        scene.sample.smoothingPixels = pixels;
        EXPECT_EQ(savedAndRead(scene, scratch.file("mine.toml")), scene);
    }
}

TEST_F(SceneSaving, NamesTheScanByItsWayFromTheScene) {
    SceneDescription scene = defaultScene();
    std::filesystem::create_directories(scratch.path() / "scans");
    std::filesystem::create_directories(scratch.path() / "scenes");
    scene.sample.file = scratch.path() / "scans" / "map.gsf";
    scene.truth.curve = scratch.path() / "scans" / "curve.csv";
    const std::filesystem::path file = scratch.path() / "scenes" / "mine.toml";
    EXPECT_EQ(savedAndRead(scene, file).sample.file, scene.sample.file);
    EXPECT_NE(test::contentOf(file).find("'../scans/map.gsf'"), std::string::npos)
        << test::contentOf(file);
    EXPECT_EQ(readScene(file).truth.curve, scene.truth.curve);
    EXPECT_NE(test::contentOf(file).find("'../scans/curve.csv'"), std::string::npos);
    std::filesystem::rename(scratch.path() / "scans", scratch.path() / "moved");
    scene.sample.file = "/nowhere/else/map.gsf";
    EXPECT_EQ(savedAndRead(scene, file).sample.file, scene.sample.file) << "as it is";
}

TEST_F(SceneSaving, AFileThatCannotBeWrittenIsRefused) {
    EXPECT_THROW(saveScene(defaultScene(), scratch.path() / "none" / "mine.toml"), FileError);
}

TEST_F(SceneSaving, MaterialsAndProbesAreReadBackEqualWithTheirNotes) {
    SampleMaterial material = defaultScene().sample.material;
    material.name = "mine";
    material.filmThickness = 1e-8;
    const std::string notes = "Measured in May.\nOn glass.";
    const std::filesystem::path file = scratch.write("mine.toml", materialText(material, notes));
    EXPECT_EQ(readMaterialFile(file), material);
    EXPECT_EQ(notesOf(file), notes);
    ProbeDescription probe{defaultScene().probe, {.invOls = 62e-9}};
    const ProbeDescription again = readProbe(scratch.write("probe.toml", probeText(probe, "")));
    EXPECT_EQ(again.lever, probe.lever);
    EXPECT_EQ(again.detector, probe.detector);
}

}  // namespace
}  // namespace asperity
