#include "core/haptics/RunEvents.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

TickSample sampleOf(double time, ContactBranch branch, double indentation, double force) {
    TickSample sample;
    sample.time = time;
    sample.output.model.contact.branch = branch;
    sample.output.model.contact.indentation = indentation;
    sample.output.model.contact.force = force;
    sample.output.model.force = Vector3(0.0, 0.0, force);
    return sample;
}

TEST(RunEvents, KeepsFirstSnapInLastPullOffAndExtremes) {
    RunEventRecorder recorder;
    recorder.take(sampleOf(0.0, ContactBranch::Far, -2.0, -0.1));
    recorder.take(sampleOf(1.0, ContactBranch::Bonded, 0.5, -3.0));
    recorder.take(sampleOf(2.0, ContactBranch::Bonded, 1.5, 8.0));
    recorder.take(sampleOf(3.0, ContactBranch::Bonded, -0.5, -5.0));
    recorder.take(sampleOf(4.0, ContactBranch::Far, -3.0, 0.0));
    const RunEvents& events = recorder.events();
    EXPECT_EQ(events.ticks, 5);
    EXPECT_EQ(events.beforeSnapIn->time, 0.0);
    EXPECT_EQ(events.snapIn->time, 1.0);
    EXPECT_EQ(events.deepest->time, 2.0);
    EXPECT_EQ(events.strongestPull->time, 3.0);
    EXPECT_EQ(events.beforePullOff->time, 3.0);
    EXPECT_EQ(events.pullOff->time, 4.0);
    EXPECT_EQ(events.largestForce, 8.0);
}

TEST(RunEvents, ARunWithoutContactHasNoJumps) {
    RunEventRecorder recorder;
    for (int i = 0; i < 3; ++i) {
        recorder.take(sampleOf(i, ContactBranch::Far, -2.0, -0.1));
    }
    EXPECT_FALSE(recorder.events().snapIn);
    EXPECT_FALSE(recorder.events().pullOff);
}

TEST(RunEvents, CountsFlagsAndFaults) {
    RunEventRecorder recorder;
    TickSample sample = sampleOf(0.0, ContactBranch::Far, 0.0, 0.0);
    sample.output.flags.set(Validity::OutsideScan, true);
    sample.output.fault = Fault::NotFinite;
    recorder.take(sample);
    EXPECT_EQ(recorder.events().flagged.at(1), 1);
    EXPECT_EQ(recorder.events().flagged.at(0), 0);
    EXPECT_EQ(recorder.events().faults, 1);
}

}  // namespace
}  // namespace asperity
