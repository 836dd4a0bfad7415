#include "ui/view/TipGear.h"

#include "core/scene/Scene.h"

#include <algorithm>

namespace asperity {

namespace {

// In sizes of tip and arrow.
constexpr double kTipTop = 1.15;
constexpr double kSmallGear = 0.6;  // of the frame: from here on outwards the lever is in the view
constexpr double kLeverHalfWidth = 0.5;

// In half widths of the frame.
constexpr double kCapSize = 0.6;
constexpr double kCapWidth = 0.6;

constexpr double kCapOpacity = 0.4;

}  // namespace

double GearScale::size() const {
    return isCap() ? kCapSize * halfWidth : std::min(halfWidth, 1.5 * tipRadius + 0.4 * halfWidth);
}

double GearScale::tipHeight() const {
    return isCap() ? heightScale * RoundTip{tipRadius}.height(kCapWidth * halfWidth) : headroom();
}

double GearScale::headroom() const { return kTipTop * size(); }

bool GearScale::showsLever() const { return !isCap() && size() <= kSmallGear * halfWidth; }

void TipGear::hide() {
    tip_.hide();
    lever_.hide();
}

void TipGear::show(const Scene& scene, const ContactShape& shape, const GearScale& scale,
                   const DrawnSpace& space, const Shading& shading) {
    // A tip that is pressed deep into the surface still ends above it.
    constexpr double kAboveSurface = 0.6;  // of its usual height
    const double pressed =
        (space.heightScale * shape.contact().indentation) + (kAboveSurface * scale.tipHeight());
    const double height = scale.isCap() ? scale.tipHeight() : std::max(scale.tipHeight(), pressed);
    tip_.show(shape, {.height = height,
                      .paraboloidReach = scale.paraboloidReach,
                      .opacity = scale.isCap() ? kCapOpacity : 1.0,
                      .space = space,
                      .shading = shading});
    if (!scale.showsLever()) {
        lever_.hide();
        return;
    }
    const CantileverGeometry& lever = scene.description.probe;
    lever_.show({.shankTop = space.point(apexOf(shape.contact())) + height * Vector3::UnitZ(),
                 .size = kLeverHalfWidth * scale.size(),
                 .azimuth = lever.azimuth,
                 .tilt = lever.mountTilt},
                shading);
}

}  // namespace asperity
