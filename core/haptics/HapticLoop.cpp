#include "core/haptics/HapticLoop.h"

#include "core/scene/Scene.h"

#include <algorithm>
#include <boost/lockfree/spsc_queue.hpp>

namespace asperity {

namespace {

constexpr double kKeptSeconds = 5.0;       // of samples until somebody fetches them [s]
constexpr double kMaxSamples = 50000.0;    // some 40 MB
constexpr double kStatisticsPeriod = 1.0;  // [s]

std::size_t ringSize(const Scene& scene) {
    return static_cast<std::size_t>(
        std::min(kKeptSeconds * scene.description.tickRate, kMaxSamples));
}

}  // namespace

struct HapticLoop::Ring : boost::lockfree::spsc_queue<TickSample> {
    using spsc_queue::spsc_queue;
};

HapticLoop::HapticLoop(const Scene& scene, HapticDevice& device, AfmController& afm)
    : settings_(scene.settings)
    , scene_(scene)
    , device_(&device)
    , specification_(device.specification())
    , afm_(afm)
    , truth_(dynamic_cast<const TrueTip*>(&afm))
    , samples_(std::make_unique<Ring>(ringSize(scene))) {}

HapticLoop::~HapticLoop() { stop(); }

void HapticLoop::start() {
    if (!thread_) {
        thisSecond_ = {};
        sinceStart_ = {};
        ++latest_.sample.input.starts;
        thread_.emplace(scene_.description.tickRate, [this](const Beat& now) { beat(now); });
    }
}

void HapticLoop::setDevice(HapticDevice& device) noexcept {
    device_ = &device;
    specification_ = device.specification();
    ++latest_.sample.input.starts;
}

void HapticLoop::stop() {
    thread_.reset();
    tellForce(Vector3::Zero());
}

void HapticLoop::drain(const std::function<void(const TickSample&)>& sink) {
    samples_->consume_all([&sink](const TickSample& sample) { sink(sample); });
}

void HapticLoop::beat(const Beat& beat) noexcept {
    const double begin = monotonicSeconds();
    tickOnce(static_cast<double>(1 + beat.skipped) * scene_.timeStep());
    measure(beat, begin);
    publish();
}

void HapticLoop::step() {
    tickOnce(scene_.timeStep());
    ++latest_.statistics.ticks;
    publish();
}

void HapticLoop::publish() noexcept {
    if (!samples_->push(latest_.sample)) {
        ++latest_.statistics.lostSamples;
    }
    snapshot_.write(latest_);
}

void HapticLoop::tickOnce(double timeStep) noexcept {
    TickSample& sample = latest_.sample;
    if (latest_.memory.started) {
        sample.time += timeStep;
    }
    TickInput& input = sample.input;
    input.settings = settings_.read();
    input.timeStep = timeStep;
    input.device = device_->advance(timeStep);
    input.device.maxForce = specification_.maxForce;
    input.device.streams = specification_.streams;
    const BaseCommand command = commandBase(scene_, input, latest_.memory, tracker_);
    input.measurement = afm_.exchange(command.base);
    sample.output = tick(scene_, input, command, latest_.memory, tracker_);
    if (truth_ != nullptr) {
        latest_.trueTip = truth_->trueTip();
    }
    tellForce(sample.output.deviceForce);
    device_->observe(sample.output);
}

/// A device without a governor never gets a force.
void HapticLoop::tellForce(const Vector3& force) noexcept {
    if (specification_.rendersForce()) {
        device_->setForce(force);
    }
}

void HapticLoop::measure(const Beat& beat, double begin) noexcept {
    LoopStatistics& statistics = latest_.statistics;
    const double tickTime = monotonicSeconds() - begin;
    thisSecond_.add(tickTime, beat.lateness);
    sinceStart_.add(tickTime, beat.lateness);
    ++statistics.ticks;
    statistics.overruns += beat.skipped;
    statistics.policy = beat.policy;
    const auto counted = static_cast<double>(thisSecond_.tick.count());
    if (counted >= kStatisticsPeriod * scene_.description.tickRate) {
        statistics.tickTime = thisSecond_.tick.quantiles();
        statistics.lateness = thisSecond_.lateness.quantiles();
        thisSecond_ = {};
    }
}

}  // namespace asperity
