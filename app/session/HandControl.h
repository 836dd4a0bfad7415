#pragma once

#include "app/session/LiveRun.h"
#include "core/haptics/HandPilot.h"
#include "hardware/hid/HidapiTransport.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace asperity {

class LedHand;
class SpaceMouse;

/// In the order of the window's list.
enum class HandKind : int {
    Other = -1,
    Pointer,
    Script,
    SpaceMouse,
    SimulatedDevice,
    WoodenHaptics,
};

/// Which hand moves the tip of a run, and what the person does with mouse and keyboard meanwhile.
/// Displacements and velocities are those of the hand.
class HandControl {
public:
    /// A new run begins with mouse and keyboard. `run` outlives its use here.
    void attach(LiveRun& run);
    void detach();

    void usePointer();
    /// Goes to where the path begins, well above the sample, and follows it.
    void follow(const HandPath& path);
    /// One of those that need no path; the present hand stays where that one cannot have the tip.
    /// @throw Error why it cannot: no way to HID devices at all, or no scale at which it holds
    void use(HandKind kind);

    /// Which hand has the tip.
    [[nodiscard]] HandKind kind() const;

    /// Whether a person moves it by itself: a device whose axes are not those of the screen.
    [[nodiscard]] bool isDevice() const;

    /// What mouse and keyboard do; nothing while a hand has the tip that they do not lead, or the
    /// run pauses. A device's handle is moved so far that its tip goes this way.
    void displace(const Vector3& displacement);
    void setVelocity(const Vector3& velocity);
    void travelTo(const Vector2& place);
    /// In the place of mouse and keyboard: leads the base along a path, as well as the hand can.
    void leadAlong(const HandPath& path) { pilot_.follow(path); }

    /// Moves the hand on by a frame. @param halfWidth of the view: the scale of what is seen [m]
    void advance(double seconds, double halfWidth);

    /// For people: what the hand's device says; empty where there is nothing to say.
    [[nodiscard]] std::string deviceStatus() const;

private:
    using MakeLed = std::function<std::unique_ptr<LedHand>(const Vector3& start)>;
    void lead(const MakeLed& make);
    void useSpaceMouse();
    void useWoodenHaptics();
    /// The way to HID devices. @throw Error when there is none
    [[nodiscard]] HidapiTransport& hid();
    /// The hand that mouse and keyboard lead here; null: none, or the run pauses.
    [[nodiscard]] LedHand* led() const;
    /// The hand as such a device; null: it is none. The run alone knows which hand it has.
    template <typename Device>
    [[nodiscard]] Device* handAs() const {
        return run_ != nullptr ? dynamic_cast<Device*>(&run_->hand()) : nullptr;
    }
    /// Way of the hand per way that mouse and keyboard ask for.
    [[nodiscard]] double reach() const;
    /// From the present place of the base to the start of a path.
    [[nodiscard]] HandPath leadIn(const Vector3& start);

    LiveRun* run_ = nullptr;
    std::optional<HidapiTransport> transport_;
    HandPilot pilot_{Vector3::Zero()};       ///< where mouse and keyboard lead
    const HapticDevice* piloted_ = nullptr;  ///< the hand that it was made for; only compared
};

}  // namespace asperity
