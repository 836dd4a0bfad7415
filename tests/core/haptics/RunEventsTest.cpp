#include "core/haptics/VirtualRun.h"

#include <gtest/gtest.h>

#include <initializer_list>

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

/// A tick in contact in which the signals have this normal force.
TickSample pullOf(double time, double model, double estimate) {
    TickSample sample = sampleOf(time, ContactBranch::Bonded, -0.5, model);
    sample.output.model.normalForce = model;
    sample.output.estimate.force = Vector3(0.0, 0.0, estimate);
    sample.output.estimate.covariance = 0.01 * Matrix3::Identity();
    return sample;
}

/// When signals and model last held the tip, of a contact that ends with the model's pull-off; -1
/// when they never did.
double lastHold(std::initializer_list<TickSample> contact) {
    RunEventRecorder recorder;
    recorder.take(pullOf(-3.0, -9.0, -9.0));  // of a contact before
    recorder.take(sampleOf(-2.0, ContactBranch::Far, -3.0, 0.0));
    double time = 0.0;
    for (const TickSample& sample : contact) {
        recorder.take(sample);
        time = sample.time;
    }
    EXPECT_EQ(recorder.events().pullOff->time, -2.0);
    recorder.take(sampleOf(time + 1.0, ContactBranch::Far, -3.0, 0.0));
    EXPECT_EQ(recorder.events().beforePullOff->time, time);
    return recorder.events().lastHold ? recorder.events().lastHold->time : -1.0;
}

TEST(RunEvents, LastHoldIsBeforeTheSignalsLetGo) {
    EXPECT_EQ(lastHold({pullOf(1.0, 3.0, 3.1), pullOf(2.0, -5.0, -4.8), pullOf(3.0, -4.8, -4.4),
                        pullOf(4.0, -4.7, 0.3), pullOf(5.0, -4.6, -0.2)}),
              3.0);
}

TEST(RunEvents, LastHoldIsBeforeTheModelLetsGo) {
    EXPECT_EQ(lastHold({pullOf(2.0, -5.0, -4.8), pullOf(3.0, -4.5, -4.9)}), 3.0);
}

TEST(RunEvents, LastHoldOfASampleThatIsAnotherIsWhereBothPullMost) {
    EXPECT_EQ(lastHold({pullOf(1.0, -1.0, -0.3), pullOf(2.0, -5.0, -2.0), pullOf(3.0, -4.9, -1.9),
                        pullOf(4.0, -4.8, -0.1)}),
              2.0);
}

TEST(RunEvents, SignalsThatNeverPullHoldNothing) {
    EXPECT_EQ(lastHold({pullOf(1.0, 2.0, 2.0), pullOf(2.0, -5.0, 0.5), pullOf(3.0, -4.9, 0.1)}),
              -1.0);
}

TEST(RunEvents, ListsCyclesUpToOneThatIsStillInContact) {
    RunEventRecorder recorder;
    double time = 0.0;
    // Base height and force [nm, nN]; each is held for a while.
    const auto hold = [&](double height, double force) {
        for (int i = 0; i < 40; ++i) {
            TickSample sample = pullOf(time += 1e-3, force * 1e-9, force * 1e-9);
            const bool bonded = force != 0.0;
            sample.output.model.contact.branch =
                bonded ? ContactBranch::Bonded : ContactBranch::Far;
            sample.output.estimate.covariance = 0.01e-18 * Matrix3::Identity();
            sample.output.base.position.z() = height * 1e-9;
            recorder.take(sample);
        }
    };
    hold(5.0, 0.0);
    for (const double pull : {-3.0, -4.0}) {
        hold(-1.0, 8.0);
        hold(1.0, pull);
        hold(5.0, 0.0);
    }
    hold(-1.0, 6.0);
    const std::vector<ContactCycle>& cycles = recorder.events().cycles;
    ASSERT_EQ(cycles.size(), 3U);
    EXPECT_NEAR(cycles[0].pullOff.value().value, 3e-9, 1e-15);
    EXPECT_NEAR(cycles[1].pullOff.value().value, 4e-9, 1e-15);
    EXPECT_FALSE(cycles[2].complete());
    EXPECT_NEAR(cycles[2].maxForce->value, 6e-9, 1e-15);
}

TEST(RunEvents, ARunThatBeginsInContactHasNoSnapIn) {
    for (const ContactBranch first : {ContactBranch::Far, ContactBranch::Bonded}) {
        RunEventRecorder recorder;
        recorder.take(sampleOf(0.0, first, 0.0, 0.0));
        recorder.take(sampleOf(1.0, ContactBranch::Bonded, 1.0, 0.0));
        EXPECT_EQ(recorder.events().bondedFromStart, first == ContactBranch::Bonded);
        EXPECT_EQ(recorder.events().snapIn.has_value(), first == ContactBranch::Far);
    }
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
