#pragma once

#include "core/map/PixelCycle.h"

namespace asperity::test {

inline constexpr double kSetpoint = 5e-9;  ///< of maps and cycles [N]

/// The cycle of a map's pixel, by the model or by the truth.
inline MapValues cycleOn(const Scene& scene, const Vector2& position, bool truth = false) {
    return pixelCycle(MapInstrument(scene, truth), position, kSetpoint);
}

}  // namespace asperity::test
