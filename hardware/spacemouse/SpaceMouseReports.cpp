#include "hardware/spacemouse/SpaceMouseReports.h"

#include <algorithm>
#include <cstddef>

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

}  // namespace asperity
