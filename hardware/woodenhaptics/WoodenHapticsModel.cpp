#include "hardware/woodenhaptics/WoodenHapticsModel.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace asperity {

namespace {

using Word = std::int16_t;

constexpr std::size_t kEncoderD = 3;  // index among the words of an input report
constexpr Word kButtonDown = 5000;    // above it, encoder d carries the button
constexpr Word kCommandSetEncoders = 1;
constexpr double kMilli = 1e-3;

/// Currents a b c, command, attributes 0 to 2.
using Words = std::array<Word, 7>;

constexpr std::size_t reportSize(WoodenHapticsBoard board) noexcept {
    return board == WoodenHapticsBoard::Teensy ? 64 : 14;
}

Word wordAt(std::span<const std::uint8_t> report, std::size_t index) noexcept {
    const auto low = static_cast<unsigned>(report[2 * index]);
    const auto high = static_cast<unsigned>(report[2 * index + 1]);
    return static_cast<Word>(low | (high << 8U));
}

Word milliampere(double current) noexcept {
    constexpr double kMax = std::numeric_limits<Word>::max();
    return static_cast<Word>(std::lround(std::clamp(current / kMilli, -kMax, kMax)));
}

WoodenHapticsMessage packed(WoodenHapticsBoard board, const Words& words) noexcept {
    WoodenHapticsMessage message{.size = 1 + reportSize(board)};
    std::size_t index = 1;
    for (const Word word : words) {
        const auto bits = static_cast<unsigned>(static_cast<std::uint16_t>(word));
        message.bytes[index++] = static_cast<std::uint8_t>(bits & 0xFFU);
        message.bytes[index++] = static_cast<std::uint8_t>(bits >> 8U);
    }
    return message;
}

}  // namespace

Vector3 jointAngles(const WoodenHapticsDescription& device, const EncoderCounts& counts) noexcept {
    Vector3 angles;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const double motor = 2.0 * std::numbers::pi * counts[i] / device.countsPerTurn;
        angles[static_cast<Eigen::Index>(i)] = motor * device.joints[i].reduction();
    }
    return angles;
}

Vector3 handlePosition(const WoodenHapticsDescription& device, const Vector3& angles) noexcept {
    const auto& [a, b, c] = device.joints;
    const double reach = b.length * std::sin(angles[1]) + c.length * std::sin(angles[2]);
    const double height =
        a.length + b.length * std::cos(angles[1]) - c.length * std::cos(angles[2]);
    return Vector3(std::cos(angles[0]) * reach, std::sin(angles[0]) * reach, height) -
           device.origin;
}

Vector3 jointTorques(const WoodenHapticsDescription& device, const Vector3& angles,
                     const Vector3& force) noexcept {
    const double lengthB = device.joints[1].length;
    const double lengthC = device.joints[2].length;
    const double reach = lengthB * std::sin(angles[1]) + lengthC * std::sin(angles[2]);
    const double outward = std::cos(angles[0]) * force.x() + std::sin(angles[0]) * force.y();
    const double sideways = std::cos(angles[0]) * force.y() - std::sin(angles[0]) * force.x();
    return {reach * sideways,
            lengthB * (std::cos(angles[1]) * outward - std::sin(angles[1]) * force.z()),
            lengthC * (std::cos(angles[2]) * outward + std::sin(angles[2]) * force.z())};
}

Vector3 motorCurrents(const WoodenHapticsDescription& device, const Vector3& torques) noexcept {
    if (!torques.allFinite()) {
        return Vector3::Zero();
    }
    const auto& [a, b, c] = device.joints;
    const Vector3 reductions(a.reduction(), b.reduction(), c.reduction());
    const Vector3 currents = torques.cwiseProduct(reductions) / device.motorConstant;
    const double largest = currents.cwiseAbs().maxCoeff();
    return largest > device.maxCurrent ? Vector3((device.maxCurrent / largest) * currents)
                                       : currents;
}

Vector3 inLabFrame(const Vector3& inDevice) noexcept {
    return {inDevice.y(), -inDevice.x(), inDevice.z()};
}

Vector3 inDeviceFrame(const Vector3& inLab) noexcept { return {-inLab.y(), inLab.x(), inLab.z()}; }

std::optional<WoodenHapticsBoard> woodenHapticsBoard(std::uint16_t vendorId,
                                                     std::uint16_t productId) {
    if (vendorId == 0x16c0 && productId == 0x0486) {
        return WoodenHapticsBoard::Teensy;
    }
    if (vendorId == 0x1234 && productId == 0x0006) {
        return WoodenHapticsBoard::Mbed;
    }
    return std::nullopt;
}

std::optional<WoodenHapticsReading> readingOf(WoodenHapticsBoard board,
                                              std::span<const std::uint8_t> report) noexcept {
    if (report.size() != reportSize(board)) {
        return std::nullopt;
    }
    return WoodenHapticsReading{.counts = {wordAt(report, 0), wordAt(report, 1), wordAt(report, 2)},
                                .button = wordAt(report, kEncoderD) > kButtonDown};
}

WoodenHapticsMessage currentsMessage(WoodenHapticsBoard board, const Vector3& currents) noexcept {
    return packed(board, {milliampere(currents.x()), milliampere(currents.y()),
                          milliampere(currents.z()), 0, 0, 0, 0});
}

WoodenHapticsMessage encodersMessage(WoodenHapticsBoard board,
                                     const EncoderCounts& counts) noexcept {
    return packed(board, {0, 0, 0, kCommandSetEncoders, counts[0], counts[1], counts[2]});
}

}  // namespace asperity
