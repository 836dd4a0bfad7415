#pragma once

#include "core/io/heightmap/HeaderFields.h"
#include "core/io/heightmap/SampleRows.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace asperity {

/// First bytes of a Nanosurf file.
inline constexpr std::string_view kNanosurfMagic = "[DataSet]";

/// Text sections of a Nanosurf file.
struct NanosurfHeader {
    HeaderSections sections;
    std::uint64_t end = 0;  ///< first byte of the samples
};

/// @throw InputError where it has no end, or was damaged by a transfer
[[nodiscard]] NanosurfHeader readNanosurfHeader(const ByteSource& bytes);

/// The sections of all channels that [DataSet] lists, in the order in which their samples are
/// stored. They live as long as `sections`. @throw InputError where one is missing
[[nodiscard]] std::vector<const HeaderFields*> nanosurfChannels(const HeaderSections& sections,
                                                                const std::string& file);

/// @throw InputError where the samples are of no known type
[[nodiscard]] SampleType nanosurfSampleType(const HeaderFields& section);

/// Meaning of a count of the samples.
struct NanosurfScale {
    double minimum = 0.0;  ///< value of the lowest count, in the unit of Dim2
    double perCount = 1.0;
    double lowestCount = 0.0;

    [[nodiscard]] double operator()(double count) const {
        return minimum + perCount * (count - lowestCount);
    }
};

/// @throw InputError where Dim2Min or Dim2Range is missing
[[nodiscard]] NanosurfScale nanosurfScale(const HeaderFields& section, SampleType type);

}  // namespace asperity
