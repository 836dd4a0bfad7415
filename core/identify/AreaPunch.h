#pragma once

#include <vector>

namespace asperity {

/// Elastic contact of a tip with a half-space of E* = 1.
struct IndentationPoint {
    double force = 0.0;          ///< over E* [m^2]
    double stiffness = 0.0;      ///< d(force)/d(indentation) over E* [m]
    double contactRadius = 0.0;  ///< of the circle with the area of contact [m]
    double indentation = 0.0;    ///< [m]
};

/// Cross-section of a tip at a distance from its apex, as a calibration of the tip measures it.
struct AreaSample {
    double height = 0.0;  ///< above the apex [m]
    double area = 0.0;    ///< [m^2]
};

/// Elastic contact of a half-space with a tip that is known by its area function alone: Sneddon's
/// solution for the axisymmetric tip of the same areas, which are linear between the samples.
/// Source: Sneddon (1965); docs/theory.md 4.1.
class AreaPunch {
public:
    /// @throw Error unless there are two samples of rising heights and areas, both >= 0
    explicit AreaPunch(const std::vector<AreaSample>& samples);

    /// The contact of this radius, > 0 [m], with its force over E*.
    [[nodiscard]] IndentationPoint ofRadius(double contactRadius) const noexcept;
    /// The contact at an indentation, > 0 [m].
    [[nodiscard]] IndentationPoint at(double indentation) const noexcept;
    /// Height of the last sample above the apex [m]; beyond, its area goes on as between the last
    /// two.
    [[nodiscard]] double height() const noexcept { return height_; }

private:
    struct Ring {
        double radius = 0.0;  ///< at which it begins [m]
        double square = 0.0;  ///< of that radius [m^2]
        double rise = 0.0;    ///< of the height by the square of the radius [1/m]
    };

    std::vector<Ring> rings_;
    double height_ = 0.0;
};

}  // namespace asperity
