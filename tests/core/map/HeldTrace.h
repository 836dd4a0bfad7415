#pragma once

#include "core/map/JumpSearch.h"

#include <Eigen/LU>

#include <limits>
#include <utility>

namespace asperity::test {

/// The way up of the tip by its own height, on which it has a state where the base has none any
/// more. Of several points those that were bonded stay it.
class HeldTrace {
public:
    HeldTrace(const VerticalPath& path, const TipAtHeight& from)
        : path_(path), memory_(from.memory), tip_(from.state.tip) {}

    /// Force along z where the base would have to turn back: the lever lets go [N]. NaN: nowhere.
    double forceAtTurn() {
        constexpr double kStep = 2e-12;
        constexpr int kMaxSteps = 5000;
        State first = stateAt(tip_);
        State second = first;
        for (int i = 0; i < kMaxSteps; ++i) {
            tip_.z() += kStep;
            const State third = balanced();
            if (third.base.z() < second.base.z()) {
                return forceAtTop(first, second, third);
            }
            first = std::exchange(second, third);
        }
        return std::numeric_limits<double>::quiet_NaN();
    }

private:
    struct State {
        Vector3 force;
        Vector3 base;  ///< where the lever would hold the tip in balance
    };

    /// Between three states at equal steps, by the parabola through them [N].
    static double forceAtTop(const State& first, const State& second, const State& third) {
        const Vector3 slope = 0.5 * (third.base - first.base);
        const Vector3 bend = third.base - 2.0 * second.base + first.base;
        const double steps = -slope.z() / bend.z();
        return second.force.z() + 0.5 * steps * (third.force.z() - first.force.z()) +
               0.5 * steps * steps * (third.force.z() - 2.0 * second.force.z() + first.force.z());
    }

    [[nodiscard]] State stateAt(const Vector3& tip) const {
        const MapInstrument& instrument = path_.instrument();
        const BaseMotion up{.position = tip, .velocity = VerticalPath::kSpeed * Vector3::UnitZ()};
        const Vector3 force = heldTip(instrument.surface(), instrument.system(), up, memory_).force;
        return {force, tip - instrument.system().cantilever.compliance() * force};
    }

    [[nodiscard]] Vector2 missAt(const Vector3& tip) const {
        return stateAt(tip).base.head<2>() - path_.position();
    }

    /// Moves the tip to the side until the base stands above its position.
    State balanced() {
        constexpr double kNudge = 1e-13;
        constexpr double kThere = 1e-16;
        for (int i = 0; i < 20; ++i) {
            const Vector2 miss = missAt(tip_);
            if (miss.norm() < kThere) {
                break;
            }
            Eigen::Matrix2d slope;
            slope.col(0) = (missAt(tip_ + kNudge * Vector3::UnitX()) - miss) / kNudge;
            slope.col(1) = (missAt(tip_ + kNudge * Vector3::UnitY()) - miss) / kNudge;
            tip_.head<2>() -= slope.inverse() * miss;
        }
        return stateAt(tip_);
    }

    const VerticalPath& path_;
    EquilibriumMemory memory_;
    Vector3 tip_;
};

}  // namespace asperity::test
