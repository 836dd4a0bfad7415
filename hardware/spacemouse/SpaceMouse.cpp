#include "hardware/spacemouse/SpaceMouse.h"

#include "hardware/hid/HidapiTransport.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace asperity {

namespace {

constexpr std::uint8_t kMotionId = 1;
constexpr std::uint8_t kRotationId = 2;
constexpr std::uint8_t kButtonsId = 3;
constexpr std::size_t kThreeAxes = 6;  // [byte]
constexpr std::size_t kSixAxes = 12;   // [byte]
constexpr double kFullDeflection = 350.0;

using Payload = std::span<const std::uint8_t>;

double axis(Payload payload, std::size_t index) noexcept {
    const auto low = static_cast<unsigned>(payload[2 * index]);
    const auto high = static_cast<unsigned>(payload[2 * index + 1]);
    const auto counts = static_cast<std::int16_t>(low | (high << 8U));
    return std::clamp(counts / kFullDeflection, -1.0, 1.0);
}

/// The device's frame is the lab's turned by half a turn about x.
Vector3 labVector(Payload payload) noexcept {
    return {axis(payload, 0), -axis(payload, 1), -axis(payload, 2)};
}

std::uint32_t buttonBits(Payload payload) noexcept {
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < std::min(payload.size(), sizeof(bits)); ++i) {
        bits |= static_cast<std::uint32_t>(payload[i]) << (8 * i);
    }
    return bits;
}

constexpr std::chrono::milliseconds kReportPatience{20};  // how long a stop may have to wait

constexpr double kDeadZone = 0.05;    // a released knob does not always rest at zero
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
    // A lost report may have said that the knob was released.
    return drained == Drained::Overflow ? SpaceMouseState{.buttons = state.buttons} : state;
}

struct ProductRange {
    std::uint16_t vendorId;
    std::uint16_t first;
    std::uint16_t last;
};

// Logitech made them first. CadMice lie at 256f:c650-c658, among them the receiver for all, c652.
constexpr std::array kSpaceMice = {ProductRange{0x046d, 0xc603, 0xc640},
                                   ProductRange{0x256f, 0xc62e, 0xc64f},
                                   ProductRange{0x256f, 0xc652, 0xc652}};

constexpr HidUsage kMultiAxisController = {.page = 0x01, .id = 0x08};

}  // namespace

SpaceMouseState afterReport(const SpaceMouseState& before,
                            std::span<const std::uint8_t> report) noexcept {
    SpaceMouseState state = before;
    if (report.size() < 2) {
        return state;
    }
    const std::uint8_t id = report.front();
    const Payload payload = report.subspan(1);
    if (id == kMotionId && payload.size() == kSixAxes) {
        state.translation = labVector(payload.first(kThreeAxes));
        state.rotation = labVector(payload.subspan(kThreeAxes));
    } else if (id == kMotionId && payload.size() == kThreeAxes) {
        state.translation = labVector(payload);
    } else if (id == kRotationId && payload.size() == kThreeAxes) {
        state.rotation = labVector(payload);
    } else if (id == kButtonsId) {
        state.buttons = buttonBits(payload);
    }
    return state;
}

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

bool isSpaceMouse(const HidDeviceInfo& device) {
    const bool known = std::ranges::any_of(kSpaceMice, [&device](const ProductRange& range) {
        return device.vendorId == range.vendorId && device.productId >= range.first &&
               device.productId <= range.last;
    });
    return known && device.hasCollection(kMultiAxisController);
}

const DeviceDriver& spaceMouseDriver() {
    static const DeviceDriver driver{
        .key = "SpaceMouse",
        .label = "SpaceMouse",
        .senses = {"x", "y", "z", "rx", "ry", "rz", "buttons"},
        .list = [](const DeviceSite& site) { return listHid(site, isSpaceMouse); },
        .open = [](const DeviceSite& site) -> std::unique_ptr<HapticDevice> {
            return std::make_unique<SpaceMouse>(site.hid(), site.start);
        }};
    return driver;
}

}  // namespace asperity
