#include "core/experiment/TrialRun.h"

#include "core/haptics/DevicePath.h"
#include "core/haptics/HapticLoop.h"
#include "core/haptics/coupling/CouplingKeeper.h"
#include "core/scene/BelievedModel.h"
#include "core/scene/Scene.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace asperity {

namespace {

constexpr double kMomentRate = 100.0;    // [Hz]
constexpr double kEngagePatience = 5.0;  // for the forces to come on [s]

// View of the sample in the window before anybody turns the view: see ViewScale and ViewCamera.
constexpr double kScreenWidth = 0.2;    // of the large view [m]
constexpr double kShownTipRadii = 4.8;  // its width on the sample, in tip radii
constexpr double kAzimuth = -1.917;     // [rad]
constexpr double kElevation = 0.565;    // [rad]

Vector3 lineOfSight() {
    return -Vector3(std::cos(kElevation) * std::cos(kAzimuth),
                    std::cos(kElevation) * std::sin(kAzimuth), std::sin(kElevation));
}

OperatorTask operatorTask(const TrialSetup& setup, const Vector3& target, double positionGain) {
    const double shown = kShownTipRadii * setup.scene.description.tip.radius;
    return {.target = target,
            .positionGain = positionGain,
            .screenScale = kScreenWidth / shown,
            .lineOfSight = lineOfSight()};
}

/// Keeps a hundred moments a second, and the largest force between them.
class MomentKeeper {
public:
    explicit MomentKeeper(double timeStep)
        : every_(std::max(1L, std::lround(1.0 / (kMomentRate * timeStep)))) {}

    void take(const TickSample& sample, const Vector3& tip, double time, bool isLast) {
        largest_ = std::max(largest_, sample.output.estimate.force.norm());
        if (ticks_++ % every_ == 0 || isLast) {
            moments_.push_back(momentOf(sample, time, tip));
            moments_.back().largestForce = std::exchange(largest_, 0.0);
        }
    }

    [[nodiscard]] std::vector<TrialMoment> release() { return std::move(moments_); }

private:
    long every_;
    long ticks_ = 0;
    double largest_ = 0.0;
    std::vector<TrialMoment> moments_;
};

/// A trial while it is done.
class RunningTrial {
public:
    RunningTrial(const TrialSetup& setup, const PlannedTrial& plan)
        : setup_(setup)
        , plan_(plan)
        , positions_(positionsOf(setup.study, setup.scene, plan))
        , settings_(trialSettings(setup.study, setup.scene, setup.bench, positions_.target))
        , afm_(setup.scene.trueSurface(), truth(setup.scene, plan.seed))
        , waiting_({{0.0, positions_.start}}, setup.scene.settings.positionGain)
        , device_(setup.bench, Vector3::Zero(),
                  Operator(setup.person,
                           operatorTask(setup, positions_.target, settings_.positionGain),
                           Vector3::Zero(), plan.seed))
        , loop_(setup.scene, waiting_, afm_) {
        device_.showDeformation(setup.study.aids.deformation);
        loop_.step();  // the base waits where the trial begins before the bench takes over
        loop_.setSettings(settings_);
        loop_.setDevice(device_);
    }

    DoneTrial run(const TrialWatch& watch) {
        engage();
        DoneTrial done;
        done.record.plan = plan_;
        done.record.device = "virtual_bench";
        done.record.start = tip();
        done.record.target = positions_.target;
        done.record.scale = {.positionGain = settings_.positionGain,
                             .forceGain = settings_.forceGain};
        done.record.coupling = settings_.coupling;
        device_.person().begin();
        if (watch.begin) {
            watch.begin(loop_.memory());
        }
        MomentKeeper keeper(setup_.scene.timeStep());
        for (long ticks = 1; !ended_; ++ticks) {
            loop_.step();
            const TickSample& sample = loop_.snapshot().sample;
            const double time = static_cast<double>(ticks) * setup_.scene.timeStep();
            done.record.fault = sample.output.fault;
            done.record.timedOut = time >= setup_.study.timeLimit;
            ended_ = done.record.timedOut || done.record.fault != Fault::None ||
                     device_.person().hasPressed();
            keeper.take(sample, tip(), time, ended_);
            if (watch.tick) {
                watch.tick(sample);
            }
        }
        done.moments = keeper.release();
        evaluate(done);
        return done;
    }

private:
    static InstrumentTruth truth(const Scene& scene, std::uint64_t seed) {
        InstrumentTruth truth = truthOf(scene);
        truth.seed = seed;
        return truth;
    }

    /// Nothing is measured while the forces come on; whether they do is found in the trial.
    void engage() {
        const double patience = kEngagePatience + settings_.governor.engageTime;
        const auto ticks = std::lround(patience / setup_.scene.timeStep());
        for (long i = 0; i < ticks && !isOn(); ++i) {
            loop_.step();
        }
    }

    [[nodiscard]] bool isOn() {
        const ForceState state = loop_.snapshot().sample.output.forceState;
        return loop_.snapshot().statistics.ticks > 1 &&
               (!settings_.forcesOn || state == ForceState::On || state == ForceState::Limited);
    }

    [[nodiscard]] Vector3 tip() const { return afm_.trueState().tip; }

    const TrialSetup& setup_;
    const PlannedTrial& plan_;
    TrialPositions positions_;
    Settings settings_;
    SimulatedAfm afm_;
    ScriptedDevice waiting_;
    OperatedBench device_;
    HapticLoop loop_;
    bool ended_ = false;
};

/// Returns the true tip; of an instrument that knows none, that of the model.
Vector3 tipOf(const Snapshot& frame) {
    return frame.trueTip.value_or(frame.sample.output.model.tip);
}

}  // namespace

Settings trialSettings(const Study& study, const Scene& scene, const BenchSetup& bench,
                       const Vector3& target) {
    Settings settings = scene.settings;
    if (study.aids.coupling) {
        CouplingKeeper keeper(scene);
        settings = keeper.takeOver(VirtualBench(bench, Vector3::Zero()).specification(),
                                   bench.delay, settings);
        settings.guide.kind = study.aids.guide;
        settings.guide.point = target;
        settings.guide.axis = Vector3::UnitZ();
        settings = keeper.turned(settings, bench.delay);
    }
    return settings;
}

DoneTrial runTrial(const TrialSetup& setup, const PlannedTrial& trial, const TrialWatch& watch) {
    return RunningTrial(setup, trial).run(watch);
}

WatchedTrial::WatchedTrial(const PlannedTrial& plan, const Vector3& target, const Snapshot& begin)
    : begin_(begin.sample.time), newest_(begin.sample) {
    trial_.record.plan = plan;
    trial_.record.start = tipOf(begin);
    trial_.record.target = target;
    trial_.moments.push_back(momentOf(begin.sample, 0.0, tipOf(begin)));
}

void WatchedTrial::take(const TickSample& sample) {
    if (sample.time > begin_) {
        waiting_.push_back({sample.time, sample.output.estimate.force.norm()});
    }
}

double WatchedTrial::largestUpTo(double time) {
    double largest = 0.0;
    while (!waiting_.empty() && waiting_.front().time <= time) {
        largest = std::max(largest, waiting_.front().size);
        waiting_.pop_front();
    }
    return largest;
}

void WatchedTrial::show(const Snapshot& frame) {
    if (frame.sample.time <= newest_.time) {
        return;  // no tick since the frame before
    }
    newest_ = frame.sample;
    TrialMoment moment = momentOf(frame.sample, time(), tipOf(frame));
    moment.largestForce = largestUpTo(frame.sample.time);
    trial_.moments.push_back(moment);
}

DoneTrial WatchedTrial::end(const TrialEnd& end) const {
    DoneTrial done = trial_;
    const Settings& settings = newest_.input.settings;
    done.record.scale = {.positionGain = settings.positionGain, .forceGain = settings.forceGain};
    done.record.coupling = settings.coupling;
    done.record.fault = fault();
    done.record.timedOut = end.timedOut;
    done.record.struckOut = end.struckOut;
    evaluate(done);
    return done;
}

}  // namespace asperity
