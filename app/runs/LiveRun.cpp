#include "app/runs/LiveRun.h"

#include "core/haptics/device/HapticDevice.h"
#include "core/scene/BelievedModel.h"
#include "core/scene/Scene.h"
#include "core/surface/BSplineSurface.h"
#include "core/words/DeviceWords.h"

#include <utility>

namespace asperity {

namespace {

/// Asks the coupling's keeper, with its refusal in words.
template <class Ask>
auto inWords(const Ask& ask) {
    try {
        return ask();
    } catch (const CouplingRefused& refused) {
        throw Error(refusalOf(refused.device));
    }
}

/// Returns whether a device is not plugged in, may not be opened or is not calibrated yet.
bool isMissing(const DeviceStatus& status) {
    return status.problem != DeviceProblem::None || !status.calibrated;
}

bool isGone(Fault fault) { return fault == Fault::DeviceLost || fault == Fault::DeviceSilent; }

}  // namespace

Vector3 startPosition(const Scene& scene) {
    const BSplineSurface& surface = scene.surface;
    const Vector2 middle = 0.5 * Vector2(surface.sizeX(), surface.sizeY());
    return waitingPosition(scene, nearestMeasured(surface, middle));
}

LiveRun::LiveRun(LoadedScene loaded, const Vector3& start, const MakeInstrument& makeInstrument)
    : loaded_(std::make_shared<LoadedScene>(std::move(loaded)))
    , coupling_(loaded_->scene)
    , start_(start)
    , settings_(loaded_->scene.settings)
    , instrument_(makeInstrument(loaded_->scene))
    , device_(std::make_unique<PointerDevice>(start / settings_.positionGain))
    , halfSpace_(newHalfSpace(loaded_->scene))
    , loop_(loaded_->scene, *device_, *instrument_)
    , blackBox_(loaded_->scene.timeStep())
    , energy_(newEnergyWatch()) {}

EnergyWatch LiveRun::newEnergyWatch() const {
    return {loaded_->scene.timeStep(), device_->delay()};
}

std::unique_ptr<HalfSpaceWorker> newHalfSpace(const Scene& scene) {
    return scene.model.deformation == DeformationModel::HalfSpace
               ? std::make_unique<HalfSpaceWorker>(scene)
               : nullptr;
}

void LiveRun::fetch(const TickSink& sink) {
    const double begin = processorSeconds();
    loop_.drain([&](const TickSample& sample) {
        keep(sample);
        energy_.take(sample);
        sink(sample);
        ++fetchCost_.ticks;
    });
    blackBox_.mark(loop_.snapshot());
    fetchCost_.time += processorSeconds() - begin;
}

void LiveRun::keep(const TickSample& sample) {
    const bool isOfDevice = sample.input.starts > startsBefore_;
    awaited_ = awaited_ && !(isOfDevice && sample.input.device.connected);
    const bool wasFrozen = blackBox_.frozen();
    blackBox_.take(sample);
    if (!wasFrozen && awaitsDevice() && sample.output.fault == Fault::DeviceLost) {
        blackBox_.restart();
    }
}

void LiveRun::apply(const Settings& settings) noexcept {
    settings_ = settings;
    loop_.setSettings(settings);
}

void LiveRun::setSettings(const Settings& settings) {
    apply(inWords([&] { return coupling_.turned(settings, device_->delay()); }));
}

Settings LiveRun::sensingSettings() const {
    CouplingKeeper without = coupling_;
    return without.release(settings_);
}

void LiveRun::requireHolding(const SceneDescription& scene) const {
    if (coupling_.coupled() != nullptr) {
        const ProbeSystem tip = believedSystem(scene, usualModel(scene));
        inWords([&] { coupling_.requireHolding(tip, settings_); });
    }
}

bool LiveRun::followDelay() {
    const std::optional<Settings> changed = coupling_.follow(settings_, device_->delay());
    if (changed) {
        apply(*changed);
        energy_ = newEnergyWatch();
    }
    return changed.has_value();
}

void LiveRun::takeDevice(const MakeDevice& make) {
    const bool running = loop_.running();
    const CouplingKeeper coupling = coupling_;
    const Settings settings = settings_;
    loop_.stop();
    try {
        apply(coupling_.release(settings_));
        seat(make());
    } catch (...) {
        coupling_ = coupling;
        apply(settings);
        if (running) {
            loop_.start();
        }
        throw;
    }
    if (running) {
        loop_.start();
    }
}

/// A device is where it is, not where the base waits: the first tick measures that before the
/// device drives the tip. That the device before it has gone is no fault of one that only senses.
void LiveRun::seat(std::unique_ptr<HapticDevice> device) {
    const DeviceSpecification specification = device->specification();
    Settings settings =
        inWords([&] { return coupling_.takeOver(specification, device->delay(), settings_); });
    if (!specification.rendersForce() && isGone(loop_.snapshot().sample.output.fault)) {
        ++settings.rearms;
    }
    if (specification.rendersForce() && loop_.snapshot().statistics.ticks == 0) {
        loop_.step();
    }
    apply(settings);
    awaited_ = isMissing(device->status());
    startsBefore_ = loop_.snapshot().sample.input.starts;
    loop_.setDevice(*device);
    device_ = std::move(device);
    energy_ = newEnergyWatch();
}

Vector3 LiveRun::devicePosition() noexcept {
    const Snapshot& latest = loop_.snapshot();
    return latest.statistics.ticks > 0 ? latest.sample.input.device.position
                                       : Vector3(start_ / settings_.positionGain);
}

Vector3 LiveRun::basePosition() noexcept {
    const Snapshot& latest = loop_.snapshot();
    return latest.statistics.ticks > 0 ? latest.sample.output.base.position : start_;
}

void LiveRun::adopt(const SceneDescription& description) {
    adoptShown(loaded_->scene.description, description);
}

bool LiveRun::mayAdoptModel() noexcept {
    const ContactState& contact = loop_.snapshot().sample.output.model.contact;
    return contact.region() == TipRegion::Far && !blackBox_.frozen() && loaded_.use_count() == 1;
}

void LiveRun::adoptModel(const LoadedScene& fitted) {
    halfSpace_.reset();
    const bool isAnother = loaded_->scene.model != fitted.scene.model;
    loaded_->needs = fitted.needs;
    loaded_->scene.model = fitted.scene.model;
    loaded_->scene.leftOut = fitted.scene.leftOut;
    loaded_->scene.belief = fitted.scene.belief;
    halfSpace_ = newHalfSpace(loaded_->scene);
    if (isAnother) {
        blackBox_.restart();               // its ticks replay under one model
        blackBox_.mark(loop_.snapshot());  // a fault may come before the next frame
    }
}

}  // namespace asperity
