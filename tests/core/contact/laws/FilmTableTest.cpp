#include "core/contact/laws/FilmTable.h"

#include "core/Error.h"
#include "core/contact/numerics/GaussLegendre.h"
#include "tests/support/AllocationCounter.h"
#include "tests/support/ReferenceTable.h"

#include <Eigen/QR>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace asperity {
namespace {

using std::numbers::pi;

constexpr double kHertz = 4.0 / 3.0;

/// Poisson ratios over the whole range.
const std::vector<double>& poissonRatios() {
    static const std::vector<double> ratios{0.0, 0.1, 0.25, 0.3, 0.4, 0.45, 0.49, 0.5};
    return ratios;
}

double relativeError(double value, double exact) { return std::abs((value / exact) - 1.0); }

/// Force over Hertz' at the same indentation.
double stiffening(const FilmPoint& point) {
    return point.force / (kHertz * std::pow(point.indentation, 1.5));
}

TEST(FilmTable, EqualsTheReference) {
    const test::ReferenceTable reference = test::referenceTable("T22_film_exact.csv");
    ASSERT_EQ(reference.rows(), 65U);
    for (std::size_t row = 0; row < reference.rows(); ++row) {
        SCOPED_TRACE(row);
        const auto table = sharedFilmTable({.poissonRatio = reference.number(row, "nu")});
        const double chi = reference.number(row, "chi");
        const double ratio = reference.number(row, "a_over_t");
        const FilmPoint point = table->onSpring(chi * chi, 0.0);
        EXPECT_LT(relativeError(point.ratio, ratio), 1e-9);
        EXPECT_LT(relativeError(stiffening(point), reference.number(row, "force_factor")), 1e-9);
        EXPECT_LT(relativeError(table->at(ratio).indentation, chi * chi), 1e-9);
    }
}

TEST(FilmTable, IsNeverOffByMoreThanItsBound) {
    for (const FilmElasticity elasticity :
         {FilmElasticity{0.0, 1.0}, FilmElasticity{0.3, 0.7}, FilmElasticity{0.47, 1.0},
          FilmElasticity{0.5, 1.0}, FilmElasticity{0.5, 0.1}}) {
        SCOPED_TRACE(elasticity.poissonRatio);
        const FilmTable table(elasticity);
        const FilmEquation equation(elasticity);
        EXPECT_GT(table.errorBound(), 0.0);
        EXPECT_LT(table.errorBound(), 2e-9);
        for (double ratio = 1e-3; ratio < FilmTable::largestRatio();
             ratio = (1.07 * ratio) + 1e-3) {
            const FilmRatios exact = equation.solve(ratio);
            const FilmPoint point = table.at(ratio);
            const double cube = ratio * ratio * ratio;
            EXPECT_LT(relativeError(point.indentation, ratio * ratio * exact.indentation),
                      table.errorBound());
            EXPECT_LT(relativeError(point.force, kHertz * cube * exact.force), table.errorBound());
            EXPECT_LT(relativeError(point.stiffness, 2.0 * ratio * exact.stiffness),
                      table.errorBound());
            EXPECT_LT(relativeError(point.energy, 8.0 / 15.0 * cube * ratio * ratio * exact.energy),
                      table.errorBound());
        }
    }
}

/// Compliance for a wave, by the hyperbolic form of the textbooks.
double complianceOf(double nu, double k) {
    if (k > 30.0) {
        return 1.0;
    }
    const double kappa = 3.0 - (4.0 * nu);
    return ((2.0 * kappa * std::sinh(2.0 * k)) - (4.0 * k)) /
           ((2.0 * kappa * std::cosh(2.0 * k)) + 1.0 + (kappa * kappa) + (4.0 * k * k));
}

/// A contact solved for its pressure, without Abel's transform: E* a / R times powers n - 1/2 of
/// 1 - s^2 such that the surface takes the tip's shape at points of the contact, by least squares.
class DirectSolution {
public:
    DirectSolution(double nu, double ratio) : waves_(kTerms) {
        for (int n = 1; n <= kTerms; ++n) {
            const double factor = std::tgamma(n + 0.5) * std::pow(2.0, n) / std::sqrt(pi);
            for (double k = 0.5 * kStep; k < kMaxWave; k += kStep) {
                waves_[n - 1].push_back(2.0 * kStep * complianceOf(nu, k / ratio) * factor *
                                        std::sph_bessel(n, k) / std::pow(k, n));
            }
        }
        constexpr int kPoints = 12;
        Eigen::MatrixXd left(kPoints, kTerms + 1);
        Eigen::VectorXd right(kPoints);
        for (int i = 0; i < kPoints; ++i) {
            const double s = (i + 0.5) / kPoints;
            for (int n = 1; n <= kTerms; ++n) {
                left(i, n - 1) = displacementBy(n, s);
            }
            left(i, kTerms) = -1.0;  // the indentation
            right(i) = -0.5 * s * s;
        }
        found_ = left.colPivHouseholderQr().solve(right);
    }

    /// Over a^2 / R.
    [[nodiscard]] double indentation() const { return found_(kTerms); }
    /// Over (4/3) E* a^3 / R.
    [[nodiscard]] double force() const {
        double sum = 0.0;
        for (int n = 1; n <= kTerms; ++n) {
            sum += found_(n - 1) * 2.0 * pi / ((2.0 * n) + 1.0) / kHertz;
        }
        return sum;
    }
    /// In the middle, over E* a / (pi R).
    [[nodiscard]] double pressure() const { return pi * found_.head(kTerms).sum(); }
    /// At s, over a^2 / R.
    [[nodiscard]] double displacement(double s) const {
        double sum = 0.0;
        for (int n = 1; n <= kTerms; ++n) {
            sum += found_(n - 1) * displacementBy(n, s);
        }
        return sum;
    }

private:
    static constexpr int kTerms = 6;
    static constexpr double kMaxWave = 800.0;
    static constexpr double kStep = 0.06;

    [[nodiscard]] double displacementBy(int n, double s) const {
        double sum = 0.0;
        double k = 0.5 * kStep;
        for (const double wave : waves_[n - 1]) {
            sum += wave * ::j0(k * s);
            k += kStep;
        }
        return sum;
    }

    std::vector<std::vector<double>> waves_;  ///< by power: Hankel's transform of its displacement
    Eigen::VectorXd found_;
};

TEST(FilmTable, EqualsASolutionForThePressureItself) {
    for (const auto& [nu, ratio] :
         {std::pair{0.5, 0.5}, std::pair{0.5, 2.0}, std::pair{0.3, 1.0}, std::pair{0.0, 2.0}}) {
        SCOPED_TRACE(nu);
        const DirectSolution direct(nu, ratio);
        const auto table = sharedFilmTable({.poissonRatio = nu});
        const FilmPoint point = table->at(ratio);
        const double square = ratio * ratio;
        EXPECT_LT(relativeError(point.indentation, square * direct.indentation()), 1e-4);
        EXPECT_LT(relativeError(point.force, kHertz * square * ratio * direct.force()), 1e-4);
        EXPECT_LT(relativeError(table->pressure(ratio, 1.0), direct.pressure()), 1e-3);
        EXPECT_NEAR(table->displacement(ratio, 1.5 * ratio), square * direct.displacement(1.5),
                    1e-4 * point.indentation);
    }
}

/// The coefficient of the literature (Dimitriadis et al. 2002) is a fit, worst for small ratios.
TEST(FilmTable, StiffensToFirstOrderAsTheLiteratureHasIt) {
    for (const double nu : poissonRatios()) {
        SCOPED_TRACE(nu);
        const double chi = 1e-5;
        const FilmPoint point = sharedFilmTable({.poissonRatio = nu})->onSpring(chi * chi, 0.0);
        const double fit = 2.0 / pi * (1.2876 - (1.4678 * nu) + (1.3442 * nu * nu)) / (1.0 - nu);
        EXPECT_NEAR((stiffening(point) - 1.0) / chi, fit, (nu < 0.2 ? 0.07 : 0.02) * fit);
    }
    const FilmPoint rubber = sharedFilmTable({.poissonRatio = 0.5})->onSpring(1e-10, 0.0);
    EXPECT_NEAR((stiffening(rubber) - 1.0) / 1e-5, 1.127, 5e-4);
}

TEST(FilmTable, OfATipThatIsFarSofterIsAHalfSpace) {
    const FilmTable table({.poissonRatio = 0.5, .share = 0.0});
    for (const double ratio : {0.1, 1.0, 7.0, 100.0}) {
        EXPECT_LT(relativeError(stiffening(table.at(ratio)), 1.0), 1e-9);
        EXPECT_LT(relativeError(table.at(ratio).indentation, ratio * ratio), 1e-9);
        EXPECT_LT(relativeError(table.pressure(ratio, 0.6), 1.2), 1e-9);
    }
    EXPECT_EQ(table.halfSpaceLimit(), std::numeric_limits<double>::infinity());
}

/// Under a wide tip each column of a film of Poisson ratio 0 is compressed by itself.
TEST(FilmTable, TendsToColumnsUnderAWideTip) {
    const auto table = sharedFilmTable({.poissonRatio = 0.0});
    double before = 2.0;
    for (const double ratio : {1.0, 2.0, 4.0, 7.0}) {
        const double off = (table->at(ratio).force / (pi / 4.0 * std::pow(ratio, 4.0))) - 1.0;
        EXPECT_GT(off, 0.0);
        EXPECT_LT(off, 0.55 * before);
        before = off;
    }
    EXPECT_LT(relativeError(table->at(7.0).indentation, 0.5 * 49.0), 0.06);
}

/// Force over indentation of a step, and what the stiffness and the energy say of it.
void expectConsistent(const FilmTable& table, double ratio) {
    const double step = 1e-5 * ratio;
    const FilmPoint here = table.at(ratio);
    const FilmPoint below = table.at(ratio - step);
    const FilmPoint above = table.at(ratio + step);
    const double way = above.indentation - below.indentation;
    EXPECT_LT(relativeError(way / (2.0 * step), here.indentationRate), 1e-8);
    EXPECT_LT(relativeError((above.force - below.force) / way, here.stiffness), 1e-8);
    EXPECT_LT(relativeError((above.energy - below.energy) / way, here.force), 1e-8);
}

TEST(FilmTable, HasTheStiffnessAndTheEnergyOfItsForce) {
    for (const double nu : poissonRatios()) {
        SCOPED_TRACE(nu);
        const auto table = sharedFilmTable({.poissonRatio = nu});
        for (const double ratio : {0.01, 0.2, 0.49, 0.7, 1.2, 2.0, 3.0, 7.0, 9.0, 100.0}) {
            SCOPED_TRACE(ratio);
            expectConsistent(*table, ratio);
        }
    }
}

TEST(FilmTable, GoesOnWithoutAStepBeyondItsEnd) {
    for (const double nu : poissonRatios()) {
        SCOPED_TRACE(nu);
        const auto table = sharedFilmTable({.poissonRatio = nu});
        const double end = FilmTable::largestRatio();
        const FilmPoint before = table->at(end * (1.0 - 1e-12));
        const FilmPoint after = table->at(end * (1.0 + 1e-12));
        EXPECT_LT(relativeError(after.indentation, before.indentation), 1e-10);
        EXPECT_LT(relativeError(after.force, before.force), 1e-10);
        EXPECT_LT(relativeError(after.stiffness, before.stiffness), 1e-7);
        EXPECT_LT(relativeError(after.energy, before.energy), 1e-10);
        EXPECT_LT(relativeError(table->pressure(end * (1.0 + 1e-12), 0.5),
                                table->pressure(end * (1.0 - 1e-12), 0.5)),
                  1e-9);
    }
}

TEST(FilmTable, RisesWithIndentationAndPoissonRatio) {
    std::vector<double> softer(200, 0.0);
    for (const double nu : poissonRatios()) {
        SCOPED_TRACE(nu);
        const auto table = sharedFilmTable({.poissonRatio = nu});
        FilmPoint before;
        for (std::size_t i = 0; i < softer.size(); ++i) {
            const FilmPoint point = table->onSpring(1e-9 * std::pow(1.26, i), 0.0);
            EXPECT_GT(point.ratio, before.ratio);
            EXPECT_GT(point.force, before.force);
            EXPECT_GT(point.stiffness, before.stiffness);
            EXPECT_GT(point.energy, before.energy);
            if (point.ratio < FilmTable::largestRatio()) {
                EXPECT_GT(point.force, softer[i]);
            }
            before = point;
            softer[i] = point.force;
        }
    }
}

TEST(FilmTable, BalancesAnySpring) {
    for (const double nu : {0.0, 0.5}) {
        const auto table = sharedFilmTable({.poissonRatio = nu});
        for (const double value : {1e-300, 1e-30, 1e-9, 0.1, 1.0, 1e3, 1e10, 1e27}) {
            for (const double compliance : {0.0, 1e-30, 1e-3, 1.0, 1e9, 1e21}) {
                SCOPED_TRACE(value);
                const FilmPoint point = table->onSpring(value, compliance);
                EXPECT_LT(relativeError(point.indentation + (compliance * point.force), value),
                          1e-13);
                EXPECT_TRUE(std::isfinite(point.energy) && std::isfinite(point.stiffness));
            }
        }
    }
}

/// There is no step, neither in the balance nor in the force.
TEST(FilmTable, BalancesWhereItsCellsMeet) {
    for (const double nu : poissonRatios()) {
        const auto table = sharedFilmTable({.poissonRatio = nu});
        for (const double ratio : {0.25, 0.5, 1.0, 1.5, 2.5, 3.5, 5.5, 7.5}) {
            const double value = table->at(ratio).indentation;
            double before = 0.0;
            for (int i = -40; i <= 40; ++i) {
                const double asked = value * (1.0 + (i * 5e-12));
                const FilmPoint point = table->onSpring(asked, 0.0);
                EXPECT_LT(relativeError(point.indentation, asked), 1e-14);
                EXPECT_GT(point.force, before);
                before = point.force;
            }
        }
    }
}

TEST(FilmTable, KnowsWhereAHalfSpaceIsFivePercentSofter) {
    for (const double nu : poissonRatios()) {
        SCOPED_TRACE(nu);
        const auto table = sharedFilmTable({.poissonRatio = nu});
        const double limit = table->halfSpaceLimit();
        EXPECT_NEAR(stiffening(table->onSpring(limit * limit, 0.0)), 1.05, 1e-9);
    }
    EXPECT_NEAR(sharedFilmTable({.poissonRatio = 0.5})->halfSpaceLimit(), 1.0 / 24.0, 1e-3);
}

TEST(FilmTable, PressesWithItsForce) {
    for (const double nu : poissonRatios()) {
        SCOPED_TRACE(nu);
        const auto table = sharedFilmTable({.poissonRatio = nu});
        for (const double ratio : {0.0, 0.3, 1.0, 2.0, 5.0, 20.0}) {
            SCOPED_TRACE(ratio);
            const double sum = gaussLegendre(
                [&](double height) { return height * table->pressure(ratio, height); }, 0.0, 1.0);
            const double hertz =
                ratio == 0.0 ? 1.0 : table->at(ratio).force / (kHertz * std::pow(ratio, 3.0));
            EXPECT_LT(relativeError(1.5 * sum, hertz), 1e-8);
            EXPECT_GT(table->pressure(ratio, 0.1), 0.0);
        }
    }
}

/// Outside of the contact the surface leaves the tip as Hertz' does, smoothly.
TEST(FilmTable, LeavesTheTipAtTheEdge) {
    for (const FilmElasticity elasticity : {FilmElasticity{0.5, 1.0}, FilmElasticity{0.2, 0.6}}) {
        const auto table = sharedFilmTable(elasticity);
        for (const double ratio : {0.01, 0.5, 2.0, 7.0, 30.0}) {
            SCOPED_TRACE(ratio);
            const FilmPoint point = table->at(ratio);
            const double edge = point.indentation - (0.5 * ratio * ratio);
            EXPECT_NEAR(table->displacement(ratio, ratio), edge, 1e-5 * point.indentation);
            for (const double outside : {1e-3, 0.01, 0.1, 0.5, 1.0, 3.0}) {
                const double distance = ratio * (1.0 + outside);
                const double gap = (0.5 * distance * distance) - point.indentation +
                                   table->displacement(ratio, distance);
                EXPECT_GT(gap, -1e-5 * point.indentation) << outside;
            }
            EXPECT_LT(std::abs(table->displacement(ratio, 100.0 * ratio)),
                      0.01 * point.indentation);
        }
    }
}

/// What an incompressible film loses under the tip it gains around it.
TEST(FilmTable, KeepsTheVolumeOfAnIncompressibleFilm) {
    const auto table = sharedFilmTable({.poissonRatio = 0.5});
    for (const double ratio : {0.1, 1.0, 2.0}) {
        const double square = ratio * ratio;
        const double inside =
            0.5 * square * (table->at(ratio).indentation - (0.25 * square));  // times 2 pi
        double outside = 0.0;
        for (double r = ratio; r < 15.0; r += 0.1) {
            outside += gaussLegendre([&](double at) { return at * table->displacement(ratio, at); },
                                     r, r + 0.1);
        }
        EXPECT_NEAR(outside, -inside, 1e-3 * inside);
    }
}

TEST(FilmTable, IsSharedAndUsedWithoutAllocating) {
    const auto table = sharedFilmTable({.poissonRatio = 0.35});
    EXPECT_EQ(sharedFilmTable({.poissonRatio = 0.35}), table);
    EXPECT_NE(sharedFilmTable({.poissonRatio = 0.35, .share = 0.9}), table);
    const std::size_t before = test::allocationCount();
    double sum = 0.0;
    for (double value = 1e-6; value < 1e6; value *= 1.7) {
        const FilmPoint point = table->onSpring(value, 0.1);
        sum += point.force + table->pressure(point.ratio, 0.3) +
               table->displacement(point.ratio, 1.1 * point.ratio);
    }
    EXPECT_EQ(test::allocationCount(), before);
    EXPECT_TRUE(std::isfinite(sum));
}

TEST(FilmTable, RefusesWhatIsNoFilm) {
    const double nan = std::nan("");
    for (const FilmElasticity elasticity :
         {FilmElasticity{-0.1, 1.0}, FilmElasticity{0.51, 1.0}, FilmElasticity{nan, 1.0},
          FilmElasticity{0.3, -0.1}, FilmElasticity{0.3, 1.1}, FilmElasticity{0.3, nan}}) {
        EXPECT_THROW(FilmTable{elasticity}, Error);
    }
}

}  // namespace
}  // namespace asperity
