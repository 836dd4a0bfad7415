#pragma once

#include "core/scene/SceneDescription.h"
#include "core/surface/fit/GaussianFilter.h"

namespace asperity {

/// The low-pass of a description on a map, or a grid, of this pitch.
template <class Map>
[[nodiscard]] Smoothing smoothingOf(const SampleDescription& sample, const Map& map) {
    if (sample.smoothingLength != 0.0) {
        return smoothingByLength(sample.smoothingLength, map);
    }
    return {.x = sample.smoothingPixels, .y = sample.smoothingPixels};
}

}  // namespace asperity
