#include "core/contact/laws/FilmEquation.h"

#include "core/Error.h"
#include "core/contact/Within.h"
#include "core/contact/numerics/ChebyshevFit.h"

#include <Eigen/LU>

#include <cmath>
#include <numbers>

namespace asperity {

namespace {

constexpr int kPanelNodes = 16;    // of the quadrature over wave numbers
constexpr int kPanels = 16;        // equally wide
constexpr double kMaxWave = 22.0;  // where L - 1 has fallen below rounding
constexpr int kNodes = 32;         // of the quadrature over the contact

struct Quadrature {
    Eigen::VectorXd places;
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
        rule.places(i) = 0.5 * (1.0 - x);
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
            const double k = kWidth * (panel + rule.places(i));
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
    const auto cosines = [&](const Eigen::VectorXd& places) {
        Eigen::MatrixXd values(places.size(), waves);
        for (Eigen::Index k = 0; k < waves; ++k) {
            const double number = ratio * waves_[static_cast<std::size_t>(k)].number;
            values.col(k) = (number * places.array()).cos();
        }
        return values;
    };
    Eigen::VectorXd kernel(waves);
    for (Eigen::Index k = 0; k < waves; ++k) {
        kernel(k) = waves_[static_cast<std::size_t>(k)].weight;
    }
    const Eigen::MatrixXd onNodes = cosines(rule.places);
    // The wave amplitudes of a function that is given at the nodes, weighted by the kernel.
    const Eigen::MatrixXd amplitudes =
        kernel.asDiagonal() * onNodes.transpose() * rule.weights.asDiagonal();
    const double scale = 2.0 * ratio / std::numbers::pi;
    Eigen::MatrixXd operation = scale * onNodes * amplitudes;
    operation.diagonal().array() += 1.0;
    Eigen::MatrixXd right(kNodes, 2);
    right.col(0).setOnes();
    right.col(1) = rule.places.array().square();
    const Eigen::MatrixXd solution = operation.partialPivLu().solve(right);
    const Eigen::MatrixXd outgoing = amplitudes * solution;

    // The profile's nodes and, last, the edge.
    Eigen::VectorXd places(kFilmProfileTerms + 1);
    for (std::size_t i = 0; i < kFilmProfileTerms; ++i) {
        places(static_cast<Eigen::Index>(i)) = std::sqrt(0.5 * (1.0 - fit.nodes()[i]));
    }
    places(kFilmProfileTerms) = 1.0;
    Eigen::MatrixXd there = -scale * cosines(places) * outgoing;
    there.col(0).array() += 1.0;
    there.col(1).array() += places.array().square();

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

}  // namespace asperity
