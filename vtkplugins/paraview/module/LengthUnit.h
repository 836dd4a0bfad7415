#pragma once

#include "core/surface/GivenScale.h"

#include <cmath>

namespace asperity {

/// Unit of the lengths that ParaView gets. It shades a surface given in meters wrongly: its normals
/// underflow in single precision.
class LengthUnit {
public:
    explicit LengthUnit(double meters) : meters_(meters) {}

    [[nodiscard]] bool isUsable() const { return std::isfinite(meters_) && meters_ > 0.0; }
    /// Rounded once, so that heights in single precision come back to the bit.
    [[nodiscard]] double fromMeters(double length) const {
        return meters_ < 1.0 ? length * std::round(1.0 / meters_) : length / meters_;
    }
    [[nodiscard]] double toMeters(double length) const { return inMeters(length, meters_); }

private:
    double meters_;  ///< [m]
};

}  // namespace asperity
