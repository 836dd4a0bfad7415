#include "ui/view/TipOutline.h"

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

constexpr double kRoom = 1.55;  // the tip is not always in the middle of the frame

}  // namespace

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
