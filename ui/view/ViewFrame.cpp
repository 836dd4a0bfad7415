#include "ui/view/ViewFrame.h"

#include "core/contact/ContactState.h"
#include "core/contact/laws/ForceCurve.h"
#include "core/scene/Scene.h"
#include "core/surface/Curvature.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity {

namespace {

/// Distance inside of its slack at which the position lies after a step, in half widths: each is at
/// least as long, so that there are few of them.
constexpr double kStep = 0.1;

double followed(double center, double position, double slack, double step) {
    const double offset = position - center;
    if (std::abs(offset) <= slack) {
        return center;
    }
    return position - std::copysign(slack - step, offset);
}

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
constexpr Width kSectionWidth = {.ofTip = 2.0, .ofContact = 2.0};
constexpr double kSectionContacts = 3.0;  // contact radii in half a section's width: dent and neck
constexpr double kMinSection = 0.02;      // of the tip
constexpr double kMinFrameShare = 1.0 / 3.0;  // of the scan, for a tip that would fill it
constexpr int kSearched = 128;                // positions along each side of the scan

/// Source: Johnson, Kendall, Roberts (1971) [N].
double jkrPullOff(const ContactPair& pair) {
    return 1.5 * std::numbers::pi * pair.tipRadius * pair.workOfAdhesion;
}

/// Returns the grid position that a paraboloid of this radius meets first as it comes down on the
/// middle of the scan.
HeightSample firstMet(const BSplineSurface& surface, double radius) {
    const Vector2 middle = 0.5 * Vector2(surface.sizeX(), surface.sizeY());
    HeightSample met = surface.at(middle.x(), middle.y());
    double highest = met.height;
    for (int row = 0; row < kSearched; ++row) {
        for (int column = 0; column < kSearched; ++column) {
            const Vector2 position(surface.sizeX() * column / (kSearched - 1.0),
                                   surface.sizeY() * row / (kSearched - 1.0));
            const HeightSample sample = surface.at(position.x(), position.y());
            const double above = sample.height - (position - middle).squaredNorm() / (2.0 * radius);
            if (above > highest) {
                highest = above;
                met = sample;
            }
        }
    }
    return met;
}

/// Radius of the tip as far as views show it [m]: of one that would fill a view of the whole scan,
/// what the asperity that it meets first leaves of it. Laws of the exact sphere know a flat sample
/// alone.
double shownRadius(const Scene& scene) {
    const double tip = scene.belief.tipRadius();
    const BSplineSurface& surface = scene.surface;
    const double scan = 0.5 * std::max(surface.sizeX(), surface.sizeY());
    if (kUsualWidth.ofTip * tip <= scan || isSphere(scene.belief.contact.law())) {
        return tip;
    }
    const PrincipalCurvatures bend = principalCurvatures(firstMet(surface, tip));
    const double effective = effectiveRadius(tip, bend.largest, bend.smallest).radius;
    return std::min(tip, std::max(effective, kMinFrameShare * scan / kUsualWidth.ofTip));
}

/// Contact radius that views must have room for [m]: the unloaded one, on a cone also that at the
/// setpoint, which may press it far in. On a sphere no contact is wider than the tip.
/// @param pair of the tip as it is shown
double usualContactRadius(const Scene& scene, const ContactPair& pair) {
    const ContactModel& model = scene.belief.contact;
    const double paraboloid = unloadedContactRadius(pair);
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

/// Contact radius at the setpoint, or without load where that is wider [m]; 0: there is none.
double setpointContactRadius(const Scene& scene, const ContactPair& pair) {
    const ContactModel model = scene.belief.contact.withPair(pair);
    constexpr double kHeld = 0.0;  // compliance [m/N]
    const auto depth = basePositionAt(model, kHeld, scene.description.setpoint);
    return std::max(usualContactRadius(scene, pair),
                    depth ? model.equilibrium(*depth, kHeld, kBondedMemory).contactRadius : 0.0);
}

/// Half the width with which a section begins [m]: in it the contact that the setpoint makes is
/// large enough to be seen true to scale, and on a soft sample so is the tip.
double sectionHalfWidth(double tip, double contact) {
    const double seen = contact > 0.0
                            ? std::min(kSectionWidth.ofTip * tip, kSectionContacts * contact)
                            : kSectionWidth.ofTip * tip;
    return std::max(seen, kSectionWidth.ofContact * contact);
}

/// Of a flat sample, without its lever [m]; 0 where the law does not reach the setpoint.
double usualDent(const Scene& scene) {
    constexpr double kHeld = 0.0;  // compliance [m/N]
    return std::max(
        0.0, basePositionAt(scene.belief.contact, kHeld, scene.description.setpoint).value_or(0.0));
}

/// Force whose arrow fills half of its room [N]: between setpoint and pull-off, so that both have
/// arrows that are seen, however different they are.
double usualForce(const Scene& scene, const ContactPair& pair) {
    const double setpoint = scene.description.setpoint;
    const double pullOff = jkrPullOff(pair);
    return pullOff > 0.0 ? std::sqrt(setpoint * pullOff) : setpoint;
}

constexpr double kRoom = 1.55;  // the tip is not always in the middle of the frame

}  // namespace

ViewFrame::ViewFrame(double sizeX, double sizeY, double halfWidth)
    : size_(sizeX, sizeY), center_(0.5 * size_), halfWidth_(halfWidth) {
    setHalfWidth(halfWidth);
}

void ViewFrame::setHalfWidth(double halfWidth) {
    halfWidth_ = std::min(halfWidth, 0.5 * size_.maxCoeff());
    stayInside();
}

void ViewFrame::follow(const Vector2& position, double slack) {
    if ((position - center_).cwiseAbs().maxCoeff() > halfWidth_) {  // out of the picture: a new one
        center_ = position;
    }
    const double range = slack * halfWidth_;
    const double step = kStep * halfWidth_;
    center_ = {followed(center_.x(), position.x(), range, step),
               followed(center_.y(), position.y(), range, step)};
    stayInside();
}

Vector2 ViewFrame::reach() const { return (0.5 * size_).cwiseMin(halfWidth_); }

void ViewFrame::stayInside() {
    const Vector2 margin = reach();
    center_ = center_.cwiseMax(margin).cwiseMin(size_ - margin);
}

ScanWindow ViewFrame::window() const {
    const Vector2 low = center_ - reach();
    const Vector2 high = center_ + reach();
    return {.left = low.x(), .right = high.x(), .bottom = low.y(), .top = high.y()};
}

ScanWindow windowAround(const Vector2& position, double halfWidth, const ScanWindow& inside) {
    const double x = std::clamp(position.x(), inside.left, inside.right);
    const double y = std::clamp(position.y(), inside.bottom, inside.top);
    return {.left = std::max(x - halfWidth, inside.left),
            .right = std::min(x + halfWidth, inside.right),
            .bottom = std::max(y - halfWidth, inside.bottom),
            .top = std::min(y + halfWidth, inside.top)};
}

bool holds(const ScanWindow& area, const Vector2& position) {
    return position.x() >= area.left && position.x() <= area.right && position.y() >= area.bottom &&
           position.y() <= area.top;
}

bool sameWindow(const ScanWindow& one, const ScanWindow& other) {
    return one.left == other.left && one.right == other.right && one.bottom == other.bottom &&
           one.top == other.top;
}

ViewScale viewScale(const Scene& scene) {
    const double tip = scene.belief.tipRadius();
    const double shown = shownRadius(scene);
    ContactPair pair = scene.belief.contact.pair();
    pair.tipRadius = shown;
    const double contact = usualContactRadius(scene, pair);
    const double dent = usualDent(scene);
    const double paraboloid = unloadedContactRadius(scene.belief.contact.pair());
    const bool isWide = !isSphere(scene.belief.contact.law()) && paraboloid > kWideContact * tip;
    const BSplineSurface::Grid& grid = scene.surface.grid();
    const double pixel = std::max(grid.pitchX, grid.pitchY);
    const double given = scene.description.zoomHalfWidth;
    const double reach = isWide ? std::max(tip, kParaboloidReach * paraboloid) : 0.0;
    const TipOutline outline{scene.description.tip.shape(), reach};
    const double usual = std::max(kUsualWidth.of(shown, contact), kUsualPixels * pixel);
    const double pressed = tip > usual ? 0.0 : outline.frameAround(dent);  // a cap has no shank
    const double scan = 0.5 * std::max(scene.surface.sizeX(), scene.surface.sizeY());
    return {.patch = kPatchWidth.of(shown, contact),
            .usual = given > 0.0 ? given : std::max(usual, pressed),
            .least = kMinWidth.of(shown, contact),
            .section = std::min(scan, sectionHalfWidth(shown, setpointContactRadius(scene, pair))),
            .leastSection = std::min(scan, kMinSection * shown),
            .pixel = pixel,
            .paraboloidReach = reach,
            .dent = dent,
            .force = usualForce(scene, pair)};
}

double unloadedContactRadius(const ContactPair& pair) {
    const double modulus = 4.0 / 3.0 * pair.reducedModulus;
    return std::cbrt(6.0 * std::numbers::pi * pair.workOfAdhesion * pair.tipRadius *
                     pair.tipRadius / modulus);
}

double TipOutline::radius(double height) const {
    if (paraboloidReach > 0.0) {
        const double joint = 0.5 * paraboloidReach * paraboloidReach / tip.radius;
        return height <= joint ? std::sqrt(2.0 * tip.radius * height)
                               : paraboloidReach + (height - joint) * tip.radius / paraboloidReach;
    }
    const double angle = tip.shankHalfAngle();
    const double joint = tip.radius * (1.0 - std::sin(angle));
    return height <= joint ? std::sqrt(height * (2.0 * tip.radius - height))
                           : tip.radius * std::cos(angle) + (height - joint) * std::tan(angle);
}

double TipOutline::frameAround(double indentation) const {
    return kRoom * radius(std::max(0.0, indentation));
}

}  // namespace asperity
