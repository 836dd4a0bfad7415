#pragma once

#include "core/map/PixelCycle.h"

namespace asperity::test {

inline constexpr double kSetpoint = 5e-9;  ///< of maps and cycles [N]

/// The cycle of a map's pixel, by the model or by the truth.
inline MapValues cycleOn(const Scene& scene, const Vector2& place, bool truth = false) {
    return pixelCycle(MapInstrument(scene, truth), place, kSetpoint);
}

}  // namespace asperity::test
