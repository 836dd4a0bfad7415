#pragma once

#include "core/map/JumpSearch.h"

#include <algorithm>

namespace asperity::test {

/// The strongest pull along z of a retract in equal small steps of the base [N].
/// @param step [m]
inline double slowRetractPull(VerticalPath& path, TipAtHeight tip, double step) {
    constexpr int kMaxSteps = 10000;
    path.goUp();
    const double bottom = tip.base;
    double strongest = 0.0;
    for (int i = 1; i <= kMaxSteps && tip.isBonded(); ++i) {
        strongest = std::max(strongest, tip.state.converged ? -tip.force() : 0.0);
        tip = path.at(bottom + i * step, tip.memory);
    }
    return strongest;
}

}  // namespace asperity::test
