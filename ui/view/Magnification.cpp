#include "ui/view/Magnification.h"

#include <algorithm>

namespace asperity {

namespace {

// In tip radii.
constexpr double kShownDisplacement = 0.9;  // at most, when magnified
constexpr double kMinDisplacement = 0.025;  // smaller ones are not magnified further
constexpr double kShownGap = 2.6;           // the tip stays in the picture

}  // namespace

double Magnification::fit(double displacement, double gap, double tipRadius) {
    const double gapsShare = gap * kShownDisplacement / kShownGap;
    const double largest = std::max({displacement, gapsShare, kMinDisplacement * tipRadius});
    chosen_.fit(largest, kShownDisplacement * tipRadius);
    return factor();
}

double Magnification::factor() const { return std::max(1.0, fixed_ ? *fixed_ : chosen_.factor()); }

}  // namespace asperity
