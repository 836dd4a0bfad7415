#include "hardware/woodenhaptics/WoodenHapticsReports.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity {

namespace {

using Word = std::int16_t;

constexpr std::size_t kEncoderD = 3;  // place among the words of an input report
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
    std::size_t place = 1;
    for (const Word word : words) {
        const auto bits = static_cast<unsigned>(static_cast<std::uint16_t>(word));
        message.bytes[place++] = static_cast<std::uint8_t>(bits & 0xFFU);
        message.bytes[place++] = static_cast<std::uint8_t>(bits >> 8U);
    }
    return message;
}

}  // namespace

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
