#include "core/contact/laws/FilmLaw.h"

namespace asperity {

FilmLaw::FilmLaw(const ContactPair& pair, double thickness, const FilmTable& table) noexcept
    : thickness_(thickness)
    , indentationUnit_(thickness * (thickness / pair.tipRadius))
    , stiffnessUnit_(pair.reducedModulus * thickness)
    , table_(&table) {}

LawPoint FilmLaw::fold(double /*compliance*/) const noexcept { return {}; }

std::optional<LawPoint> FilmLaw::stable(double approach, double compliance) const noexcept {
    if (!(approach >= 0.0)) {
        return std::nullopt;
    }
    const FilmPoint point =
        table_->onSpring(approach / indentationUnit_, compliance * stiffnessUnit_);
    const double radius = thickness_ * point.ratio;
    return LawPoint{.force = stiffnessUnit_ * indentationUnit_ * point.force,
                    .indentation = indentationUnit_ * point.indentation,
                    .contactRadius = radius,
                    .cohesiveRadius = radius,
                    .stiffness = stiffnessUnit_ * point.stiffness};
}

double FilmLaw::energy(const LawPoint& point) const noexcept {
    return stiffnessUnit_ * indentationUnit_ * indentationUnit_ *
           table_->at(point.contactRadius / thickness_).energy;
}

}  // namespace asperity
