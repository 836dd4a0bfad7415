#include "core/io/experiment/StudyFile.h"

#include "core/Error.h"
#include "core/experiment/TrialPlan.h"
#include "tests/core/experiment/SmallStudy.h"
#include "tests/support/Places.h"
#include "tests/support/Refusal.h"
#include "tests/support/ScratchFolder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace asperity::test {
namespace {

using testing::HasSubstr;

const std::filesystem::path kShipped = test::dataFolder() / "studies" / "positioning.toml";

class StudyFile : public testing::Test {
protected:
    /// What a study file is refused by that says this, and else what the small study does.
    std::string refusal(const std::string& before, const std::string& after) {
        writeStudy(smallStudy(), scratch.path());
        std::string text = contentOf(scratch.file("study.toml"));
        const std::size_t offset = text.find(before);
        EXPECT_NE(offset, std::string::npos) << before << " in " << text;
        text.replace(offset, before.size(), after);
        return refusalOf([&] { (void)readStudy(scratch.write("study.toml", text)); });
    }

    ScratchFolder scratch;
};

TEST_F(StudyFile, ReadsWhatWasWritten) {
    Study study = smallStudy();
    study.aids = {
        .coupling = false, .forces = false, .deformation = false, .guide = FixtureKind::Line};
    study.materials[0].name = "../odd / name";
    study.training = 12.5;
    writeStudy(study, scratch.path());
    EXPECT_EQ(readStudy(scratch.file("study.toml")), study);
}

TEST_F(StudyFile, ShippedStudyIsThatOfThePaper) {
    const Study study = readStudy(kShipped);
    EXPECT_EQ(planTrials(study, 6, 1).size(), 144U);
    EXPECT_EQ(study.materials.size(), 3U);
    EXPECT_EQ(study.scene.tip.radius, 15e-9);
    EXPECT_EQ(study.tasks.at(2).materials, (std::vector<std::size_t>{1, 2}));
}

TEST_F(StudyFile, RefusesUnknownKeysAndMistakesByName) {
    EXPECT_THAT(refusal("repeats = 2", "repeat = 2"), HasSubstr("repeat"));
    EXPECT_THAT(refusal("repeats = 2", "repeats = -2"), HasSubstr("repeats"));
    EXPECT_THAT(refusal("repeats = 2", "repeats = 1000"), HasSubstr("repeats"));
    EXPECT_THAT(refusal("guide = 'none'", "guide = 'sphere'"), HasSubstr("guide"));
    EXPECT_THAT(refusal("task = 'A'", "task = 'D'"), HasSubstr("task"));
    EXPECT_THAT(
        refusal("materials = [ 'polystyrene', 'silicone_rubber' ]", "materials = [ 'gold' ]"),
        HasSubstr("materials"));
    EXPECT_THAT(refusal("file = 'material_1.toml'", "file = 'material_2.toml'"),
                HasSubstr("another name than polystyrene"));
    EXPECT_THAT(refusal("file = 'lever_1.toml'", "file = 'none.toml'"), HasSubstr("none.toml"));
    EXPECT_THAT(refusal("scene = 'scene.toml'", ""), HasSubstr("scene"));
    EXPECT_THAT(refusal("time_limit_s = 60.0", "time_limit_s = nan"), HasSubstr("time_limit_s"));
}

}  // namespace
}  // namespace asperity::test
