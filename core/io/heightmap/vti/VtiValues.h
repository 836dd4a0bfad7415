#pragma once

#include "core/io/ByteReader.h"
#include "core/io/heightmap/SampleRows.h"

#include <cstdint>
#include <string>

namespace asperity {

enum class VtiCompressor : std::uint8_t { None, Zlib, Lz4, Lzma };

/// Coding of the binary values of a file.
struct VtiCoding {
    ByteOrder order = ByteOrder::Little;
    std::uint64_t countBytes = 4;  ///< of each number before the values
    VtiCompressor compressor = VtiCompressor::None;
};

enum class VtiForm : std::uint8_t { Raw, Base64, Text };

/// The values of an array as they are in the file.
struct VtiValues {
    VtiForm form = VtiForm::Raw;
    ByteSpan span;         ///< from their first byte on; they may end before its end
    std::string location;  ///< for messages
};

/// Returns the values as bytes in the order of the file: at most `most` of them. Numbers in text
/// become float64, the lowest byte first.
/// @throw InputError when they are damaged, or more
[[nodiscard]] std::string decodedVti(const ByteSource& bytes, const VtiCoding& coding,
                                     const VtiValues& values, std::uint64_t most);

/// Returns the number of that many bytes in this order.
[[nodiscard]] std::uint64_t vtiCount(const char* bytes, const VtiCoding& coding);

}  // namespace asperity
