#pragma once

#include "core/scene/Scene.h"
#include "core/surface/BSplineSurface.h"
#include "core/uncertainty/Relief.h"

namespace asperity {

/// A scan as its imaging tip recorded it, after the low-pass. What a tip records is the parallel
/// surface at its radius, seen from above. Source: docs/uncertainty.md 1.5.
class RecordedScan {
public:
    /// @param surface of the scan @param erodedBy radius of the tip that was taken out of it [m]
    explicit RecordedScan(const BSplineSurface& surface, double erodedBy = 0.0)
        : surface_(surface), erodedBy_(erodedBy) {}
    explicit RecordedScan(const Scene& scene);

    [[nodiscard]] const BSplineSurface::Grid& grid() const noexcept { return surface_.grid(); }
    /// Where the surface under it folds, the relief is that surface's own. @param x, y world [m]
    [[nodiscard]] Relief reliefAt(double x, double y) const noexcept;

private:
    BSplineSurface surface_;
    double erodedBy_;
};

/// Where the recorded scan shows a contact, world x, y [m].
struct RecordedPlaces {
    Vector2 shown;    ///< that of the scene
    Vector2 touched;  ///< that of the same tip on the surface without its imaging tip
};

/// Returns the places of a state. A tip on that surface touches where one whose radius is less by
/// the imaging tip's touches the recorded one: of a scan that was eroded both places are the same.
[[nodiscard]] RecordedPlaces recordedPlaces(const Scene& scene, const TipState& state) noexcept;

}  // namespace asperity
