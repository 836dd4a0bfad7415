#include "core/io/heightmap/tiff/TiffDirectory.h"

#include "core/Error.h"
#include "core/io/TextValue.h"

#include <algorithm>
#include <array>
#include <utility>

namespace asperity {

namespace {

constexpr std::uint64_t kTiffMaxText = 65536;
/// Limit of a tag: as many as an image of the largest side has tiles of 64 x 64 pixels. The file
/// may hold a byte for each, the memory 32.
constexpr std::uint64_t kMaxNumbers = std::uint64_t{1} << 20U;

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

TiffDirectory::TiffDirectory(const ByteSource& bytes, ByteOrder order, std::uint64_t offset,
                             std::size_t number, std::vector<TiffField> fields)
    : bytes_(&bytes)
    , order_(order)
    , offset_(offset)
    , name_("image " + std::to_string(number))
    , fields_(std::move(fields)) {
    // Stable: of two equal tags, the first counts.
    std::ranges::stable_sort(fields_, {}, &TiffField::tag);
}

std::optional<std::int64_t> TiffDirectory::integer(std::uint16_t tag) const {
    const TiffField* const field = find(tag);
    if (field == nullptr) {
        return std::nullopt;
    }
    const std::string stored = bytesOf(*bytes_, {field->offset, sizeOfTiffType(field->type)});
    const std::optional<std::int64_t> value = wholeTiffValue(field->type, stored.data(), order_);
    if (!value) {
        failAt(tag, "a whole number");
    }
    return value;
}

std::int64_t TiffDirectory::requireInteger(std::uint16_t tag) const {
    const std::optional<std::int64_t> value = integer(tag);
    if (!value) {
        failAt(tag, "a whole number");
    }
    return *value;
}

std::vector<std::uint64_t> TiffDirectory::wholeNumbers(std::uint16_t tag) const {
    const TiffField* const field = find(tag);
    if (field == nullptr) {
        return {};
    }
    if (field->count > kMaxNumbers) {
        failAt(tag, "at most " + std::to_string(kMaxNumbers) + " numbers");
    }
    const std::uint64_t size = sizeOfTiffType(field->type);
    const std::string stored = bytesOf(*bytes_, {field->offset, field->count * size});
    std::vector<std::uint64_t> values;
    values.reserve(field->count);
    for (std::uint64_t i = 0; i < field->count; ++i) {
        const std::optional<std::int64_t> value =
            wholeTiffValue(field->type, stored.data() + i * size, order_);
        if (!value || *value < 0) {
            failAt(tag, "whole numbers of 0 or more");
        }
        values.push_back(static_cast<std::uint64_t>(*value));
    }
    return values;
}

std::optional<double> TiffDirectory::number(std::uint16_t tag) const {
    const TiffField* const field = find(tag);
    if (field == nullptr) {
        return std::nullopt;
    }
    const std::string stored = bytesOf(*bytes_, {field->offset, sizeOfTiffType(field->type)});
    const std::optional<double> value = tiffNumber(field->type, stored.data(), order_);
    if (!value) {
        failAt(tag, "a number");
    }
    return value;
}

std::string TiffDirectory::text(std::uint16_t tag) const {
    const TiffField* const field = find(tag);
    if (field == nullptr || sizeOfTiffType(field->type) != 1) {
        return {};
    }
    const std::string stored =
        bytesOf(*bytes_, {field->offset, std::min(field->count, kTiffMaxText)});
    return toUtf8(std::string_view(stored).substr(0, stored.find('\0')));
}

ByteSpan TiffDirectory::requireSpan(std::uint16_t tag) const {
    const TiffField* const field = find(tag);
    if (field == nullptr) {
        failAt(tag, "a value");
    }
    return {field->offset, field->count * sizeOfTiffType(field->type)};
}

void TiffDirectory::fail(const std::string& what) const {
    throw InputError(bytes_->name(), name_, what);
}

const TiffField* TiffDirectory::find(std::uint16_t tag) const {
    const auto found = std::ranges::lower_bound(fields_, tag, {}, &TiffField::tag);
    return found != fields_.end() && found->tag == tag && found->count > 0 ? &*found : nullptr;
}

void TiffDirectory::failAt(std::uint16_t tag, const std::string& expected) const {
    fail("tag " + std::to_string(tag) + ": expected " + expected);
}

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
