#include "app/reports/run/RunSections.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace asperity {
namespace {

TickSample tickWith(const std::vector<Validity>& flags, Fault fault = Fault::None) {
    TickSample sample;
    sample.output.model.contact.branch = ContactBranch::Bonded;
    sample.output.fault = fault;
    for (const Validity flag : flags) {
        sample.output.flags.set(flag, true);
    }
    return sample;
}

/// A run in which the model snaps into contact, and then these ticks.
RunVerdict verdictOf(const std::vector<TickSample>& ticks) {
    RunHistory history;
    TickSample free;
    free.output.model.contact.branch = ContactBranch::Far;
    history.take(free);
    for (const TickSample& tick : ticks) {
        history.take(tick);
    }
    return verdictOn(history);
}

bool holds(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

TEST(RunVerdict, HoldsWithoutFlags) {
    const RunVerdict verdict = verdictOf({tickWith({}), tickWith({Validity::SnapInAhead})});
    EXPECT_EQ(verdict.brief, "holds");
    EXPECT_EQ(verdict.tone, PageTone::Plain);
    EXPECT_FALSE(verdict.hasReasons);
}

TEST(RunVerdict, IsThatOfTheWorstFlag) {
    const RunVerdict doubt = verdictOf({tickWith({Validity::Anisotropic, Validity::LargeContact}),
                                        tickWith({Validity::Anisotropic})});
    EXPECT_TRUE(holds(doubt.sentence, "in 1 of 3 ticks")) << doubt.sentence;
    EXPECT_EQ(doubt.tone, PageTone::Caution);
    const RunVerdict invalid =
        verdictOf({tickWith({Validity::LargeContact}), tickWith({Validity::LargeContact}),
                   tickWith({Validity::OutsideScan})});
    EXPECT_TRUE(holds(invalid.sentence, "in 1 of 4 ticks")) << invalid.sentence;
    EXPECT_EQ(invalid.tone, PageTone::Fault);
    EXPECT_TRUE(doubt.hasReasons && invalid.hasReasons);
}

TEST(RunVerdict, LeavesOutFlagsOfNoisySignals) {
    EXPECT_EQ(verdictOf({tickWith({Validity::ModelContradicted})}).brief, "holds");
}

TEST(RunVerdict, NamesTheFault) {
    const RunVerdict verdict =
        verdictOf({tickWith({Validity::OutsideScan}), tickWith({}, Fault::DeviceLost)});
    EXPECT_EQ(verdict.brief, "fault: forces off");
    EXPECT_TRUE(holds(verdict.sentence, "device not connected")) << verdict.sentence;
    EXPECT_TRUE(holds(verdict.sentence, "in 1 of 3 ticks")) << verdict.sentence;
}

TEST(RunVerdict, OfARunWithoutContactIsNone) {
    RunHistory history;
    TickSample free;
    free.output.model.contact.branch = ContactBranch::Far;
    history.take(free);
    EXPECT_EQ(verdictOn(history).brief, "no contact");
}

}  // namespace
}  // namespace asperity
