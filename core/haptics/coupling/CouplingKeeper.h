#pragma once

#include "core/Error.h"
#include "core/haptics/coupling/CouplingDesign.h"
#include "core/haptics/device/HapticDevice.h"

#include <optional>
#include <string>

namespace asperity {

struct Scene;

/// A force-feedback device that shall drive a tip.
struct DeviceRequest {
    DeviceSpecification device;
    LoopTiming timing;
    DeviceScale scale;
    CouplingGains own;      ///< that the scene asks for; none: those that are designed
    double maxForce = 0.0;  ///< that the operator shall feel at most [N]
    GuideLoad guide;
    PositionControl control = PositionControl::Base;
};

/// The coupling of such a device, and what it feels; or why there is none.
struct CoupledDevice {
    CouplingGains gains;
    ScaleJudgment judgment;
    std::string noCoupling;  ///< why designCoupling() has none; empty: it has

    [[nodiscard]] bool holds() const noexcept { return noCoupling.empty() && judgment.holds(); }
};

/// The scene's own coupling where it keeps the handle at rest and bears the contact, else the
/// designed one where that does: a force-feedback device is never without.
/// Source: docs/haptics.md, Gains and Scale.
[[nodiscard]] CoupledDevice coupleDevice(const ProbeSystem& tip, const DeviceRequest& request);

/// A device cannot be held as it was asked for.
struct CouplingRefused : Error {
    explicit CouplingRefused(const CoupledDevice& refused)
        : Error("the haptic device has no stable coupling"), device(refused) {}

    CoupledDevice device;
};

/// A force-feedback device drives the tip of a run only through a stable coupling and scaling,
/// within a stable edge of its workspace. Devices that only sense are left alone. Takes and returns
/// the knobs; the caller applies them.
class CouplingKeeper {
public:
    /// @param scene outlives the keeper
    explicit CouplingKeeper(const Scene& scene) : scene_(&scene) {}

    /// Releases the device: the knobs as devices that only sense had them.
    [[nodiscard]] Settings release(Settings knobs);

    /// A device takes over, after release(). One with motors gets the scene's scale where that is
    /// one for devices in millimeters and holds; else 1 mm : 1 nm with the largest force gain that
    /// holds, of 1 N : 10 nN and those below it in steps of a fifth.
    /// @param delay as the device has it so far [s]
    /// @throw CouplingRefused where no scale holds
    [[nodiscard]] Settings takeOver(const DeviceSpecification& device, double delay,
                                    Settings knobs);

    /// The operator turns knobs. Those that do not hold are refused; switching forces off never is.
    /// @throw CouplingRefused; nothing has changed then
    [[nodiscard]] Settings turned(Settings wanted, double delay);

    /// A delay that has grown beyond what the gains are designed for has them designed again; where
    /// none hold any more the forces go off, and coupled() says why.
    /// @return the knobs that changed; none: as they were
    [[nodiscard]] std::optional<Settings> follow(Settings knobs, double delay);

    /// Checks that the device can be held on another sample or with another model under these
    /// knobs.
    /// @throw CouplingRefused
    void requireHolding(const ProbeSystem& tip, const Settings& knobs) const;

    /// The force-feedback device that drives the tip, and its coupling; null without one.
    [[nodiscard]] const CoupledDevice* coupled() const noexcept {
        return held_ ? &held_->coupled : nullptr;
    }

private:
    /// A force-feedback device that drives the tip.
    struct Held {
        DeviceSpecification device;
        double delay = 0.0;  ///< designed for [s]
        CoupledDevice coupled;
        DeviceScale scale;
        DeviceScale before;            ///< of the devices that only sense
        CouplingGains couplingBefore;  ///< same
    };

    [[nodiscard]] DeviceRequest request(const Held& held, const Settings& knobs) const;
    [[nodiscard]] CoupledDevice couple(const Held& held, const Settings& knobs) const;
    [[nodiscard]] Settings fitted(const Held& held, Settings knobs) const;
    [[nodiscard]] Settings take(Held held, Settings knobs);

    const Scene* scene_;
    std::optional<Held> held_;
};

}  // namespace asperity
