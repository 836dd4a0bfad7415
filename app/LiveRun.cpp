#include "app/LiveRun.h"

#include "core/haptics/PointerHand.h"

#include <utility>

namespace asperity {

Vector3 startPlace(const Scene& scene) {
    return waitingPlace(scene, 0.5 * Vector2(scene.surface.sizeX(), scene.surface.sizeY()));
}

LiveRun::LiveRun(LoadedScene loaded, const Vector3& start)
    : loaded_(std::move(loaded))
    , start_(start)
    , settings_(loaded_.scene.settings)
    , afm_(loaded_.scene.touched(), loaded_.scene.truth)
    , hand_(std::make_unique<PointerHand>(start / settings_.positionGain))
    , halfSpace_(loaded_.scene.model.deformation == DeformationTier::HalfSpace
                     ? std::make_unique<HalfSpaceWorker>(loaded_.scene)
                     : nullptr)
    , loop_(loaded_.scene, *hand_, afm_)
    , blackBox_(loaded_.scene.timeStep()) {}

void LiveRun::fetch(const TickSink& sink) {
    const double begin = processorSeconds();
    loop_.drain([&](const TickSample& sample) {
        blackBox_.take(sample);
        sink(sample);
        ++fetchCost_.ticks;
    });
    blackBox_.mark(loop_.snapshot());
    fetchCost_.time += processorSeconds() - begin;
}

void LiveRun::setSettings(const Settings& settings) noexcept {
    settings_ = settings;
    loop_.setSettings(settings);
}

void LiveRun::takeHand(const MakeHand& make) {
    const bool running = loop_.running();
    loop_.stop();
    try {
        std::unique_ptr<HapticDevice> hand = make();
        loop_.setHand(*hand);
        hand_ = std::move(hand);
    } catch (...) {
        if (running) {
            loop_.start();
        }
        throw;
    }
    if (running) {
        loop_.start();
    }
}

Vector3 LiveRun::handPosition() noexcept {
    const Snapshot& latest = loop_.snapshot();
    return latest.statistics.ticks > 0 ? latest.sample.input.hand.position
                                       : Vector3(start_ / settings_.positionGain);
}

Vector3 LiveRun::basePosition() noexcept {
    const Snapshot& latest = loop_.snapshot();
    return latest.statistics.ticks > 0 ? latest.sample.output.base.position : start_;
}

LoadedScene LiveRun::release(std::unique_ptr<LiveRun> run) {
    run->loop_.stop();
    run->halfSpace_.reset();
    return std::move(run->loaded_);
}

}  // namespace asperity
