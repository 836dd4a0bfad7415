#pragma once

#include "core/io/heightmap/nanosurf/NanosurfHeader.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace asperity {

/// A channel of a Nanosurf file whose lines are curves or spectra.
struct NanosurfLines {
    const HeaderFields* section = nullptr;  ///< lives as long as the header
    std::string frame;                      ///< "Spec forward", "Spectrum FFT"
    std::string name;                       ///< "Deflection"
    SampleType type = SampleType::Int32;
    std::size_t points = 0;  ///< of the longest line
    std::size_t lines = 0;
    std::uint64_t offset = 0;  ///< of the first sample [bytes]
};

/// All channels of the file that hold no image, in their order.
/// @throw InputError where a section or its samples are missing
[[nodiscard]] std::vector<NanosurfLines> nanosurfLines(const NanosurfHeader& header,
                                                       const ByteSource& bytes);

/// Values of a line in SI units, those that the file marks as valid.
/// @param line below channel.lines @throw InputError where its scale is missing
[[nodiscard]] std::vector<double> nanosurfLine(const ByteSource& bytes,
                                               const NanosurfLines& channel, std::size_t line);

/// Positions of the points along a line, by Dim0Min and Dim0Range [SI unit].
[[nodiscard]] std::vector<double> nanosurfAxis(const NanosurfLines& channel, std::size_t points);

/// Returns whether a frame is that of an image.
[[nodiscard]] bool isNanosurfScan(const HeaderFields& section);

}  // namespace asperity
