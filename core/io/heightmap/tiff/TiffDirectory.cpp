#include "core/io/heightmap/tiff/TiffDirectory.h"

#include "core/Error.h"
#include "core/io/TextValue.h"
#include "core/io/heightmap/tiff/TiffValue.h"

#include <algorithm>
#include <utility>

namespace asperity {

namespace {

constexpr std::uint64_t kTiffMaxText = 65536;
/// Of a tag: as many as an image of the largest side has tiles of 64 x 64 pixels. The file may hold
/// a byte for each, the memory 32.
constexpr std::uint64_t kMaxNumbers = std::uint64_t{1} << 20U;

}  // namespace

TiffDirectory::TiffDirectory(const ByteSource& bytes, ByteOrder order, std::uint64_t place,
                             std::size_t number, std::vector<TiffField> fields)
    : bytes_(&bytes)
    , order_(order)
    , place_(place)
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
    const std::string stored = bytesOf(*bytes_, {field->place, sizeOfTiffType(field->type)});
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
    const std::string stored = bytesOf(*bytes_, {field->place, field->count * size});
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
    const std::string stored = bytesOf(*bytes_, {field->place, sizeOfTiffType(field->type)});
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
        bytesOf(*bytes_, {field->place, std::min(field->count, kTiffMaxText)});
    return toUtf8(std::string_view(stored).substr(0, stored.find('\0')));
}

ByteSpan TiffDirectory::requireSpan(std::uint16_t tag) const {
    const TiffField* const field = find(tag);
    if (field == nullptr) {
        failAt(tag, "a value");
    }
    return {field->place, field->count * sizeOfTiffType(field->type)};
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

}  // namespace asperity
