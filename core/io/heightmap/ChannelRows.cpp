#include "core/io/heightmap/ChannelRows.h"

#include "core/Error.h"

#include <bit>
#include <cmath>
#include <cstdio>
#include <limits>

namespace asperity {

namespace {

constexpr double kMaxHeight = 1e3;   // of a height [m]
constexpr double kMaxWidth = 1e3;    // of an image [m]
constexpr double kMinPixel = 1e-15;  // [m]
constexpr double kMinFloat = std::numeric_limits<float>::min();

/// Facts from the bits of a row's values, without a comparison that raises a flag, and without a
/// branch: the order of the bits is that of the magnitudes, and what is larger than a limit carries
/// into the sign.
struct RowBits {
    bool allWithin = false;  ///< all are numbers up to the limit
    bool hasSize = false;    ///< one is at least kMin; only where all are within
};

/// Turns stored numbers into values and looks at them, in one pass.
RowBits scale(double* values, int count, double factor, double limit) {
    constexpr std::uint64_t kMagnitude = 0x7fffffffffffffffU;
    constexpr std::uint64_t kRoomBelowMin =
        kMagnitude + 1U - std::bit_cast<std::uint64_t>(kMinFloat);
    const std::uint64_t room = kMagnitude - std::bit_cast<std::uint64_t>(limit);
    std::uint64_t beyond = 0;
    std::uint64_t sized = 0;
    for (int i = 0; i < count; ++i) {
        values[i] *= factor;
        const std::uint64_t magnitude = std::bit_cast<std::uint64_t>(values[i]) & kMagnitude;
        beyond |= magnitude + room;
        sized |= magnitude + kRoomBelowMin;
    }
    return {.allWithin = beyond <= kMagnitude, .hasSize = sized > kMagnitude};
}

/// Returns whether a value is a number or infinite, and larger than its limit.
bool isBeyond(double value, double limit) {
    constexpr std::uint64_t kMagnitude = 0x7fffffffffffffffU;
    constexpr auto kInfinite =
        std::bit_cast<std::uint64_t>(std::numeric_limits<double>::infinity());
    const std::uint64_t magnitude = std::bit_cast<std::uint64_t>(value) & kMagnitude;
    return magnitude > std::bit_cast<std::uint64_t>(limit) && magnitude <= kInfinite;
}

void set(std::atomic<bool>& flag) {
    if (!flag.load(std::memory_order_relaxed)) {
        flag.store(true, std::memory_order_relaxed);
    }
}

std::string text(double value) {
    char digits[32];
    std::snprintf(digits, sizeof digits, "%.3g", value);
    return digits;
}

/// The reason where a value is beyond what it can be.
constexpr const char* kCause = ". The file is damaged, or its unit or scale is wrong";

}  // namespace

ChannelRows::ChannelRows(const StoredChannel& stored, const ByteSource& bytes)
    : stored_(stored)
    , bytes_(bytes)
    , limit_(stored.channel.isHeight() ? kMaxHeight
                                       : static_cast<double>(std::numeric_limits<float>::max())) {
    requireScale();
}

void ChannelRows::requireScale() const {
    const ScanChannel& channel = stored_.channel;
    const std::string location = "channel '" + channel.name + "'";
    if (!std::isfinite(stored_.factor)) {
        throw InputError(bytes_.name(), location, "the scale of its values is no finite number");
    }
    if (!channel.hasSize()) {
        return;
    }
    const double widest = std::max(channel.map.sizeX(), channel.map.sizeY());
    const double narrowest = std::min(channel.map.pitchX, channel.map.pitchY);
    if (!(widest <= kMaxWidth && narrowest >= kMinPixel)) {
        throw InputError(bytes_.name(), location,
                         "a scan of " + text(channel.map.sizeX()) + " m x " +
                             text(channel.map.sizeY()) +
                             " m; pixels of 1 fm or more and at most 1 km in all are expected");
    }
}

bool ChannelRows::read(int row, RowRoom& room, double* values) {
    const int columns = stored_.channel.map.columns;
    stored_.readRow(row, room, values);
    const RowBits bits = scale(values, columns, stored_.factor, limit_);
    if (bits.allWithin) {
        if (bits.hasSize) {
            set(hasSize_);
        }
        return false;
    }
    set(mayHaveHoles_);
    // No finite number becomes NaN by its factor: such values hold no data whatever is stored.
    if (std::any_of(values, values + columns,
                    [this](double value) { return isBeyond(value, limit_); })) {
        std::vector<double> numbers(static_cast<std::size_t>(columns));
        stored_.readRow(row, room, numbers.data());
        requireWithin(row, values, numbers.data());
    }
    const auto isSized = [](double value) {
        return isFiniteHeight(value) && std::abs(value) >= kMinFloat;
    };
    if (std::any_of(values, values + columns, isSized)) {
        set(hasSize_);
    }
    return true;
}

/// @param numbers as they are stored: a finite one may have become infinite by its factor
void ChannelRows::requireWithin(int row, const double* values, const double* numbers) const {
    const ScanChannel& channel = stored_.channel;
    for (int column = 0; column < channel.map.columns; ++column) {
        const bool holdsData = isFiniteHeight(numbers[column]);
        const bool within = isFiniteHeight(values[column]) && std::abs(values[column]) <= limit_;
        if (holdsData && !within) {
            refusePixel(row, column,
                        "is " + text(values[column]) + (channel.unit.empty() ? "" : " ") +
                            channel.unit +
                            (channel.isHeight() ? "; heights within 1 km of zero are expected"
                                                : "; that is beyond single precision") +
                            kCause);
        }
    }
}

void ChannelRows::finish() const {
    if (stored_.channel.isHeight() && !hasSize_) {
        requireNotLost();
    }
    bytes_.requireUnchanged();
}

/// A map that is 0 everywhere is one; so is one of noise far below any atom beside real heights.
void ChannelRows::requireNotLost() const {
    const HeightMap& map = stored_.channel.map;
    RowRoom room;
    std::vector<double> numbers(static_cast<std::size_t>(map.columns));
    for (int row = 0; row < map.rows; ++row) {
        stored_.readRow(row, room, numbers.data());
        for (int column = 0; column < map.columns; ++column) {
            const double number = numbers[static_cast<std::size_t>(column)];
            if (isFiniteHeight(number) && number != 0.0) {
                refusePixel(
                    row, column,
                    "is stored as " + text(number) + " with a scale of " + text(stored_.factor) +
                        " m, and every height of the scan is zero in single precision" + kCause);
            }
        }
    }
}

void ChannelRows::refusePixel(int row, int column, const std::string& what) const {
    throw InputError(bytes_.name(), "channel '" + stored_.channel.name + "'",
                     "the pixel in column " + std::to_string(stored_.firstColumn + column) +
                         ", row " + std::to_string(stored_.firstRow + row) +
                         " (from 0 at the upper left) " + what);
}

}  // namespace asperity
