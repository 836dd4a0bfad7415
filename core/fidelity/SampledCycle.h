#pragma once

#include "core/Vector.h"
#include "core/scene/JudgedQuantity.h"

#include <cmath>
#include <optional>
#include <vector>

namespace asperity {

struct Scene;

/// Squares of the difference of two forces along a run or a curve, and of the reference itself, in
/// any unit.
struct ForceSquares {
    double heldAlike = 0.0;  ///< of the difference where both hold the tip, or both do not
    double heldByOne = 0.0;  ///< where one has jumped and the other has not
    double reference = 0.0;

    /// The error of the rms force as a share: the root mean square of the difference over that of
    /// the reference, and of a jump that comes earlier or later the share of the mean square that
    /// lies between the two. That is as small as the jump's displacement. The root of it is not: it
    /// would make 10 % of the force of a displacement that nobody sees, 1 % of the curve.
    /// 0 where there is no force.
    [[nodiscard]] double share() const noexcept {
        return reference > 0.0 ? std::sqrt(heldAlike / reference) + (heldByOne / reference) : 0.0;
    }
};

/// The force along z over the height of the base, piece by piece a straight line; 0 outside it.
class ForceLine {
public:
    struct Point {
        double base = 0.0;   ///< [m]
        double force = 0.0;  ///< along z [N]
    };

    /// @param points in rising order; a jump is two points at one height
    explicit ForceLine(std::vector<Point> points) : points_(std::move(points)) {}

    [[nodiscard]] double at(double base) const noexcept;  ///< [N]
    [[nodiscard]] const std::vector<Point>& points() const noexcept { return points_; }

private:
    std::vector<Point> points_;
};

/// What a model says of an approach until the force along z is the setpoint, and of the retract
/// until the tip is free, see JudgedQuantity. Forces along z, pulls > 0.
struct SampledCycle {
    double pullOffForce = 0.0;    ///< [N]
    double pullOffBase = 0.0;     ///< height of the base where the tip pulls off [m]
    double snapInForce = 0.0;     ///< [N]
    double snapInBase = 0.0;      ///< likewise [m]
    double setpointBase = 0.0;    ///< and at the setpoint [m]
    double indentation = 0.0;     ///< at the setpoint [m]
    double pulled = 0.0;          ///< by how much the indentation falls until the pull-off [m]
    double stiffness = 0.0;       ///< at the setpoint [N/m]
    double separationWork = 0.0;  ///< [J]
    double setpoint = 0.0;        ///< [N]
    ForceLine approach;
    ForceLine retract;
};

/// Runs a cycle of the scene's model. None: the tip does not engage there, or stays bonded.
/// @param place of the base, world x, y [m] @param setpoint [N]
[[nodiscard]] std::optional<SampledCycle> sampleCycle(const Scene& scene, const Vector2& place,
                                                      double setpoint);

/// The errors of one model's cycle against that of another at the same place.
[[nodiscard]] QuantityErrors errorsOf(const SampledCycle& cycle, const SampledCycle& reference);

}  // namespace asperity
