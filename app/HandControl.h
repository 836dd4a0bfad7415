#pragma once

#include "app/LiveRun.h"
#include "core/haptics/HandPilot.h"
#include "hardware/HidapiTransport.h"

#include <optional>
#include <string>

namespace asperity {

class PointerHand;
class SpaceMouse;

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
    /// @throw Error when there is no way to HID devices at all
    void useSpaceMouse();

    [[nodiscard]] bool pointing() const { return pointer_ != nullptr; }
    [[nodiscard]] bool scripted() const {
        return run_ != nullptr && !pointing() && spaceMouse_ == nullptr;
    }

    /// What only mouse and keyboard do; nothing while another hand has the tip or the run pauses.
    void displace(const Vector3& displacement);
    void setVelocity(const Vector3& velocity);
    void travelTo(const Vector2& place);

    /// Moves the hand on by a frame. @param halfWidth of the view: the scale of what is seen [m]
    void advance(double seconds, double halfWidth);

    /// For people: what the hand's device says; empty where there is nothing to say.
    [[nodiscard]] std::string deviceStatus() const;

private:
    void letGo();
    /// Mouse and keyboard have the tip, and the run does not pause.
    [[nodiscard]] bool leads() const;
    /// From the present place of the base to the start of a path.
    [[nodiscard]] HandPath leadIn(const Vector3& start);

    LiveRun* run_ = nullptr;
    std::optional<HidapiTransport> transport_;
    PointerHand* pointer_ = nullptr;    ///< of the run, while it has the tip
    SpaceMouse* spaceMouse_ = nullptr;  ///< likewise
    std::optional<HandPilot> pilot_;    ///< leads the pointer
};

}  // namespace asperity
