#include "ui/view/ViewOptions.h"

#include <cmath>
#include <numbers>

namespace asperity {

Vector3 Light::direction() const {
    constexpr double kDegree = std::numbers::pi / 180.0;
    const double flat = std::cos(kDegree * elevation);
    return {flat * std::cos(kDegree * azimuth), flat * std::sin(kDegree * azimuth),
            std::sin(kDegree * elevation)};
}

}  // namespace asperity
