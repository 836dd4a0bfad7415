#pragma once

#include "core/Error.h"
#include "core/io/ByteReader.h"
#include "core/io/heightmap/SampleRows.h"

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace asperity {

/// A wave of an Igor binary file of version 5 or 2, without its numbers. Dimension 0 runs fastest;
/// in version 2 there is no other one.
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
    /// Labels for each dimension: that of the dimension itself, then those of its elements.
    std::array<std::vector<std::string>, kDimensions> labels;
    std::string note;          ///< as it is stored
    std::uint64_t offset = 0;  ///< of the first number [bytes]
    /// Reason why the file is truncated, with or behind the numbers; what it lost is empty here.
    std::optional<InputError> cut;
    std::string footer;  ///< end of what follows the wave, at most 1 KiB; Asylum's has a text
};

/// Returns whether a file starts as an Igor binary wave of any version, damaged or not.
[[nodiscard]] bool startsAsIgorWave(const ByteSource& bytes);

/// @throw InputError when the wave holds texts or complex numbers, or anything does not fit
/// together
[[nodiscard]] IgorWave readIgorWave(const ByteSource& bytes);

/// Returns the entries in the note of an Asylum Research wave, by key.
/// @param note `key: value` lines that end with CR; of several with one key the first one counts
[[nodiscard]] std::map<std::string, std::string> parseAsylumNote(const std::string& note);

/// Returns whether a wave holds a force curve of Asylum Research, with a column for each signal.
[[nodiscard]] bool isAsylumCurve(const IgorWave& wave);

/// Returns whether a label names an image of an Asylum file: "HeightTrace", "PhaseRetraceMod1".
[[nodiscard]] bool isAsylumLabel(const std::string& label);

/// The unit of a channel, whose numbers are in SI units: what the note says ("UserIn0Unit"), else
/// by its name; empty when neither is known.
/// @param label "HeightTrace", "NapPhase2Retrace", "UserIn0TraceMod1"
[[nodiscard]] std::string asylumUnit(const std::string& label,
                                     const std::map<std::string, std::string>& note);

}  // namespace asperity
