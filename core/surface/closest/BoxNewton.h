#pragma once

#include "core/surface/BSplineSurface.h"
#include "core/surface/closest/Box.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace asperity {

using Matrix2 = Eigen::Matrix2d;

/// A function of a position on the surface, expanded to second order. Its unit is the caller's.
struct LocalModel {
    HeightSample surface;  ///< the surface there
    double value = 0.0;
    double valueNoise = 0.0;  ///< rounding error of `value`
    Vector2 gradient = Vector2::Zero();
    Vector2 gradientNoise = Vector2::Zero();  ///< rounding error of `gradient`
    Matrix2 hessian = Matrix2::Zero();
    Matrix2 convex = Matrix2::Zero();  ///< positive definite stand-in where `hessian` is not
};

struct BoxMinimum {
    Vector2 position = Vector2::Zero();  ///< world [m]
    LocalModel model;
    int iterations = 0;      ///< Newton steps
    int evaluations = 0;     ///< of the objective
    bool converged = false;  ///< a local minimum: the gradient is rounding noise
    bool pushedOut = false;  ///< the minimum lies on the box's edge and would lie beyond it
};

/// Local minimum of objective(position) -> LocalModel in a box: Newton's method with an active set
/// for the box, a convex stand-in where the Hessian is indefinite, and backtracking, so that every
/// step lowers the value (as far as rounding lets one tell). Leaves saddles and maxima along the
/// direction of negative curvature. Allocation-free, bounded.
template <class Objective>
class BoxNewton {
public:
    /// @param escapeStep how far to step off a saddle or maximum [m]
    BoxNewton(const Objective& objective, Box box, double escapeStep) noexcept
        : objective_(objective), box_(std::move(box)), escapeStep_(escapeStep) {}

    [[nodiscard]] BoxMinimum minimize(const Vector2& start) const noexcept {
        BoxMinimum state;
        state.position = box_.nearest(start);
        state.model = objective_(state.position);
        state.evaluations = 1;
        while (state.evaluations < kMaxEvaluations) {
            const Free free = freeAxes(state);
            bool moved = !atRest(state.model, free, 1.0) && step(state, free);
            // Also where rounding ends the steps a little before the gradient vanishes.
            if (!moved && atRest(state.model, free, kNoiseAllowance)) {
                moved = escape(state, free);
            }
            if (!moved) {
                break;
            }
            ++state.iterations;
        }
        const Free free = freeAxes(state);
        state.converged = atRest(state.model, free, kNoiseAllowance) &&
                          (isConvex(state.model.hessian, free) ||
                           downwardCurvature(state.model.hessian, free).isZero(0.0));
        state.pushedOut = pushes(state, free);
        return state;
    }

private:
    static constexpr int kMaxEvaluations = 80;
    static constexpr int kMaxHalvings = 24;
    static constexpr double kArmijo = 1e-4;
    static constexpr double kNoiseAllowance = 32.0;
    /// A Hessian nearer to singular than this sends the step to nowhere useful.
    static constexpr double kSingular = 1e-10;

    using Free = std::array<bool, 2>;  ///< the axes along which the position may move

    [[nodiscard]] Free freeAxes(const BoxMinimum& state) const {
        Free free{};
        for (int axis = 0; axis < 2; ++axis) {
            const double slope = state.model.gradient[axis];
            free[axis] = !(state.position[axis] <= box_.low[axis] && slope >= 0.0) &&
                         !(state.position[axis] >= box_.high[axis] && slope <= 0.0);
        }
        return free;
    }

    static bool atRest(const LocalModel& model, const Free& free, double allowance) {
        for (int axis = 0; axis < 2; ++axis) {
            if (free[axis] &&
                std::abs(model.gradient[axis]) > allowance * model.gradientNoise[axis]) {
                return false;
            }
        }
        return true;
    }

    /// Returns whether an edge holds the position back.
    static bool pushes(const BoxMinimum& state, const Free& free) {
        for (int axis = 0; axis < 2; ++axis) {
            if (!free[axis] && std::abs(state.model.gradient[axis]) >
                                   kNoiseAllowance * state.model.gradientNoise[axis]) {
                return true;
            }
        }
        return false;
    }

    static bool isConvex(const Matrix2& h, const Free& free) {
        if (free[0] && free[1]) {
            const double product = h(0, 0) * h(1, 1);
            return h(0, 0) > 0.0 && product - h(0, 1) * h(0, 1) > kSingular * product;
        }
        if (free[0]) {
            return h(0, 0) > 0.0;
        }
        return !free[1] || h(1, 1) > 0.0;
    }

    /// Step to the least value of the local quadratic along one axis, within the box.
    [[nodiscard]] double stepAlong(int axis, const Vector2& from, double slope, double bend) const {
        return std::clamp(-slope / bend, box_.low[axis] - from[axis], box_.high[axis] - from[axis]);
    }

    /// The least value of the quadratic lies outside the box: the step to the least one on a side
    /// that is in the way. Cutting the free step off there would not even lead downhill.
    [[nodiscard]] Vector2 stepAlongSide(const Vector2& from, const Vector2& g, const Matrix2& h,
                                        const Vector2& freeStep) const {
        Vector2 best = Vector2::Zero();
        double lowest = std::numeric_limits<double>::max();
        for (int axis = 0; axis < 2; ++axis) {
            const int other = 1 - axis;
            Vector2 step;
            step[axis] = std::clamp(freeStep[axis], box_.low[axis] - from[axis],
                                    box_.high[axis] - from[axis]);
            if (step[axis] == freeStep[axis]) {
                continue;
            }
            step[other] = stepAlong(other, from, g[other] + h(0, 1) * step[axis], h(other, other));
            const double value = g.dot(step) + 0.5 * step.dot(h * step);
            if (value < lowest) {
                lowest = value;
                best = step;
            }
        }
        return best;
    }

    /// Step to the least value of the local quadratic in the box.
    [[nodiscard]] Vector2 newtonStep(const BoxMinimum& state, const Free& free) const {
        const LocalModel& model = state.model;
        const Matrix2& h = isConvex(model.hessian, free) ? model.hessian : model.convex;
        const Vector2& g = model.gradient;
        if (free[0] && free[1]) {
            const double determinant = h(0, 0) * h(1, 1) - h(0, 1) * h(0, 1);
            const Vector2 step =
                Vector2(h(0, 1) * g[1] - h(1, 1) * g[0], h(0, 1) * g[0] - h(0, 0) * g[1]) /
                determinant;
            const Vector2 end = state.position + step;
            return end == box_.nearest(end) ? step : stepAlongSide(state.position, g, h, step);
        }
        return {free[0] ? stepAlong(0, state.position, g[0], h(0, 0)) : 0.0,
                free[1] ? stepAlong(1, state.position, g[1], h(1, 1)) : 0.0};
    }

    /// Steps down by Newton's method, halving the step until the value falls.
    bool step(BoxMinimum& state, const Free& free) const {
        Vector2 move = newtonStep(state, free);
        for (int halving = 0; halving < kMaxHalvings && state.evaluations < kMaxEvaluations;
             ++halving) {
            const Vector2 position = box_.nearest(state.position + move);
            if (position == state.position) {
                return false;
            }
            LocalModel model = objective_(position);
            ++state.evaluations;
            if (isLower(state, free, position, model)) {
                state.position = position;
                state.model = model;
                return true;
            }
            move *= 0.5;
        }
        return false;
    }

    static double freeSlope(const LocalModel& model, const Free& free) {
        return (free[0] ? std::abs(model.gradient[0]) : 0.0) +
               (free[1] ? std::abs(model.gradient[1]) : 0.0);
    }

    static bool isLower(const BoxMinimum& state, const Free& free, const Vector2& position,
                        const LocalModel& model) {
        const double expected = state.model.gradient.dot(position - state.position);
        if (model.value < state.model.value &&
            model.value <= state.model.value + kArmijo * expected) {
            return true;
        }
        // Below the rounding of the value only the gradient still points down.
        const double noise = 4.0 * state.model.valueNoise;
        return std::abs(expected) <= noise && model.value <= state.model.value + noise &&
               freeSlope(model, free) < 0.5 * freeSlope(state.model, free);
    }

    /// At rest: true only when this is no minimum and a lower position was found beside it.
    bool escape(BoxMinimum& state, const Free& free) const {
        if (isConvex(state.model.hessian, free)) {
            return false;
        }
        const Vector2 direction = downwardCurvature(state.model.hessian, free);
        if (direction.isZero(0.0)) {
            return false;
        }
        bool moved = false;
        const BoxMinimum from = state;
        for (const double sign : {1.0, -1.0}) {
            const Vector2 position = box_.nearest(from.position + sign * escapeStep_ * direction);
            LocalModel model = objective_(position);
            ++state.evaluations;
            if (model.value < state.model.value - 4.0 * from.model.valueNoise) {
                state.position = position;
                state.model = model;
                moved = true;
            }
        }
        return moved;
    }

    /// Unit direction of the most negative curvature among the free axes; zero when there is none.
    static Vector2 downwardCurvature(const Matrix2& h, const Free& free) {
        if (!free[0] || !free[1]) {
            return {free[0] && h(0, 0) < 0.0 ? 1.0 : 0.0, free[1] && h(1, 1) < 0.0 ? 1.0 : 0.0};
        }
        const double mean = 0.5 * (h(0, 0) + h(1, 1));
        const double half = 0.5 * (h(0, 0) - h(1, 1));
        const double lowest = mean - std::hypot(half, h(0, 1));
        if (lowest >= -kSingular * std::abs(mean)) {
            return Vector2::Zero();
        }
        const Vector2 byFirst(h(0, 1), lowest - h(0, 0));
        const Vector2 bySecond(lowest - h(1, 1), h(0, 1));
        const Vector2& longer = byFirst.squaredNorm() > bySecond.squaredNorm() ? byFirst : bySecond;
        return longer.isZero(0.0) ? Vector2::UnitX() : Vector2(longer.normalized());
    }

    const Objective& objective_;
    Box box_;
    double escapeStep_;
};

/// Rounding errors of positions, heights and slopes of a surface in double precision.
struct SurfaceRounding {
    double position = 0.0;  ///< [m]
    double height = 0.0;    ///< [m]
    double slope = 0.0;
};

/// @param reach magnitude of the other coordinates that take part [m]
inline SurfaceRounding roundingOf(const BSplineSurface& surface, const Vector3& reach) {
    constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
    const double across =
        std::abs(reach.x()) + std::abs(reach.y()) + surface.sizeX() + surface.sizeY();
    const double height = surface.heightScale() + std::abs(reach.z());
    const double pitch = std::min(surface.grid().pitchX, surface.grid().pitchY);
    return {.position = kEpsilon * across,
            .height = kEpsilon * height,
            .slope = kEpsilon * height / pitch};
}

/// The whole scan as a box.
inline Box scanBox(const BSplineSurface& surface) {
    return {.low = Vector2::Zero(), .high = Vector2(surface.sizeX(), surface.sizeY())};
}

}  // namespace asperity
