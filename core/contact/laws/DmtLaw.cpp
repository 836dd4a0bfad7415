#include "core/contact/laws/DmtLaw.h"

#include <numbers>

namespace asperity {

DmtLaw::DmtLaw(const ContactPair& pair) noexcept
    : elastic_(pair), attraction_(2.0 * std::numbers::pi * pair.workOfAdhesion * pair.tipRadius) {}

LawPoint DmtLaw::attracted(LawPoint point) const noexcept {
    point.force -= attraction_;
    return point;
}

LawPoint DmtLaw::atContactRadius(double contactRadius) const noexcept {
    return attracted(elastic_.atContactRadius(contactRadius));
}

LawPoint DmtLaw::atForce(double force) const noexcept {
    return attracted(elastic_.atForce(force + attraction_));
}

LawPoint DmtLaw::atIndentation(double indentation) const noexcept {
    return attracted(elastic_.atIndentation(indentation));
}

LawPoint DmtLaw::fold(double compliance) const noexcept {
    return attracted(elastic_.fold(compliance));
}

/// The constant attraction moves the lever by a constant.
std::optional<LawPoint> DmtLaw::stable(double approach, double compliance) const noexcept {
    const auto point = elastic_.stable(approach + (compliance * attraction_), compliance);
    return point ? std::optional(attracted(*point)) : std::nullopt;
}

double DmtLaw::energy(const LawPoint& point) const noexcept {
    return elastic_.energy(point) - (attraction_ * point.indentation);
}

}  // namespace asperity
