#pragma once

#include "core/Vector.h"
#include "core/surface/BSplineSurface.h"
#include "core/surface/HeightMap.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace asperity {

/// Radius of the tip where a work does not name another [m].
inline constexpr double kBenchTipRadius = 20e-9;

/// Queries to be answered one after another on one surface.
struct SearchWork {
    std::string name;
    const BSplineSurface* surface = nullptr;
    std::vector<Vector3> centers;  ///< of the tip's sphere, world [m]
};

/// A slightly rough sample with particles and terraces: 512 x 512 pixels of 4 nm. Plain Newton errs
/// on 7 % of a sliding tip's queries and the bounds of the curvature settle 84 %, about as on the
/// path that the project's targets were set on (9 %, 81 %).
[[nodiscard]] HeightMap pathMap();

/// The same with roughness down to four pixels: hardly any answer is settled by its bounds.
[[nodiscard]] HeightMap roughMap();

/// Pits about as sharp as the tip and grooves that are sharper: 512 x 512 pixels of 4 nm.
[[nodiscard]] HeightMap concaveMap();

/// Self-affine roughness alone, of this rms height [m], whose shortest waves are those of
/// pathMap(): 512 x 512 pixels of 4 nm.
[[nodiscard]] HeightMap selfAffineGround(double rms);

/// The map, whose pixels are all valid, repeated `times` x `times`.
/// @tparam Map HeightMap or ScanMap
template <class Map>
[[nodiscard]] Map tiled(const Map& map, int times) {
    Map large = map;
    large.columns = map.columns * times;
    large.rows = map.rows * times;
    large.heights.resize(large.index(large.rows, 0));
    for (int row = 0; row < large.rows; ++row) {
        for (int column = 0; column < large.columns; ++column) {
            large.heights[large.index(row, column)] =
                map.heights[map.index(row % map.rows, column % map.columns)];
        }
    }
    return large;
}

/// A tip that slides within a square of 2048 nm.
struct Slide {
    std::size_t steps = 0;               ///< of 0.1 nm
    Vector2 corner = Vector2::Zero();    ///< of the square, world x, y [m]
    double tipRadius = kBenchTipRadius;  ///< [m]
    /// The height at which the tip touches is searched for at every few steps, and straight
    /// between them: that search takes time in proportion to the area under the tip.
    std::size_t stepsPerTouch = 1;
};

/// Centers of the tip along the slide, its gap swinging from 1 nm of indentation to 3 nm.
[[nodiscard]] std::vector<Vector3> slidingTip(const BSplineSurface& surface, const Slide& slide);

/// Tips anywhere over the scan: every other one near the height at which it touches, from 2 nm
/// below to a radius above, the others from a radius below to three above the surface under them.
[[nodiscard]] std::vector<Vector3> randomTips(const BSplineSurface& surface, std::size_t count,
                                              std::uint64_t seed);

}  // namespace asperity
