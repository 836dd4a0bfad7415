#include "core/haptics/VirtualRun.h"

#include "core/scene/Scene.h"

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

/// @param advance gives the device's state at a time [s]
/// @param observe gets every tick's output, before `sink` gets the tick
template <class Advance, class Observe>
void run(const Scene& scene, AfmController& afm, long ticks, const TickSink& sink,
         const Advance& advance, const Observe& observe) {
    TickMemory memory;
    ClosestPointTracker tracker;
    TickSample sample;
    sample.input.settings = scene.settings;
    sample.input.timeStep = scene.timeStep();
    for (long i = 0; i < ticks; ++i) {
        sample.time = static_cast<double>(i) * scene.timeStep();
        sample.input.device = advance(sample.time);
        const BaseCommand command = commandBase(scene, sample.input, memory, tracker);
        sample.input.measurement = afm.exchange(command.base);
        sample.output = tick(scene, sample.input, command, memory, tracker);
        observe(sample.output);
        sink(sample);
    }
}

constexpr double kAgreementSigmas = 3.0;
constexpr double kAgreementShare = 0.2;  // of the model's force

/// Normal force of one tick, as the signals and as the model have it, along the model's normal.
struct NormalForces {
    double estimate = 0.0;  ///< [N]
    double sigma = 0.0;     ///< of the estimate [N]
    double model = 0.0;     ///< [N]

    explicit NormalForces(const TickOutput& out)
        : estimate(out.estimate.force.dot(out.model.normal))
        , sigma(std::sqrt(out.model.normal.dot(out.estimate.covariance * out.model.normal)))
        , model(out.model.normalForce) {}

    [[nodiscard]] double weakerPull() const { return -std::max(estimate, model); }
    [[nodiscard]] bool agree() const {
        return std::abs(estimate - model) <=
               std::max(kAgreementSigmas * sigma, kAgreementShare * std::abs(model));
    }
};

}  // namespace

void runVirtually(const Scene& scene, const DevicePath& path, AfmController& afm, long ticks,
                  const TickSink& sink) {
    const auto advance = [&](double time) -> DeviceState {
        return {.position = positionAt(path, time) / scene.settings.positionGain};
    };
    run(scene, afm, ticks, sink, advance, [](const TickOutput&) {});
}

void runVirtually(const Scene& scene, HapticDevice& device, AfmController& afm, long ticks,
                  const TickSink& sink) {
    run(
        scene, afm, ticks, sink, [&](double) { return device.advance(scene.timeStep()); },
        [&](const TickOutput& output) { device.observe(output); });
}

void HoldRecorder::take(const TickSample& sample) {
    const NormalForces forces(sample.output);
    if (!(forces.weakerPull() > 0.0)) {
        return;
    }
    if (forces.agree()) {
        agreeing_ = sample;
    } else if (!strongest_ || forces.weakerPull() > NormalForces(strongest_->output).weakerPull()) {
        strongest_ = sample;
    }
}

std::optional<TickSample> HoldRecorder::release() {
    std::optional<TickSample> last = agreeing_ ? agreeing_ : strongest_;
    agreeing_.reset();
    strongest_.reset();
    return last;
}

void RunEventRecorder::take(const TickSample& sample) {
    ++events_.ticks;
    takeJumps(sample);
    takeExtremes(sample);
    takeCycle(sample);
    for (std::size_t i = 0; i < kValidityFlagCount; ++i) {
        if (sample.output.flags.has(kValidityTraits.at(i).flag)) {
            ++events_.flagged.at(i);
        }
    }
    if (sample.output.fault != Fault::None) {
        ++events_.faults;
    }
    previous_ = sample;
}

void RunEventRecorder::takeJumps(const TickSample& sample) {
    const ContactBranch now = sample.output.model.contact.branch;
    if (now == ContactBranch::Bonded) {
        holds_.take(sample);
    }
    if (!previous_) {
        events_.bondedFromStart = now == ContactBranch::Bonded;
        return;
    }
    const ContactBranch before = previous_->output.model.contact.branch;
    if (before == now) {
        return;
    }
    if (now == ContactBranch::Bonded && !events_.snapIn) {
        events_.beforeSnapIn = previous_;
        events_.snapIn = sample;
    }
    if (now == ContactBranch::Far) {
        events_.beforePullOff = previous_;
        events_.pullOff = sample;
        events_.lastHold = holds_.release();
    }
}

void RunEventRecorder::takeExtremes(const TickSample& sample) {
    const ContactState& contact = sample.output.model.contact;
    if (!events_.deepest ||
        contact.indentation > events_.deepest->output.model.contact.indentation) {
        events_.deepest = sample;
    }
    if (!events_.strongestPull ||
        contact.force < events_.strongestPull->output.model.contact.force) {
        events_.strongestPull = sample;
    }
    events_.largestForce = std::max(events_.largestForce, sample.output.model.force.norm());
    events_.largestEstimatedForce =
        std::max(events_.largestEstimatedForce, sample.output.estimate.force.norm());
}

void RunEventRecorder::takeCycle(const TickSample& sample) {
    cycles_.take(sample.time, sample.input, sample.output);
    if (!cycles_.cycle().touched()) {
        return;
    }
    if (lastCycle_ != cycles_.number()) {
        lastCycle_ = cycles_.number();
        events_.cycles.emplace_back();
    }
    events_.cycles.back() = cycles_.cycle();
}

}  // namespace asperity
