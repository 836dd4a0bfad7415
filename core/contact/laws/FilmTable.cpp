#include "core/contact/laws/FilmTable.h"

#include "core/Error.h"
#include "core/contact/Within.h"
#include "core/contact/numerics/ChebyshevFit.h"
#include "core/contact/numerics/RootSearch.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <numbers>
#include <utility>

namespace asperity {

namespace {

constexpr int kPanelNodes = 16;    // of the quadrature over wave numbers
constexpr int kPanels = 16;        // equally wide
constexpr double kMaxWave = 22.0;  // where L - 1 has fallen below rounding
constexpr int kNodes = 32;         // of the quadrature over the contact

struct Quadrature {
    Eigen::VectorXd positions;
    Eigen::VectorXd weights;
};

/// Gauss and Legendre's rule on 0 .. 1, by Newton's method on the Legendre polynomial.
Quadrature gaussRule(int count) {
    constexpr int kIterations = 8;
    Quadrature rule{Eigen::VectorXd(count), Eigen::VectorXd(count)};
    for (int i = 0; i < count; ++i) {
        double x = std::cos(std::numbers::pi * (i + 0.75) / (count + 0.5));
        double slope = 0.0;
        for (int iteration = 0; iteration < kIterations; ++iteration) {
            double value = 1.0;
            double before = 0.0;
            for (int n = 1; n <= count; ++n) {
                const double next = (((2.0 * n) - 1.0) * x * value - (n - 1.0) * before) / n;
                before = value;
                value = next;
            }
            slope = count * (x * value - before) / (x * x - 1.0);
            x -= value / slope;
        }
        rule.positions(i) = 0.5 * (1.0 - x);
        rule.weights(i) = 1.0 / ((1.0 - x * x) * slope * slope);
    }
    return rule;
}

/// Compliance of a bonded film for a wave of this number times thickness, over that of a half-space
/// of the same material. @param kappa 3 - 4 nu
double filmCompliance(double kappa, double k) {
    const double once = std::exp(-2.0 * k);
    const double twice = once * once;
    return (kappa * (1.0 - twice) - 4.0 * k * once) /
           (kappa * (1.0 + twice) + (4.0 * k * k + 1.0 + kappa * kappa) * once);
}

/// Coefficients of phi / z as a polynomial in z = 1 - x^2. @param phi at the fit's nodes
std::array<double, kFilmProfileTerms> profileOf(const ChebyshevFit& fit,
                                                const Eigen::VectorXd& phi) {
    // In powers of 2 z - 1, where the fit is well conditioned.
    std::array<double, kFilmProfileTerms> centerd{};
    for (std::size_t power = 0; power < kFilmProfileTerms; ++power) {
        for (std::size_t node = 0; node < kFilmProfileTerms; ++node) {
            const double z = 0.5 * (1.0 + fit.nodes()[node]);
            centerd[power] += fit.weight(power, node) * phi(static_cast<Eigen::Index>(node)) / z;
        }
    }
    std::array<double, kFilmProfileTerms> powers{};
    for (std::size_t k = kFilmProfileTerms; k-- > 0;) {  // Horner's rule: times 2 z - 1, plus
        for (std::size_t m = kFilmProfileTerms; m-- > 0;) {
            powers[m] = (m > 0 ? 2.0 * powers[m - 1] : 0.0) - powers[m];
        }
        powers[0] += centerd[k];
    }
    return powers;
}

constexpr double kHertz = 4.0 / 3.0;         // force over a^3
constexpr double kHertzEnergy = 8.0 / 15.0;  // energy over a^5
constexpr double kStiffened = 1.05;          // from which force over a half-space's it is flagged
/// The error between the positions where it is measured.
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

FilmEquation::FilmEquation(const FilmElasticity& elasticity) {
    if (!isWithin(elasticity.poissonRatio, 0.0, 0.5) || !isWithin(elasticity.share, 0.0, 1.0)) {
        throw Error("film: expected a Poisson ratio from 0 to 0.5 and a share from 0 to 1");
    }
    const double kappa = 3.0 - (4.0 * elasticity.poissonRatio);
    const Quadrature rule = gaussRule(kPanelNodes);
    constexpr double kWidth = kMaxWave / kPanels;
    for (int panel = 0; panel < kPanels; ++panel) {
        for (int i = 0; i < kPanelNodes; ++i) {
            const double k = kWidth * (panel + rule.positions(i));
            waves_.push_back({k, kWidth * rule.weights(i) * elasticity.share *
                                     (filmCompliance(kappa, k) - 1.0)});
            addSurfaceOf(k);
        }
    }
}

void FilmEquation::addSurfaceOf(double number) {
    static const ChebyshevFit fit(FilmSurface::kTerms);
    for (std::size_t cell = 0; cell < FilmSurface::kCount; ++cell) {
        std::array<double, FilmSurface::kTerms> powers{};
        for (std::size_t node = 0; node < FilmSurface::kTerms; ++node) {
            const double distance =
                FilmSurface::kCells.valueAt(FilmSurface::kFirst + static_cast<std::int64_t>(cell),
                                            fit.nodes()[node]) -
                FilmSurface::kNear;
            const double value = ::j0(number * distance);
            for (std::size_t power = 0; power < FilmSurface::kTerms; ++power) {
                powers[power] += fit.weight(power, node) * value;
            }
        }
        surfaceOfWaves_.insert(surfaceOfWaves_.end(), powers.begin(), powers.end());
    }
}

/// In units of the contact radius, s = x / a, and of a^2 / R: phi = D h - g with (1 + K) h = 1 and
/// (1 + K) g = s^2, and D such that phi(1) = 0. As d phi / d a is h times d indentation / d a, the
/// integral of h is the stiffness.
FilmRatios FilmEquation::solve(double ratio) const {
    static const Quadrature rule = gaussRule(kNodes);
    static const ChebyshevFit fit(kFilmProfileTerms);
    const auto waves = static_cast<Eigen::Index>(waves_.size());
    const auto cosines = [&](const Eigen::VectorXd& positions) {
        Eigen::MatrixXd values(positions.size(), waves);
        for (Eigen::Index k = 0; k < waves; ++k) {
            const double number = ratio * waves_[static_cast<std::size_t>(k)].number;
            values.col(k) = (number * positions.array()).cos();
        }
        return values;
    };
    Eigen::VectorXd kernel(waves);
    for (Eigen::Index k = 0; k < waves; ++k) {
        kernel(k) = waves_[static_cast<std::size_t>(k)].weight;
    }
    const Eigen::MatrixXd onNodes = cosines(rule.positions);
    // The wave amplitudes of a function that is given at the nodes, weighted by the kernel.
    const Eigen::MatrixXd amplitudes =
        kernel.asDiagonal() * onNodes.transpose() * rule.weights.asDiagonal();
    const double scale = 2.0 * ratio / std::numbers::pi;
    Eigen::MatrixXd operation = scale * onNodes * amplitudes;
    operation.diagonal().array() += 1.0;
    Eigen::MatrixXd right(kNodes, 2);
    right.col(0).setOnes();
    right.col(1) = rule.positions.array().square();
    const Eigen::MatrixXd solution = operation.partialPivLu().solve(right);
    const Eigen::MatrixXd outgoing = amplitudes * solution;

    // The profile's nodes and, last, the edge.
    Eigen::VectorXd positions(kFilmProfileTerms + 1);
    for (std::size_t i = 0; i < kFilmProfileTerms; ++i) {
        positions(static_cast<Eigen::Index>(i)) = std::sqrt(0.5 * (1.0 - fit.nodes()[i]));
    }
    positions(kFilmProfileTerms) = 1.0;
    Eigen::MatrixXd there = -scale * cosines(positions) * outgoing;
    there.col(0).array() += 1.0;
    there.col(1).array() += positions.array().square();

    const double depth = there(kFilmProfileTerms, 1) / there(kFilmProfileTerms, 0);
    const Eigen::VectorXd phi = depth * solution.col(0) - solution.col(1);
    const double force = rule.weights.dot(phi);
    const double moment = rule.weights.dot((phi.array() * right.col(1).array()).matrix());
    FilmRatios ratios{.indentation = depth,
                      .force = 1.5 * force,
                      .stiffness = rule.weights.dot(solution.col(0)),
                      .energy = 15.0 / 8.0 * (depth * force - moment),
                      .profile = profileOf(fit, depth * there.col(0) - there.col(1))};
    const Eigen::Map<const Eigen::MatrixXd> surfaceOfWaves(
        surfaceOfWaves_.data(), static_cast<Eigen::Index>(ratios.surface.size()), waves);
    Eigen::Map<Eigen::VectorXd>(ratios.surface.data(), surfaceOfWaves.rows()) =
        surfaceOfWaves * (depth * outgoing.col(0) - outgoing.col(1));
    return ratios;
}

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

FilmRatios FilmTable::valueAt(const Term* terms, double position) {
    FilmRatios sum = kNothing;
    for (std::size_t power = 0; power < kTerms; ++power) {
        addScaled(sum, std::pow(position, static_cast<double>(power)), terms[power]);
    }
    return sum;
}

void FilmTable::fit(const FilmEquation& equation, std::int64_t cell) {
    static const ChebyshevFit chebyshev(kTerms);
    Term* terms = terms_.data() + (static_cast<std::size_t>(cell) * kTerms);
    for (std::size_t node = 0; node < kTerms; ++node) {
        const double position = chebyshev.nodes()[node];
        const FilmRatios exact = equation.solve(kCells.valueAt(kFirst + cell, position) - kNear);
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
    for (const double position : chebyshev.worstPositions()) {
        const FilmRatios exact = equation.solve(kCells.valueAt(kFirst + cell, position) - kNear);
        const FilmRatios found = valueAt(terms, position);
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

FilmTable::Position FilmTable::positionOf(double ratio) const noexcept {
    const double value = kNear + ratio;
    const std::int64_t cell = kCells.cellOf(value);
    const double width = kCells.valueAt(cell, 1.0) - kCells.valueAt(cell, -1.0);
    return {.terms = terms_.data() + (static_cast<std::size_t>(cell - kFirst) * kTerms),
            .position = kCells.positionOf(value),
            .rate = 2.0 / width};
}

FilmPoint FilmTable::within(double ratio) const noexcept {
    const Position at = positionOf(ratio);
    double indentation = 0.0;
    double rate = 0.0;
    double force = 0.0;
    double stiffness = 0.0;
    double energy = 0.0;
    for (std::size_t power = kTerms; power-- > 0;) {
        const Term& term = at.terms[power];
        rate = (rate * at.position) + indentation;
        indentation = (indentation * at.position) + term.indentation;
        force = (force * at.position) + term.force;
        stiffness = (stiffness * at.position) + term.stiffness;
        energy = (energy * at.position) + term.energy;
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

FilmTable::Profile FilmTable::profileAt(const Position& at) noexcept {
    Profile profile{};
    for (std::size_t power = kTerms; power-- > 0;) {
        for (std::size_t m = 0; m < kFilmProfileTerms; ++m) {
            profile[m] = (profile[m] * at.position) + at.terms[power].profile[m];
        }
    }
    return profile;
}

double FilmTable::surfaceAt(const Position& at, double distance) noexcept {
    const double value = FilmSurface::kNear + distance;
    const auto cell =
        static_cast<std::size_t>(FilmSurface::kCells.cellOf(value) - FilmSurface::kFirst);
    const double position = FilmSurface::kCells.positionOf(value);
    double sum = 0.0;
    for (std::size_t outer = FilmSurface::kTerms; outer-- > 0;) {
        const std::size_t index = (cell * FilmSurface::kTerms) + outer;
        double coefficient = 0.0;
        for (std::size_t power = kTerms; power-- > 0;) {
            coefficient = (coefficient * at.position) + at.terms[power].surface[index];
        }
        sum = (sum * position) + coefficient;
    }
    return sum;
}

/// Abel's transform of each term of the profile is a power of the height.
double FilmTable::pressure(double ratio, double height) const noexcept {
    const Profile profile = profileAt(positionOf(std::min(ratio, end_.ratio)));
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
    const Position at = positionOf(ratio);
    const Profile profile = profileAt(at);
    const double narrow = std::min(1.0, ratio / distance);
    if (!(narrow > 0.0)) {
        return 0.0;  // rounded away
    }
    const auto phi = [&](double angle) {
        const double position = std::sin(angle) / narrow;
        const double z = (1.0 - position) * (1.0 + position);
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
