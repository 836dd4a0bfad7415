#include "core/words/SceneWords.h"

#include "core/scene/Scene.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

std::vector<std::string> notesOf(SceneDescription description, const LevelingSteps& leveling) {
    description.sample.leveling = leveling;
    return surfaceNotes(buildScene(description, test::slopedMap(0.1)));
}

TEST(SceneWords, TellOfHeightsTipLawAndModel) {
    const std::vector<std::string> notes = notesOf(test::plainScene(), {});
    ASSERT_EQ(notes.size(), 3U);
    EXPECT_EQ(notes[0], "leveling: none, heights as the file gives them");
    EXPECT_EQ(notes[1].find("smoothing: none, as the scene states"), 0U) << notes[1];
    EXPECT_EQ(notes[2].find("imaging tip: "), 0U) << notes[2];
    const Scene scene = buildScene(test::plainScene(), test::slopedMap(0.1));
    const std::vector<std::string> ofForce = forceNotes(scene, {});
    ASSERT_EQ(ofForce.size(), 2U);
    EXPECT_EQ(ofForce[0].find("contact law: "), 0U) << ofForce[0];
    EXPECT_EQ(ofForce[1].find("model: "), 0U) << ofForce[1];
}

TEST(SceneWords, NameThePlaneThatWasRemoved) {
    EXPECT_EQ(notesOf(test::plainScene(), {LevelingStep::Rows})[0].find(
                  "leveling: the median of each row and the mean removed (medians spread by "),
              0U);
    EXPECT_EQ(notesOf(test::plainScene(), {LevelingStep::Plane})[0].find(
                  "leveling: plane with slopes +0.1 along x and "),
              0U);
}

TEST(SceneWords, TellOfAShapeInPlaceOfTheHeights) {
    SceneDescription description = test::plainScene();
    description.sample.shape = {.kind = ShapeKind::Sphere, .radius = 100e-9, .size = 110e-9};
    const std::vector<std::string> notes = surfaceNotes(buildScene(description));
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_EQ(notes[0], "the sample is an exact shape, drawn by 256 x 256 heights");
}

TEST(SceneWords, SayHowTheHardnessIsKnown) {
    const SampleMaterial oxide{.elastic = {.youngsModulus = 70e9}};
    EXPECT_EQ(hardnessText(oxide), "not stated: estimated as 3.5 GPa, a twentieth of Young's "
                                   "modulus (within a factor of 4)");
    EXPECT_EQ(hardnessText({.hardness = 9e9}), "9 GPa");
    EXPECT_EQ(hardnessText({.elastic = {.youngsModulus = 1e6}}),
              "not known: onset of yield is not looked for");
    EXPECT_EQ(hardnessText({.yields = false}), "none: the sample does not yield");
    SceneDescription description = test::plainScene();
    description.sample.material.hardness = 0.0;
    const auto notes = forceNotes(buildScene(description, test::slopedMap(0.1)), {});
    EXPECT_EQ(notes.back().find("hardness: not stated: estimated as "), 0U) << notes.back();
}

TEST(SceneWords, SayByWhatAScanIsSmoothed) {
    Scene scene = buildScene(test::plainScene(), test::slopedMap(0.1));
    scene.heightNoise = 30e-12;
    EXPECT_EQ(smoothingNote(scene), "smoothing: none, as the scene states; 30 pm of height noise");
    scene.curvatureNoise = 1.0 / scene.description.tip.radius;
    EXPECT_EQ(smoothingNote(scene),
              "smoothing: none, as the scene states; 30 pm of height noise; the tip touches the "
              "highest of noisy points first: pull-off and stiffness are too low; on surfaces "
              "blunter than the tip by more than the stated deviations");
    scene.description.sample.smoothingPixels = 1.0;
    EXPECT_NE(smoothingNote(scene).find("too low"), std::string::npos) << "too little";
    scene.curvatureNoise = 0.09 / scene.description.tip.radius;
    EXPECT_EQ(smoothingNote(scene),
              "smoothing: 1 pixel, as the scene states; 30 pm of height noise");
    scene.curvatureNoise = 0.0;
    scene.description.sample.smoothingPixels = 0.0;
    scene.smoothing = SmoothingChoice{.pixels = 1.2};
    EXPECT_EQ(smoothingNote(scene),
              "smoothing: 1.2 pixels, by 30 pm of height noise and a 15 nm tip");
    scene.smoothing = SmoothingChoice{.pixels = 1.0, .isBounded = true};
    EXPECT_EQ(smoothingNote(scene),
              "smoothing: 1 pixel, by 30 pm of height noise and a 15 nm tip; more would take away "
              "the surface's own curvature");
    scene.smoothing = SmoothingChoice{};
    EXPECT_EQ(smoothingNote(scene), "smoothing: none is needed, by 30 pm of height noise "
                                    "and a 15 nm tip");
    scene.smoothing.reset();
    scene.description.sample.smoothingLength = 2e-9;
    EXPECT_EQ(smoothingNote(scene), "smoothing: 2 nm, as the scene states; 30 pm of height noise");
}

TEST(SceneWords, SayWherePixelsAreCoarseForTheTip) {
    Scene scene = buildScene(test::plainScene(), test::flatMap());
    const std::size_t fine = surfaceNotes(scene).size();
    scene.description.tip.radius = 2.9 * scene.surface.grid().pitchX;
    const std::vector<std::string> notes = surfaceNotes(scene);
    ASSERT_EQ(notes.size(), fine + 1);
    EXPECT_TRUE(notes.back().starts_with("pixels: ")) << notes.back();
}

TEST(SceneWords, NameTheSample) {
    SampleDescription sample;
    sample.file = "/scans/ps.gwy";
    sample.channel = "Height";
    EXPECT_EQ(sampleName(sample), "ps.gwy, channel Height");
    sample.shape = {.kind = ShapeKind::Cylinder, .radius = 100e-9};
    EXPECT_EQ(sampleName(sample), "cylinder of radius 100 nm");
    sample.shape = {.kind = ShapeKind::Plane, .slope = 0.5};
    EXPECT_EQ(sampleName(sample), "plane of slope 500 mrad");
}

}  // namespace
}  // namespace asperity
