#include "core/contact/FilmLaw.h"

#include "core/contact/RootSearch.h"

#include <array>
#include <cmath>

namespace asperity {

namespace {

/// Of the stiffening polynomial, by powers of chi.
constexpr std::array<double, 5> kStiffening{1.0, 1.133, 1.283, 0.769, 0.0975};

}  // namespace

FilmLaw::FilmLaw(const ContactPair& pair, double thickness) noexcept
    : halfSpace_(pair), thickness_(thickness) {}

/// The force is a sum of powers delta^(3/2 + k/2), and so is its slope.
LawPoint FilmLaw::atIndentation(double indentation) const noexcept {
    LawPoint point = halfSpace_.atIndentation(indentation);
    const double chi = point.contactRadius / thickness_;
    double factor = 0.0;
    double slope = 0.0;
    for (std::size_t k = kStiffening.size(); k-- > 0;) {
        factor = (factor * chi) + kStiffening[k];
        slope = (slope * chi) + (kStiffening[k] * (1.0 + (static_cast<double>(k) / 3.0)));
    }
    point.force *= factor;
    point.stiffness *= slope;
    return point;
}

LawPoint FilmLaw::fold(double /*compliance*/) const noexcept { return {}; }

std::optional<LawPoint> FilmLaw::stable(double approach, double compliance) const noexcept {
    if (!(approach >= 0.0)) {
        return std::nullopt;
    }
    const auto excess = [&](double indentation) {
        return indentation + (compliance * atIndentation(indentation).force) - approach;
    };
    return atIndentation(rootBetween(excess, 0.0, approach));
}

double FilmLaw::energy(const LawPoint& point) const noexcept {
    const LawPoint bulk = halfSpace_.atIndentation(point.indentation);
    const double chi = bulk.contactRadius / thickness_;
    double sum = 0.0;
    for (std::size_t k = kStiffening.size(); k-- > 0;) {
        sum = (sum * chi) + (kStiffening[k] / (2.5 + (0.5 * static_cast<double>(k))));
    }
    return bulk.force * bulk.indentation * sum;
}

}  // namespace asperity
