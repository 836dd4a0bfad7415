#include "core/map/Engagement.h"

#include "core/map/ForceSearch.h"
#include "core/surface/deformation/ContactHeight.h"

#include <algorithm>
#include <utility>

namespace asperity {

namespace {

/// The tip above all that could make it snap in.
std::optional<TipAtHeight> freeTip(VerticalPath& path) {
    constexpr double kLeastShare = 0.05;  // of the tip's radius
    constexpr double kMargin = 1.5;
    constexpr int kMaxLifts = 40;
    const MapInstrument& instrument = path.instrument();
    const ProbeSystem& system = instrument.system();
    const double radius = system.tipRadius();
    const double touch =
        tipContactHeight(instrument.scene().surface, path.place().x(), path.place().y(), radius) -
        radius;
    double clearance = kMargin * std::max(-system.contact.jumpInApproach(path.complianceZ()),
                                          kLeastShare * radius);
    for (int i = 0; i < kMaxLifts; ++i) {
        TipAtHeight tip = path.at(touch + clearance, {});
        if (!tip.isBonded()) {
            return tip;
        }
        clearance *= 2.0;
    }
    return std::nullopt;
}

}  // namespace

std::optional<Engagement> engage(VerticalPath& path, double setpoint) {
    path.goDown();
    std::optional<TipAtHeight> free = freeTip(path);
    std::optional<FoundJump> snapIn = free ? findSnapIn(path, std::move(*free)) : std::nullopt;
    if (!snapIn) {
        return std::nullopt;
    }
    std::optional<TipAtHeight> reached = snapIn->after;
    if (reached->force() < setpoint) {
        reached = findForce(path, std::move(*reached), setpoint);
    }
    return reached ? std::optional(Engagement{std::move(*snapIn), std::move(*reached)})
                   : std::nullopt;
}

}  // namespace asperity
