#include "hardware/spacemouse/SpaceMouse.h"

#include "hardware/hid/DrainReports.h"
#include "hardware/spacemouse/SpaceMouseDriver.h"

#include <array>
#include <cmath>
#include <utility>

namespace asperity {

namespace {

constexpr std::chrono::milliseconds kReportPatience{20};  // how long a stop may have to wait

constexpr double kDeadZone = 0.05;    // a knob let go does not always rest at zero
constexpr double kGentleSlope = 0.2;  // speed per deflection where it begins

/// Speed, as a share of the full one, for the deflection of one axis. It grows with the cube, so
/// that a light touch places the tip to the nanometer; axis by axis, so that a push straight down
/// stays one.
double speedShare(double deflection) noexcept {
    const double magnitude = std::abs(deflection);
    if (!(magnitude > kDeadZone)) {
        return 0.0;
    }
    const double push = (magnitude - kDeadZone) / (1.0 - kDeadZone);
    const double share = push * (kGentleSlope + (1.0 - kGentleSlope) * push * push);
    return std::copysign(share, deflection);
}

/// The light of the device, on while it is followed. Models without one refuse the report.
class Light {
public:
    explicit Light(HidConnection& device) : device_(device) { set(true); }
    ~Light() { set(false); }
    Light(const Light&) = delete;
    Light& operator=(const Light&) = delete;

private:
    void set(bool on) {
        const std::array<std::uint8_t, 2> report = {0x04, static_cast<std::uint8_t>(on ? 1 : 0)};
        device_.write(report);
    }

    HidConnection& device_;
};

/// The state after all reports that wait, or nothing when the device is lost.
std::optional<SpaceMouseState> drain(HidConnection& device, SpaceMouseState state) {
    const Drained drained =
        drainReports(device, kReportPatience, [&state](std::span<const std::uint8_t> report) {
            state = afterReport(state, report);
        });
    if (drained == Drained::Lost) {
        return std::nullopt;
    }
    // Where reports are gone, one of them may have said that the knob was let go.
    return drained == Drained::Overflow ? SpaceMouseState{.buttons = state.buttons} : state;
}

}  // namespace

SpaceMouse::SpaceMouse(HidTransport& transport, Vector3 start, double fullSpeed)
    : position_(std::move(start))
    , fullSpeed_(fullSpeed)
    , follower_(transport, isSpaceMouse, spaceMouseDriver().label) {
    reading_.write({.connected = follower_.hasDevice()});
    follower_.start([this](const FoundDevice& found, const std::stop_token& stop) {
        follow(*found.connection, stop);
    });
}

SpaceMouse::~SpaceMouse() = default;

DeviceState SpaceMouse::advance(double timeStep) noexcept {
    const Reading& reading = reading_.read();
    const double step = fullSpeed_.load(std::memory_order_relaxed) * timeStep;
    position_ += step * reading.state.translation.unaryExpr(&speedShare);
    return {
        .position = position_, .buttons = reading.state.buttons, .connected = reading.connected};
}

/// Publishes what the device says until it is lost or no longer wanted.
void SpaceMouse::follow(HidConnection& device, const std::stop_token& stop) {
    const Light light(device);
    Reading reading = {.connected = true};
    while (!stop.stop_requested()) {
        const std::optional<SpaceMouseState> state = drain(device, reading.state);
        if (!state) {
            reading_.write({});
            return;
        }
        reading.state = *state;
        reading_.write(reading);
    }
}

}  // namespace asperity
