#include "core/identify/TipLaw.h"

#include "core/Error.h"

#include <cmath>
#include <numbers>

namespace asperity {

namespace {

constexpr double kFourSides = 0.7453;
constexpr double kThreeSides = 0.887;
constexpr double kMaxAngle = 89.0 * std::numbers::pi / 180.0;
constexpr std::size_t kTipNodes = 256;

void checkTip(const TipForm& tip, const SampleFilm& film) {
    if (hasRadius(tip.kind) && !(tip.radius >= 1e-12 && tip.radius <= 1.0)) {
        throw Error("the radius of a tip must be within 1e-12 to 1 m");
    }
    if (hasAngle(tip.kind) && !(tip.angle > 0.0 && tip.angle <= kMaxAngle)) {
        throw Error("the angle of a tip's face to its axis must be within 0 to 89 degrees");
    }
    if (film.thickness > 0.0 && tip.kind != TipKind::Paraboloid) {
        throw Error("a film needs --tip paraboloid:R: its law takes the tip for a paraboloid");
    }
}

double factorOf(const TipForm& tip) {
    switch (tip.kind) {
    case TipKind::Paraboloid:
        return 4.0 / 3.0 * std::sqrt(tip.radius);
    case TipKind::Cone:
        return 2.0 / std::numbers::pi * std::tan(tip.angle);
    case TipKind::Pyramid3:
        return kThreeSides * std::tan(tip.angle);
    case TipKind::Pyramid4:
        return kFourSides * std::tan(tip.angle);
    default:
        return 0.0;
    }
}

IndentationPoint overUnitModulus(const std::optional<LawPoint>& point) {
    return point ? IndentationPoint{.force = point->force,
                                    .stiffness = point->stiffness,
                                    .contactRadius = point->contactRadius,
                                    .indentation = point->indentation}
                 : IndentationPoint{};
}

}  // namespace

std::optional<double> exponentOf(const TipForm& tip) noexcept {
    switch (tip.kind) {
    case TipKind::Sphere:
    case TipKind::Paraboloid:
        return 1.5;
    case TipKind::Cone:
    case TipKind::Pyramid3:
    case TipKind::Pyramid4:
        return 2.0;
    default:
        return std::nullopt;
    }
}

TipLaw::TipLaw(const TipForm& tip, const SampleFilm& film, double largest)
    : tip_(tip), filmThickness_(film.thickness), factor_(factorOf(tip)) {
    checkTip(tip, film);
    if (film.thickness > 0.0) {
        filmTable_ = sharedFilmTable({.poissonRatio = film.poissonRatio});
    }
    if (tip.kind == TipKind::Area) {
        area_.emplace(tip.area);
    }
    if (factor_ > 0.0 && filmTable_ == nullptr) {
        exponent_ = *exponentOf(tip);
    } else {
        tabulate(largest);
    }
}

IndentationPoint TipLaw::exact(double indentation) const noexcept {
    if (!(indentation > 0.0)) {
        return {};
    }
    if (area_) {
        return area_->at(indentation);
    }
    const ContactPair pair{.tipRadius = tip_.radius, .reducedModulus = 1.0, .workOfAdhesion = 0.0};
    if (filmTable_ != nullptr) {
        return overUnitModulus(FilmLaw(pair, filmThickness_, *filmTable_).stable(indentation, 0.0));
    }
    if (exponent_ == 0.0) {
        const double cone = tip_.kind == TipKind::ConeSphere ? tip_.angle : 0.0;
        return overUnitModulus(SneddonLaw(pair, cone).stable(indentation, 0.0));
    }
    IndentationPoint point = at(indentation);
    point.contactRadius = 0.5 * point.stiffness;  // of any axisymmetric tip
    return point;
}

/// Between nodes a cubic of the root of the indentation, with the values and rates of both.
IndentationPoint TipLaw::tabulated(double indentation, double root) const noexcept {
    const double position = root * nodesPerRoot_;
    const auto index = static_cast<std::size_t>(position);
    if (!(position < static_cast<double>(nodes_.size() - 1))) {
        return exact(indentation);
    }
    const double t = position - static_cast<double>(index);
    const Node& low = nodes_[index];
    const Node& high = nodes_[index + 1];
    const double rise = high.force - low.force;
    const double second = (3.0 * rise) - (2.0 * low.rate) - high.rate;
    const double third = low.rate + high.rate - (2.0 * rise);
    const double rate = low.rate + (t * ((2.0 * second) + (3.0 * t * third)));
    return {.force = low.force + (t * (low.rate + (t * (second + (t * third))))),
            .stiffness = 0.5 * rate * nodesPerRoot_ / root,
            .indentation = indentation};
}

void TipLaw::tabulate(double largest) {
    nodesPerRoot_ = static_cast<double>(kTipNodes) / std::sqrt(largest);
    nodes_.resize(kTipNodes + 1);
    for (std::size_t i = 1; i < nodes_.size(); ++i) {
        const double root = static_cast<double>(i) / nodesPerRoot_;
        const IndentationPoint point = exact(root * root);
        nodes_[i] = {.force = point.force, .rate = point.stiffness * 2.0 * root / nodesPerRoot_};
    }
}

}  // namespace asperity
