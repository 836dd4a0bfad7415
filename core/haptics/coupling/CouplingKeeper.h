#pragma once

#include "core/Error.h"
#include "core/haptics/coupling/CoupledDevice.h"
#include "core/scene/Scene.h"

#include <optional>

namespace asperity {

/// A device cannot be held as it was asked for.
struct CouplingRefused : Error {
    explicit CouplingRefused(const CoupledDevice& refused)
        : Error("the haptic device cannot be held so"), device(refused) {}

    CoupledDevice device;
};

/// Sees to it that no force-feedback device leads the tip of a run but with a coupling, a scale and
/// an edge of its workspace that hold. Devices that only sense are left alone. Knobs go in and come
/// out; who calls it turns them.
class CouplingKeeper {
public:
    /// @param scene outlives the keeper
    explicit CouplingKeeper(const Scene& scene) : scene_(&scene) {}

    /// The device that leads lets go: the knobs as devices that only sense had them.
    [[nodiscard]] Settings release(Settings knobs);

    /// A device takes over, after release(). One with motors gets the scene's scale where that is
    /// one for hands in millimeters and holds; else 1 mm : 1 nm with the largest force gain that
    /// holds, of 1 N : 10 nN and those below it in steps of a fifth.
    /// @param delay as the device has it so far [s]
    /// @throw CouplingRefused where no scale holds
    [[nodiscard]] Settings takeOver(const DeviceSpecification& device, double delay,
                                    Settings knobs);

    /// A person turns knobs. Those that do not hold are refused; switching forces off never is.
    /// @throw CouplingRefused; nothing has changed then
    [[nodiscard]] Settings turned(Settings wanted, double delay);

    /// A delay that has grown beyond what the gains are designed for has them designed anew; where
    /// none hold any more the forces go off, and coupled() says why.
    /// @return the knobs that changed; none: as they were
    [[nodiscard]] std::optional<Settings> follow(Settings knobs, double delay);

    /// Whether the device could be held on another sample or with another model under these knobs.
    /// @throw CouplingRefused
    void requireHolding(const ProbeSystem& tip, const Settings& knobs) const;

    /// The force-feedback device that leads, and what it feels; null where none does.
    [[nodiscard]] const CoupledDevice* coupled() const noexcept {
        return led_ ? &led_->coupled : nullptr;
    }

private:
    /// A force-feedback device that leads.
    struct Led {
        DeviceSpecification device;
        double delay = 0.0;  ///< designed for [s]
        CoupledDevice coupled;
        DeviceScale scale;
        DeviceScale before;            ///< of the devices that only sense
        CouplingGains couplingBefore;  ///< likewise
    };

    [[nodiscard]] DeviceRequest request(const Led& led, const Settings& knobs) const;
    [[nodiscard]] CoupledDevice couple(const Led& led, const Settings& knobs) const;
    [[nodiscard]] Settings fitted(const Led& led, Settings knobs) const;
    [[nodiscard]] Settings take(Led led, Settings knobs);

    const Scene* scene_;
    std::optional<Led> led_;
};

}  // namespace asperity
