#include "core/map/VerticalPath.h"

#include <algorithm>

namespace asperity {

bool TipAtHeight::isBonded() const noexcept {
    const auto end = memory.points.begin() + static_cast<std::ptrdiff_t>(memory.pointCount);
    return std::any_of(memory.points.begin(), end, [](const ClosestPointMemory& point) {
        return point.contact.branch == ContactBranch::Bonded;
    });
}

TipAtHeight VerticalPath::at(double base, const EquilibriumMemory& memory) {
    ++solved_;
    TipAtHeight tip{.base = base, .state = {}, .memory = memory};
    tip.state =
        tipEquilibrium(instrument_.surface(), instrument_.system(),
                       {.position = Vector3(place_.x(), place_.y(), base), .velocity = velocity_},
                       tip.memory, tracker_);
    return tip;
}

double VerticalPath::compliance(const TipState& state) const noexcept {
    const Vector3& normal = state.closest.normal;
    return normal.dot(instrument_.system().cantilever.compliance() * normal);
}

double VerticalPath::complianceZ() const noexcept {
    return instrument_.system().cantilever.compliance()(2, 2);
}

}  // namespace asperity
