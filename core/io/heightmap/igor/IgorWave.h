#pragma once

#include "core/Error.h"
#include "core/io/ByteSource.h"
#include "core/io/heightmap/SampleRows.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace asperity {

/// A wave of an Igor binary file of version 5, without its numbers. Dimension 0 runs fastest.
struct IgorWave {
    static constexpr std::size_t kDimensions = 4;

    std::string name;
    SampleType type = SampleType::Float32;
    ByteOrder order = ByteOrder::Little;
    std::array<std::int32_t, kDimensions> counts{};  ///< 0 from the first unused dimension on
    std::array<double, kDimensions> steps{};         ///< in the dimension's unit
    std::array<double, kDimensions> starts{};        ///< in the dimension's unit
    std::string unit;                                ///< of the numbers, as it is written
    std::array<std::string, kDimensions> dimensionUnits;
    /// Of each dimension: the label of the dimension itself, then those of its elements.
    std::array<std::vector<std::string>, kDimensions> labels;
    std::string note;         ///< as it is stored
    std::uint64_t place = 0;  ///< of the first number [bytes]
    /// Why the file is truncated, with or behind the numbers; what it lost is empty here.
    std::optional<InputError> cut;
    std::string footer;  ///< end of what follows the wave, at most 1 KiB; Asylum's has a text
};

/// Whether a file starts as an Igor binary wave of any version, damaged or not.
[[nodiscard]] bool startsAsIgorWave(const ByteSource& bytes);

/// @throw InputError when the wave has one dimension, texts or complex numbers, or anything does
/// not
///        fit together
[[nodiscard]] IgorWave readIgorWave(const ByteSource& bytes);

}  // namespace asperity
