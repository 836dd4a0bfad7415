#pragma once

#include "core/surface/ClosestPoint.h"

#include <array>
#include <cstddef>
#include <span>

namespace asperity {

/// More places than these do not touch a sphere at once on any real scan.
inline constexpr std::size_t kMostFeet = 4;

/// Two feet nearer to each other than this are one, in tip radii.
inline constexpr double kSameFoot = 0.02;

/// Feet of a sphere on a surface: in a valley that it does not fit there are several.
class TipFeet {
public:
    /// Takes a foot up unless it stands where another one does, or there is no more room.
    void add(const SurfaceFoot& foot, double sameWithin) noexcept;

    [[nodiscard]] std::span<const SurfaceFoot> all() const noexcept {
        return {feet_.data(), count_};
    }

private:
    std::array<SurfaceFoot, kMostFeet> feet_{};
    std::size_t count_ = 0;
};

/// The sphere that is looked at.
struct TipSphere {
    Vector3 centre = Vector3::Zero();  ///< world [m]
    double radius = 0.0;               ///< [m]
};

/// Local minima of the distance from the sphere's centre: those that `known` lead to, in their
/// order, and, where the surface has valleys sharper than the sphere, those found around it that
/// lie within `reach` of its surface. At least one. Allocation-free, bounded, never throws.
[[nodiscard]] TipFeet tipFeet(const BSplineSurface& surface, const TipSphere& tip, double reach,
                              std::span<const FootGuess> known) noexcept;

}  // namespace asperity
