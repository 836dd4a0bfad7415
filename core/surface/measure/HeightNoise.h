#pragma once

#include "core/surface/HeightMap.h"

namespace asperity {

/// Standard deviation of the white noise in a scan's heights [m], from its highest frequencies: the
/// median of fourth differences along both axes, which leave of a smooth surface next to nothing
/// and of a step a few pixels. Noise that a feedback loop has filtered is larger than this. 0 where
/// the scan has fewer than 5 pixels along an axis, or no 5 x 5 pixels that all hold data. Of a
/// large scan some 65,000 places count.
/// Source: Immerkaer, Computer Vision and Image Understanding 64 (1996) 300, with a higher order
/// and the median; docs/uncertainty.md.
[[nodiscard]] double heightNoise(const HeightMap& map);
[[nodiscard]] double heightNoise(const ScanMap& map);

}  // namespace asperity
