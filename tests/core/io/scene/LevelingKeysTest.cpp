#include "core/Error.h"
#include "core/io/scene/SceneFile.h"
#include "tests/support/Refusal.h"
#include "tests/support/ScratchFolder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace asperity {
namespace {

using testing::HasSubstr;
using testing::Not;

class LevelingKeys : public testing::Test {
protected:
    SceneDescription read(const std::string& keys) {
        return readScene(scratch.write("scene.toml", "[sample]\nfile = \"map.gsf\"\n" + keys));
    }
    std::string refusal(const std::string& keys) {
        return test::refusalOf([&] { (void)read(keys); });
    }
    LevelingSteps steps(const std::string& keys) { return read(keys).sample.leveling; }

    test::ScratchFolder scratch;
};

TEST_F(LevelingKeys, OneStepIsAText) {
    EXPECT_EQ(steps(""), LevelingSteps{LevelingStep::Plane});
    EXPECT_EQ(steps("level = \"rows\"\n"), LevelingSteps{LevelingStep::Rows});
    EXPECT_EQ(steps("level = \"none\"\n"), LevelingSteps());
}

TEST_F(LevelingKeys, SeveralStepsAreAListInOrder) {
    EXPECT_EQ(steps("level = [\"median_of_differences\", \"plane\", \"scars\"]\n"),
              (LevelingSteps{LevelingStep::MedianOfDifferences, LevelingStep::Plane,
                             LevelingStep::Scars}));
    EXPECT_EQ(steps("level = [\"zero\"]\n"), LevelingSteps{LevelingStep::Zero});
    EXPECT_EQ(steps("level = [\"none\"]\n"), LevelingSteps());
    EXPECT_EQ(steps("level = []\n"), LevelingSteps());
}

TEST_F(LevelingKeys, RefusesWhatIsNoStepWithItsLine) {
    EXPECT_THAT(refusal("level = \"plane,zero\"\n"),
                HasSubstr("line 3, [sample] level: expected steps of plane, rows"));
    EXPECT_THAT(refusal("level = [\"plane\", \"flat\"]\n"), HasSubstr("or none, not 'flat'"));
    EXPECT_THAT(refusal("level = [\"plane\", \"none\"]\n"), HasSubstr("'none' alone"));
    EXPECT_THAT(refusal("level = [\"plane\", 1]\n"), HasSubstr("list of such texts"));
    EXPECT_THAT(refusal("level = 1\n"), HasSubstr("a text in quotes, or a list of such texts"));
}

TEST_F(LevelingKeys, ThreePointNeedsThreePointsOffOneLine) {
    const SceneDescription scene =
        read("level = \"three_point\"\nlevel_points_m = [[0, 1e-6], [2e-6, 0.5e-6], [1e-6, 0]]\n");
    ASSERT_TRUE(scene.sample.levelPoints);
    EXPECT_EQ((*scene.sample.levelPoints)[1], Vector2(2e-6, 0.5e-6));
    EXPECT_THAT(refusal("level = \"three_point\"\n"), HasSubstr("needs level_points_m"));
    EXPECT_THAT(refusal("level_points_m = [[0, 0], [1, 1]]\n"), HasSubstr("three points"));
    EXPECT_THAT(refusal("level_points_m = [[0, 0], [1, 1], [2, 2]]\n"),
                HasSubstr("do not lie on one line"));
    EXPECT_THAT(refusal("level_points_m = [[0, 0], [1, nan], [2, 0]]\n"), HasSubstr("finite"));
    EXPECT_THAT(refusal("level_points_m = [[0, 0], [1], [2, 0]]\n"), HasSubstr("written [x, y]"));
    EXPECT_THAT(refusal("level_points_m = [0, 0, 1, 0, 2, 1]\n"), HasSubstr("written [x, y]"));
    EXPECT_THAT(refusal("level_points_m = \"here\"\n"), HasSubstr("written [x, y]"));
}

/// As recordings keep it: the text of a scene reads back to the scene.
TEST_F(LevelingKeys, TextReadsBackAndOneStepIsWrittenAsEarlierVersionsRead) {
    SceneDescription scene = read("");
    const auto readBack = [this, &scene] {
        return readScene(scratch.write("back.toml", sceneText(scene))).sample;
    };
    EXPECT_THAT(sceneText(scene), HasSubstr("level = 'plane'"));
    scene.sample.leveling = {};
    EXPECT_THAT(sceneText(scene), HasSubstr("level = 'none'"));
    EXPECT_EQ(readBack().leveling, LevelingSteps());
    scene.sample.leveling = {LevelingStep::Facet, LevelingStep::ThreePoint, LevelingStep::Facet};
    scene.sample.levelPoints =
        LevelPoints{Vector2(1.0 / 3.0, 0.0), Vector2(0.1, 0.7), Vector2(0.2, 0.3)};
    EXPECT_EQ(readBack().leveling, scene.sample.leveling);
    EXPECT_EQ(readBack().levelPoints, scene.sample.levelPoints);
}

}  // namespace
}  // namespace asperity
