#include "app/recording/RunComparison.h"
#include "tests/support/TestScenes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace asperity {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(RunDifferences, NamesWhatTheForceFollowsFrom) {
    const RunConditions first{.scene = test::plainScene(), .sha256 = "a"};
    RunConditions second = first;
    second.scene.sample.file = "elsewhere/" + first.scene.sample.file;  // the same scan
    second.scene.zoomHalfWidth = 7e-9;
    EXPECT_THAT(differencesOf(first, second), IsEmpty());
    second.scene.sample.material.elastic.youngsModulus = 70e9;
    second.scene.settings.positionGain *= 2.0;
    EXPECT_THAT(differencesOf(first, second),
                ElementsAre(testing::MatchesRegex("Material, Young's modulus: .* GPa → 70 GPa"),
                            testing::StartsWith("Gains, Position gain: ")));
}

TEST(RunDifferences, NamesBothScans) {
    const RunConditions first{.scene = test::plainScene(), .sha256 = "a"};
    RunConditions second{.scene = first.scene, .sha256 = "b"};
    second.scene.sample.file = "other.gsf";
    ASSERT_EQ(differencesOf(first, second).size(), 1U);
    EXPECT_THAT(differencesOf(first, second).front(), testing::StartsWith("Scan: "));
    EXPECT_THAT(differencesOf(first, second).front(), testing::HasSubstr("→ other.gsf"));
}

}  // namespace
}  // namespace asperity
