#pragma once

#include "core/io/heightmap/HeightMapFile.h"

#include <string_view>

namespace asperity {

/// Whether the channel shows the height of the sample: a length, and not a deflection, an amplitude
/// or a phase, which some instruments give as lengths too.
[[nodiscard]] bool isTopography(const ScanChannel& channel);

/// Whether it may show that: its values are numbers without unit, and its name does not say that
/// they are something else.
[[nodiscard]] bool mayBeTopography(const ScanChannel& channel);

/// Index of the channel that a lab user expects: the height sensor, else the piezo height, else the
/// first other length, else, by the same names, one that may be a height, masks last; of equals,
/// the vendor's first. 0 when there is none of them.
/// @param usualDirection of equals, those of this direction first; empty: there is none
[[nodiscard]] std::size_t suggestDefaultChannel(const std::vector<ScanChannel>& channels,
                                                std::string_view usualDirection = {});

}  // namespace asperity
