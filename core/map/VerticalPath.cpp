#include "core/map/VerticalPath.h"

#include <algorithm>
#include <limits>

namespace asperity {

bool TipAtHeight::isBonded() const noexcept {
    const auto end = memory.points.begin() + static_cast<std::ptrdiff_t>(memory.pointCount);
    return std::any_of(memory.points.begin(), end, [](const ClosestPointMemory& point) {
        return point.contact.branch == ContactBranch::Bonded;
    });
}

TipAtHeight VerticalPath::at(double base, const EquilibriumMemory& memory) {
    TipAtHeight tip{.base = base, .state = {}, .memory = memory};
    solve(tip);
    return tip;
}

void VerticalPath::goOn(TipAtHeight& tip) {
    constexpr int kMaxSolutions = 12;
    double moved = std::numeric_limits<double>::infinity();
    for (int i = 0; i < kMaxSolutions && tip.isBonded() && !tip.state.converged; ++i) {
        const Vector3 before = tip.memory.deflection;
        solve(tip);
        const double now = (tip.memory.deflection - before).norm();
        if (now >= moved || now == 0.0) {
            return;
        }
        moved = now;
    }
}

void VerticalPath::solve(TipAtHeight& tip) {
    ++solved_;
    tip.state = tipEquilibrium(
        instrument_.surface(), instrument_.system(),
        {.position = Vector3(place_.x(), place_.y(), tip.base), .velocity = velocity_}, tip.memory,
        tracker_);
}

double VerticalPath::compliance(const TipState& state) const noexcept {
    const Vector3& normal = state.closest.normal;
    return normal.dot(instrument_.system().cantilever.compliance() * normal);
}

double VerticalPath::complianceZ() const noexcept {
    return instrument_.system().cantilever.compliance()(2, 2);
}

}  // namespace asperity
