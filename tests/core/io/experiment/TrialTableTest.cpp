#include "core/Error.h"
#include "core/io/experiment/StudyFile.h"
#include "tests/core/experiment/SmallStudy.h"
#include "tests/support/Refusal.h"
#include "tests/support/ScratchFolder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace asperity::test {
namespace {

using testing::HasSubstr;

TrialRecord someTrial() {
    TrialRecord trial;
    trial.plan = planTrials(smallStudy(), 2, 9).at(20);
    trial.plan.attempt = 3;
    trial.start = {1e-7 / 3.0, 2e-7, 6e-8};
    trial.target = {1e-7, 1.0 / 3.0, -2e-9};
    trial.error = 1e-10 / 7.0;
    trial.errorPercent = 100.0 / 3.0;
    trial.time = 9.123;
    trial.largestForce = 5e-9;
    trial.handleMotion = 3e-5;
    trial.timedOut = true;
    trial.fault = Fault::VelocityTrip;
    trial.struckOut = "the phone, \"rang\"";
    trial.scale = {.positionGain = 1e-6, .forceGain = 1e8 / 3.0};
    trial.coupling = {.stiffness = 600.0, .damping = 2.3, .proxyDamping = 3.0};
    return trial;
}

class TrialTable : public testing::Test {
protected:
    void SetUp() override { writeTrials(file, study, std::vector{someTrial(), someTrial()}); }

    std::string refusal(const std::string& before, const std::string& after) {
        std::string text = contentOf(file);
        text.replace(text.find(before), before.size(), after);
        return refusalOf([&] { (void)readTrials(scratch.write("other.csv", text), study); });
    }

    ScratchFolder scratch;
    std::filesystem::path file = scratch.file("trials.csv");
    Study study = smallStudy();
};

TEST_F(TrialTable, ReadsWhatWasWrittenToTheBit) {
    const std::vector<TrialRecord> trials = readTrials(file, study);
    ASSERT_EQ(trials.size(), 2U);
    EXPECT_EQ(trials[0].plan, someTrial().plan);
    const std::string before = contentOf(file);
    writeTrials(file, study, trials);
    EXPECT_EQ(contentOf(file), before);
}

TEST_F(TrialTable, RefusesRowsOfAnotherStudy) {
    const std::string material = study.materials[someTrial().plan.material].name;
    EXPECT_THAT(refusal("," + material + ",", ",gold,"), HasSubstr("material is 'gold'"));
    EXPECT_THAT(refusal("velocity_trip", "hiccup"), HasSubstr("fault is 'hiccup'"));
    EXPECT_THAT(refusal(",stiff,", ",soft,"), HasSubstr("lever is 'soft'"));
    EXPECT_THAT(refusal("\n21,3,", "\n-1,3,"), HasSubstr("trial is '-1'"));
}

TEST_F(TrialTable, MomentsReadBackToTheBit) {
    TrialMoment moment{
        .time = 1.0 / 3.0, .tip = {1e-9 / 3.0, 2e-9, 3e-9}, .shown = {4.0, 5.0, 6.0}};
    moment.device = {1e-3, 2e-3, 3e-3};
    moment.force = {1e-9, -2e-9 / 3.0, 3e-9};
    moment.deviceForce = {0.1, 0.2, 0.3};
    moment.largestForce = 4e-9;
    writeMoments(scratch.file("t.csv"), std::vector{moment});
    const std::vector<TrialMoment> read = readMoments(scratch.file("t.csv"));
    ASSERT_EQ(read.size(), 1U);
    EXPECT_EQ(read[0].tip, moment.tip);
    EXPECT_EQ(read[0].force, moment.force);
    EXPECT_EQ(read[0].deviceForce, moment.deviceForce);
    EXPECT_EQ(read[0].largestForce, moment.largestForce);
    EXPECT_EQ(read[0].time, moment.time);
}

}  // namespace
}  // namespace asperity::test
