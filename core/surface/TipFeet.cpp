#include "core/surface/TipFeet.h"

namespace asperity {

namespace {

constexpr double kRingRadius = 0.6;   // of the radius: where searches start
constexpr double kDiagonal = 0.7071;  // sin and cos of an eighth of a turn

/// Eight starts around the tip: each leads to the minimum of its own slope.
void addFeetAround(const BSplineSurface& surface, const TipSphere& tip, double reach,
                   TipFeet& feet) {
    constexpr std::array<std::array<double, 2>, 8> kDirections{{{1.0, 0.0},
                                                                {kDiagonal, kDiagonal},
                                                                {0.0, 1.0},
                                                                {-kDiagonal, kDiagonal},
                                                                {-1.0, 0.0},
                                                                {-kDiagonal, -kDiagonal},
                                                                {0.0, -1.0},
                                                                {kDiagonal, -kDiagonal}}};
    for (const auto& [along, across] : kDirections) {
        const FootGuess start{tip.centre.x() + kRingRadius * tip.radius * along,
                              tip.centre.y() + kRingRadius * tip.radius * across, true};
        const SurfaceFoot foot = closestPoint(surface, tip.centre, start);
        if (foot.converged && foot.distance < tip.radius + reach) {
            feet.add(foot, kSameFoot * tip.radius);
        }
    }
}

}  // namespace

void TipFeet::add(const SurfaceFoot& foot, double sameWithin) noexcept {
    for (std::size_t i = 0; i < count_; ++i) {
        if ((feet_[i].point - foot.point).norm() <= sameWithin) {
            return;
        }
    }
    if (count_ < feet_.size()) {
        feet_[count_++] = foot;
    }
}

TipFeet tipFeet(const BSplineSurface& surface, const TipSphere& tip, double reach,
                std::span<const FootGuess> known) noexcept {
    TipFeet feet;
    for (const FootGuess& guess : known) {
        feet.add(closestPoint(surface, tip.centre, guess), kSameFoot * tip.radius);
    }
    if (known.empty()) {
        feet.add(closestPoint(surface, tip.centre, {}), 0.0);
    }
    const bool near = feet.all().front().distance < tip.radius + reach;
    if (near && surface.concavityBound() * tip.radius > 1.0) {
        addFeetAround(surface, tip, reach, feet);
    }
    return feet;
}

}  // namespace asperity
