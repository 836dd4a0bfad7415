#pragma once

#include "core/Vector.h"
#include "core/surface/BSplineSurface.h"
#include "core/surface/HeightMap.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace asperity {

/// Radius of the tip in every work [m].
inline constexpr double kBenchTipRadius = 20e-9;

/// Queries to be answered one after another on one surface.
struct SearchWork {
    std::string name;
    const BSplineSurface* surface = nullptr;
    std::vector<Vector3> centers;  ///< of the tip's sphere, world [m]
};

/// Slightly rough ground with particles and terraces: 512 x 512 pixels of 4 nm. Plain Newton errs
/// on 7 % of a sliding tip's queries and the bounds of the curvature settle 84 %, about as on the
/// path that the project's targets were set on (9 %, 81 %).
[[nodiscard]] HeightMap pathMap();

/// The same with roughness down to four pixels: hardly any answer is settled by its bounds.
[[nodiscard]] HeightMap roughMap();

/// Pits about as sharp as the tip and grooves that are sharper: 512 x 512 pixels of 4 nm.
[[nodiscard]] HeightMap concaveMap();

/// The map repeated `times` x `times`.
[[nodiscard]] HeightMap tiled(const HeightMap& map, int times);

/// A tip that slides over the surface in steps of 0.1 nm, its gap swinging from 1 nm of indentation
/// to 3 nm, from `corner` on (world x, y [m]) within a square of 2048 nm.
[[nodiscard]] std::vector<Vector3> slidingTip(const BSplineSurface& surface, std::size_t steps,
                                              const Vector2& corner);

/// Tips anywhere over the scan: every other one near the height at which it touches, from 2 nm
/// below to a radius above, the others from a radius below to three above the surface under them.
[[nodiscard]] std::vector<Vector3> randomTips(const BSplineSurface& surface, std::size_t count,
                                              std::uint64_t seed);

}  // namespace asperity
