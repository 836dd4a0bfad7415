#pragma once

#include "core/io/ByteReader.h"
#include "core/io/heightmap/SampleRows.h"

#include <cstdint>
#include <optional>

namespace asperity {

/// Values of the fields of a TIFF directory. Source: TIFF revision 6.0, section 2;
/// docs/formats.md 9.

/// Of a value of this type [bytes]; 0: there is no such type.
[[nodiscard]] std::uint64_t sizeOfTiffType(std::uint16_t type);

/// A number in the file's byte order. @param stored sizeof(Number) bytes
template <typename Number>
[[nodiscard]] Number orderedNumber(const char* stored, ByteOrder order) {
    return order == ByteOrder::Little ? littleEndian<Number>(stored) : bigEndian<Number>(stored);
}

/// A value of a type of whole numbers; empty for any other type.
[[nodiscard]] std::optional<std::int64_t> wholeTiffValue(std::uint16_t type, const char* stored,
                                                         ByteOrder order);

/// A value of a type of any numbers, a fraction as its quotient; empty for any other type.
[[nodiscard]] std::optional<double> tiffNumber(std::uint16_t type, const char* stored,
                                               ByteOrder order);

}  // namespace asperity
