#include "core/probe/BodyAttraction.h"

#include "core/contact/laws/VanDerWaals.h"
#include "core/probe/ProbeSystem.h"
#include "core/probe/TipEquilibrium.h"
#include "core/surface/BSplineSurface.h"
#include "core/surface/TangentFrame.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity {

namespace {

/// The sample around a contact point, as it is and as the contact's law has it.
class SampleBeside {
public:
    /// @param curved whether the law takes the curvature at the contact point
    SampleBeside(const BSplineSurface& surface, const ClosestPoint& place, bool curved) noexcept
        : surface_(surface)
        , frame_(tangentFrame(place.point, place.normal))
        , middle_(surface.at(place.point.x(), place.point.y()))
        , curved_(curved) {}

    [[nodiscard]] Vector3 stepAt(double radius, double angle) const noexcept {
        return radius * (std::cos(angle) * frame_.along + std::sin(angle) * frame_.across);
    }
    /// Height over the tangent plane along the normal [m]; beyond the scan that of its edge.
    [[nodiscard]] double height(const Vector3& step) const noexcept {
        const double x = std::clamp(frame_.origin.x() + step.x(), 0.0, surface_.sizeX());
        const double y = std::clamp(frame_.origin.y() + step.y(), 0.0, surface_.sizeY());
        return (Vector3(x, y, surface_.at(x, y).height) - frame_.origin).dot(frame_.normal);
    }
    /// The same of the law's paraboloid.
    [[nodiscard]] double heightOfLaw(const Vector3& step) const noexcept {
        const double bend = (middle_.dxx * step.x() * step.x()) +
                            (2.0 * middle_.dxy * step.x() * step.y()) +
                            (middle_.dyy * step.y() * step.y());
        return curved_ ? 0.5 * bend * frame_.normal.z() : 0.0;
    }

private:
    const BSplineSurface& surface_;
    TangentFrame frame_;
    HeightSample middle_;
    bool curved_;
};

}  // namespace

BodyAttraction bodyAttraction(const BSplineSurface& surface, const ProbeSystem& system,
                              const TipState& state) noexcept {
    constexpr double kFlattest = 0.1;  // of the cap's gap: as effectiveRadius() has it in a valley
    constexpr double kPixels = 0.25;   // between look-ups near the contact
    constexpr double kDistances = 0.02;  // and farther out
    const double tipRadius = system.tipRadius();
    const ContactPair pair = system.pairAt(state.closest.point, state.effectiveRadius);
    if (pair.workOfAdhesion < kMinAdhesion) {
        return {};
    }
    const double joint = kContactSeparation + system.contact.cohesiveRange();
    const double touch = kContactSeparation - state.contact.indentation;
    const auto traction = [cohesive = joint * joint * joint](double separation) {
        const double apart = std::max(separation, 0.0);
        const double cube = apart * apart * apart;
        return cube / ((cube + cohesive) * (cube + cohesive));
    };
    const SampleBeside sample(surface, state.closest,
                              system.curvature && !isSphere(system.contact.law()));
    double sum = 0.0;
    double inner = 0.0;
    while (inner < tipRadius) {
        const double width = std::max(kPixels * surface.finestPitch(), kDistances * inner);
        const double outer = std::min(inner + width, tipRadius);
        const double radius = 0.5 * (inner + outer);
        const double square = radius * radius;
        const double cap = square / (tipRadius + std::sqrt((tipRadius * tipRadius) - square));
        const double around = 2.0 * std::numbers::pi * radius / width;
        const int directions = std::max(8, static_cast<int>(std::ceil(around)));
        double ring = 0.0;
        for (int i = 0; i < directions; ++i) {
            const Vector3 step = sample.stepAt(radius, 2.0 * std::numbers::pi * i / directions);
            ring += traction(touch + cap - sample.height(step)) -
                    traction(touch + std::max(cap - sample.heightOfLaw(step), kFlattest * cap));
        }
        sum += ring / directions * (outer * outer - inner * inner);
        inner = outer;
    }
    // pi times the sum is the integral over the area, H / (6 pi) the traction's factor.
    const double force = -hamakerConstant(pair.workOfAdhesion) / 6.0 * sum;
    return {.force = force,
            .share = force / (1.5 * std::numbers::pi * pair.workOfAdhesion * pair.tipRadius)};
}

}  // namespace asperity
