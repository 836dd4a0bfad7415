#include "ui/view/ViewScale.h"

#include "core/contact/laws/ForceCurve.h"
#include "core/scene/Scene.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity {

namespace {

/// A width in tip radii, but at least so many contact radii.
struct Width {
    double ofTip;
    double ofContact;

    [[nodiscard]] double of(double tip, double contact) const {
        return std::max(ofTip * tip, ofContact * contact);
    }
};

constexpr Width kPatchWidth = {.ofTip = 2.0, .ofContact = 2.5};
constexpr Width kUsualWidth = {.ofTip = 2.4, .ofContact = 3.2};
constexpr double kUsualPixels = 15.0;  // at least, in half the width of the frame: a real shape
constexpr double kWideContact = 0.35;  // in tip radii: beyond, sphere and paraboloid part visibly
constexpr double kParaboloidReach = 1.5;                        // in contact radii
constexpr Width kMinWidth = {.ofTip = 1.25, .ofContact = 1.9};  // its patch still holds the contact

/// Source: Johnson, Kendall, Roberts (1971) [N].
double jkrPullOff(const ContactPair& pair) {
    return 1.5 * std::numbers::pi * pair.tipRadius * pair.workOfAdhesion;
}

/// Contact radius that views must have room for [m]: the unloaded one, on a cone also that at the
/// setpoint, which may press it far in. On a sphere no contact is wider than the tip.
double usualContactRadius(const Scene& scene) {
    const ContactModel& model = scene.belief.contact;
    const double paraboloid = unloadedContactRadius(model.pair());
    if (!isSphere(model.law())) {
        return paraboloid;
    }
    const double onSphere = std::min(paraboloid, scene.belief.tipRadius());
    if (model.coneHalfAngle() == 0.0) {
        return onSphere;
    }
    constexpr double kHeld = 0.0;  // compliance [m/N]
    const auto depth = basePositionAt(model, kHeld, scene.description.setpoint);
    return depth ? std::max(onSphere, model.equilibrium(*depth, kHeld, kBondedMemory).contactRadius)
                 : onSphere;
}

/// Of a flat sample, without its lever [m]; 0 where the law does not reach the setpoint.
double usualDent(const Scene& scene) {
    constexpr double kHeld = 0.0;  // compliance [m/N]
    return std::max(
        0.0, basePositionAt(scene.belief.contact, kHeld, scene.description.setpoint).value_or(0.0));
}

}  // namespace

ViewScale viewScale(const Scene& scene) {
    const double tip = scene.belief.tipRadius();
    const double contact = usualContactRadius(scene);
    const double paraboloid = unloadedContactRadius(scene.belief.contact.pair());
    const bool isWide = !isSphere(scene.belief.contact.law()) && paraboloid > kWideContact * tip;
    const BSplineSurface::Grid& grid = scene.surface.grid();
    const double pixel = std::max(grid.pitchX, grid.pitchY);
    const double given = scene.description.zoomHalfWidth;
    return {.patch = kPatchWidth.of(tip, contact),
            .usual =
                given > 0.0 ? given : std::max(kUsualWidth.of(tip, contact), kUsualPixels * pixel),
            .least = kMinWidth.of(tip, contact),
            .pixel = pixel,
            .paraboloidReach = isWide ? std::max(tip, kParaboloidReach * paraboloid) : 0.0,
            .dent = usualDent(scene),
            .force = std::max(scene.description.setpoint, jkrPullOff(scene.belief.contact.pair()))};
}

double unloadedContactRadius(const ContactPair& pair) {
    const double modulus = 4.0 / 3.0 * pair.reducedModulus;
    return std::cbrt(6.0 * std::numbers::pi * pair.workOfAdhesion * pair.tipRadius *
                     pair.tipRadius / modulus);
}

}  // namespace asperity
