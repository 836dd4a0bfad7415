#include "core/io/heightmap/tiff/TiffValue.h"

#include <array>

namespace asperity {

namespace {

/// Bytes of a value of each type, 0 where there is no such type.
constexpr std::array<std::uint8_t, 19> kTypeSizes = {0, 1, 1, 2, 4, 8, 1, 1, 2, 4,
                                                     8, 4, 8, 4, 0, 0, 8, 8, 8};
// Types of values.
constexpr std::uint16_t kByte = 1;
constexpr std::uint16_t kShort = 3;
constexpr std::uint16_t kLong = 4;
constexpr std::uint16_t kRational = 5;
constexpr std::uint16_t kSignedByte = 6;
constexpr std::uint16_t kSignedShort = 8;
constexpr std::uint16_t kSignedLong = 9;
constexpr std::uint16_t kSignedRational = 10;
constexpr std::uint16_t kFloat = 11;
constexpr std::uint16_t kDouble = 12;
constexpr std::uint16_t kDirectory = 13;
constexpr std::uint16_t kLong8 = 16;
constexpr std::uint16_t kSignedLong8 = 17;
constexpr std::uint16_t kDirectory8 = 18;

}  // namespace

std::uint64_t sizeOfTiffType(std::uint16_t type) {
    return type < kTypeSizes.size() ? kTypeSizes[type] : 0;
}

std::optional<std::int64_t> wholeTiffValue(std::uint16_t type, const char* stored,
                                           ByteOrder order) {
    switch (type) {
    case kByte:
        return orderedNumber<std::uint8_t>(stored, order);
    case kSignedByte:
        return orderedNumber<std::int8_t>(stored, order);
    case kShort:
        return orderedNumber<std::uint16_t>(stored, order);
    case kSignedShort:
        return orderedNumber<std::int16_t>(stored, order);
    case kLong:
    case kDirectory:
        return orderedNumber<std::uint32_t>(stored, order);
    case kSignedLong:
        return orderedNumber<std::int32_t>(stored, order);
    case kLong8:
    case kSignedLong8:
    case kDirectory8:
        return orderedNumber<std::int64_t>(stored, order);
    default:
        return std::nullopt;
    }
}

std::optional<double> tiffNumber(std::uint16_t type, const char* stored, ByteOrder order) {
    const char* const second = stored + sizeof(std::uint32_t);
    switch (type) {
    case kRational:
        return static_cast<double>(orderedNumber<std::uint32_t>(stored, order)) /
               orderedNumber<std::uint32_t>(second, order);
    case kSignedRational:
        return static_cast<double>(orderedNumber<std::int32_t>(stored, order)) /
               orderedNumber<std::int32_t>(second, order);
    case kFloat:
        return orderedNumber<float>(stored, order);
    case kDouble:
        return orderedNumber<double>(stored, order);
    default:
        const std::optional<std::int64_t> whole = wholeTiffValue(type, stored, order);
        return whole ? std::optional(static_cast<double>(*whole)) : std::nullopt;
    }
}

}  // namespace asperity
