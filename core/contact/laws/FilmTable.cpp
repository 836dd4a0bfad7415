#include "core/contact/laws/FilmTable.h"

#include "core/contact/numerics/ChebyshevFit.h"
#include "core/contact/numerics/GaussLegendre.h"
#include "core/contact/numerics/RisingSearch.h"
#include "core/contact/numerics/RootSearch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <mutex>
#include <numbers>
#include <utility>

namespace asperity {

namespace {

constexpr double kHertz = 4.0 / 3.0;         // force over a^3
constexpr double kHertzEnergy = 8.0 / 15.0;  // energy over a^5
constexpr double kStiffened = 1.05;          // from which force over a half-space's it is flagged
/// The error between the places where it is measured.
constexpr double kNodeSafety = 4.0;

constexpr FilmRatios kNothing{
    .indentation = 0.0, .force = 0.0, .stiffness = 0.0, .energy = 0.0, .profile = {}};

template <std::size_t Size>
void addScaled(std::array<double, Size>& sum, double weight, const std::array<double, Size>& term) {
    for (std::size_t i = 0; i < Size; ++i) {
        sum[i] += weight * term[i];
    }
}

void addScaled(FilmRatios& sum, double weight, const FilmRatios& term) {
    sum.indentation += weight * term.indentation;
    sum.force += weight * term.force;
    sum.stiffness += weight * term.stiffness;
    sum.energy += weight * term.energy;
    addScaled(sum.profile, weight, term.profile);
    addScaled(sum.surface, weight, term.surface);
}

double relativeError(double value, double exact) { return std::abs((value / exact) - 1.0); }

}  // namespace

double FilmTable::largestRatio() noexcept { return kEnd - kNear; }

FilmTable::FilmTable(const FilmElasticity& elasticity)
    : elasticity_(elasticity), terms_(static_cast<std::size_t>(kCount) * kTerms, kNothing) {
    const FilmEquation equation(elasticity);
    for (std::int64_t cell = 0; cell < kCount; ++cell) {
        fit(equation, cell);
        errorBound_ = std::max(errorBound_, kNodeSafety * measure(equation, cell));
    }
    end_ = within(std::nextafter(largestRatio(), 0.0));
    indentationPower_ = end_.ratio * end_.indentationRate / end_.indentation;
    forcePower_ = end_.ratio * end_.indentationRate * end_.stiffness / end_.force;
    findHalfSpaceLimit();
}

FilmRatios FilmTable::valueAt(const Term* terms, double place) {
    FilmRatios sum = kNothing;
    for (std::size_t power = 0; power < kTerms; ++power) {
        addScaled(sum, std::pow(place, static_cast<double>(power)), terms[power]);
    }
    return sum;
}

void FilmTable::fit(const FilmEquation& equation, std::int64_t cell) {
    static const ChebyshevFit chebyshev(kTerms);
    Term* terms = terms_.data() + (static_cast<std::size_t>(cell) * kTerms);
    for (std::size_t node = 0; node < kTerms; ++node) {
        const double place = chebyshev.nodes()[node];
        const FilmRatios exact = equation.solve(kCells.valueAt(kFirst + cell, place) - kNear);
        for (std::size_t power = 0; power < kTerms; ++power) {
            addScaled(terms[power], chebyshev.weight(power, node), exact);
        }
    }
    // A straight line makes both ends exact, so that there is no step where cells meet.
    for (const double end : {-1.0, 1.0}) {
        FilmRatios missing = equation.solve(kCells.valueAt(kFirst + cell, end) - kNear);
        addScaled(missing, -1.0, valueAt(terms, end));
        addScaled(terms[0], 0.5, missing);
        addScaled(terms[1], 0.5 * end, missing);
    }
}

double FilmTable::measure(const FilmEquation& equation, std::int64_t cell) const {
    static const ChebyshevFit chebyshev(kTerms);
    const Term* terms = terms_.data() + (static_cast<std::size_t>(cell) * kTerms);
    double worst = 0.0;
    for (const double place : chebyshev.worstPlaces()) {
        const FilmRatios exact = equation.solve(kCells.valueAt(kFirst + cell, place) - kNear);
        const FilmRatios found = valueAt(terms, place);
        worst = std::max({worst, relativeError(found.indentation, exact.indentation),
                          relativeError(found.force, exact.force),
                          relativeError(found.stiffness, exact.stiffness),
                          relativeError(found.energy, exact.energy)});
    }
    return worst;
}

/// The half-space's contact radius at an indentation is the root of R times that.
void FilmTable::findHalfSpaceLimit() {
    const auto excess = [this](double ratio) {
        const FilmPoint point = within(ratio);
        return point.force - (kStiffened * kHertz * std::pow(point.indentation, 1.5));
    };
    constexpr double kMinContact = 1e-6;
    halfSpaceLimit_ =
        excess(end_.ratio) < 0.0
            ? std::numeric_limits<double>::infinity()
            : std::sqrt(within(rootBetween(excess, kMinContact, end_.ratio)).indentation);
}

FilmTable::Place FilmTable::placeOf(double ratio) const noexcept {
    const double value = kNear + ratio;
    const std::int64_t cell = kCells.cellOf(value);
    const double width = kCells.valueAt(cell, 1.0) - kCells.valueAt(cell, -1.0);
    return {.terms = terms_.data() + (static_cast<std::size_t>(cell - kFirst) * kTerms),
            .place = kCells.placeOf(value),
            .rate = 2.0 / width};
}

FilmPoint FilmTable::within(double ratio) const noexcept {
    const Place at = placeOf(ratio);
    double indentation = 0.0;
    double rate = 0.0;
    double force = 0.0;
    double stiffness = 0.0;
    double energy = 0.0;
    for (std::size_t power = kTerms; power-- > 0;) {
        const Term& term = at.terms[power];
        rate = (rate * at.place) + indentation;
        indentation = (indentation * at.place) + term.indentation;
        force = (force * at.place) + term.force;
        stiffness = (stiffness * at.place) + term.stiffness;
        energy = (energy * at.place) + term.energy;
    }
    const double square = ratio * ratio;
    return {.ratio = ratio,
            .indentation = square * indentation,
            .indentationRate = ratio * ((2.0 * indentation) + (ratio * rate * at.rate)),
            .force = kHertz * square * ratio * force,
            .stiffness = 2.0 * ratio * stiffness,
            .energy = kHertzEnergy * square * square * ratio * energy};
}

FilmPoint FilmTable::beyond(double ratio) const noexcept {
    const double growth = ratio / end_.ratio;
    const double indentation = end_.indentation * std::pow(growth, indentationPower_);
    const double force = end_.force * std::pow(growth, forcePower_);
    const double both = indentationPower_ + forcePower_;
    return {.ratio = ratio,
            .indentation = indentation,
            .indentationRate = indentationPower_ * indentation / ratio,
            .force = force,
            .stiffness = forcePower_ / indentationPower_ * force / indentation,
            .energy = end_.energy + (indentationPower_ / both *
                                     ((force * indentation) - (end_.force * end_.indentation)))};
}

FilmPoint FilmTable::at(double ratio) const noexcept {
    return ratio < end_.ratio ? within(ratio) : beyond(ratio);
}

FilmPoint FilmTable::onSpring(double value, double compliance) const noexcept {
    if (!(value > 0.0)) {
        return {};
    }
    constexpr double kRounding = 4.0 * std::numeric_limits<double>::epsilon();
    const auto held = [&](double ratio) {
        const FilmPoint point = at(ratio);
        const double approach = point.indentation + (compliance * point.force);
        return Rise{.value = approach,
                    .rate = point.indentationRate * (1.0 + (compliance * point.stiffness)),
                    .rounding = kRounding * approach};
    };
    // On a half-space each term alone bounds the contact radius from above.
    double widest = std::sqrt(value);
    if (compliance > 0.0) {
        widest = std::min(widest, std::cbrt(value / (kHertz * compliance)));
    }
    FilmPoint point = at(RisingSearch(0.0, 0.0, value).solve(held, widest));
    // Where cells meet, rounding may leave no root to find: the balance holds there, too.
    const double missing = (value - point.indentation - (compliance * point.force)) /
                           (1.0 + (compliance * point.stiffness));
    point.indentation += missing;
    point.force += point.stiffness * missing;
    return point;
}

FilmTable::Profile FilmTable::profileAt(const Place& at) noexcept {
    Profile profile{};
    for (std::size_t power = kTerms; power-- > 0;) {
        for (std::size_t m = 0; m < kFilmProfileTerms; ++m) {
            profile[m] = (profile[m] * at.place) + at.terms[power].profile[m];
        }
    }
    return profile;
}

double FilmTable::surfaceAt(const Place& at, double distance) noexcept {
    const double value = FilmSurface::kNear + distance;
    const auto cell =
        static_cast<std::size_t>(FilmSurface::kCells.cellOf(value) - FilmSurface::kFirst);
    const double place = FilmSurface::kCells.placeOf(value);
    double sum = 0.0;
    for (std::size_t outer = FilmSurface::kTerms; outer-- > 0;) {
        const std::size_t index = (cell * FilmSurface::kTerms) + outer;
        double coefficient = 0.0;
        for (std::size_t power = kTerms; power-- > 0;) {
            coefficient = (coefficient * at.place) + at.terms[power].surface[index];
        }
        sum = (sum * place) + coefficient;
    }
    return sum;
}

/// Abel's transform of each term of the profile is a power of the height.
double FilmTable::pressure(double ratio, double height) const noexcept {
    const Profile profile = profileAt(placeOf(std::min(ratio, end_.ratio)));
    const double square = height * height;
    double sum = 0.0;
    double factor = 2.0 * height;  // 2 m times the integral of (h^2 - v^2)^(m - 1) over 0 < v < h
    for (std::size_t m = 0; m < kFilmProfileTerms; ++m) {
        sum += factor * profile[m];
        const auto next = static_cast<double>(m + 1);
        factor *= square * (2.0 * (next + 1.0)) / ((2.0 * next) + 1.0);
    }
    return ratio > end_.ratio ? sum * std::pow(ratio / end_.ratio, forcePower_ - 3.0) : sum;
}

/// That of a half-space under the same pressure, by Abel's transform of the profile, and what the
/// base takes from it.
double FilmTable::displacementWithin(double ratio, double distance) const noexcept {
    using std::numbers::pi;
    if (FilmSurface::kNear + distance >= FilmSurface::kEnd) {
        return (1.0 - elasticity_.share) * at(ratio).force / (pi * distance);
    }
    const Place at = placeOf(ratio);
    const Profile profile = profileAt(at);
    const double narrow = std::min(1.0, ratio / distance);
    if (!(narrow > 0.0)) {
        return 0.0;  // rounded away
    }
    const auto phi = [&](double angle) {
        const double place = std::sin(angle) / narrow;
        const double z = (1.0 - place) * (1.0 + place);
        double sum = 0.0;
        for (std::size_t m = kFilmProfileTerms; m-- > 0;) {
            sum = (sum + profile[m]) * z;
        }
        return sum;
    };
    const double halfSpace = gaussLegendre(phi, 0.0, std::asin(narrow));
    return 2.0 / pi * ratio * ratio * (halfSpace + (ratio * surfaceAt(at, distance)));
}

/// Beyond the table the last shape grows in proportion, which keeps its slope at the edge; what is
/// then missing at the edge fades without a slope there.
double FilmTable::displacement(double ratio, double distance) const noexcept {
    if (ratio <= end_.ratio) {
        return displacementWithin(ratio, distance);
    }
    const auto edge = [](const FilmPoint& point) {
        return point.indentation - (0.5 * point.ratio * point.ratio);
    };
    const double growth = (ratio / end_.ratio) * (ratio / end_.ratio);
    const double outside = (distance / ratio) - 1.0;
    const double grown = growth * displacementWithin(end_.ratio, end_.ratio * (distance / ratio));
    return grown + ((edge(beyond(ratio)) - (growth * edge(end_))) * std::exp(-outside * outside));
}

std::shared_ptr<const FilmTable> sharedFilmTable(const FilmElasticity& elasticity) {
    constexpr std::size_t kKept = 16;
    static std::mutex mutex;
    static std::array<std::shared_ptr<const FilmTable>, kKept> kept;
    static std::size_t next = 0;
    const std::lock_guard lock(mutex);
    const auto found = std::ranges::find_if(
        kept, [&](const auto& table) { return table && table->elasticity() == elasticity; });
    if (found != kept.end()) {
        return *found;
    }
    kept[next] = std::make_shared<const FilmTable>(elasticity);
    return kept[std::exchange(next, (next + 1) % kKept)];
}

}  // namespace asperity
