#include "core/surface/synthetic/SyntheticSurface.h"

#include "core/Error.h"
#include "core/Units.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

namespace asperity {
namespace {

struct Moments {
    double mean = 0.0;
    double rms = 0.0;  ///< about the mean
};

Moments momentsOf(const HeightMap& map) {
    Moments moments;
    const auto count = static_cast<double>(map.heights.size());
    for (const double height : map.heights) {
        moments.mean += height / count;
    }
    double square = 0.0;
    for (const double height : map.heights) {
        square += (height - moments.mean) * (height - moments.mean) / count;
    }
    moments.rms = std::sqrt(square);
    return moments;
}

TEST(EggBox, HasTheRmsAndTheGradientOfItsFormula) {
    const EggBox shape{.amplitude = 3.0_nm, .periodX = 40.0_nm, .periodY = 25.0_nm, .phaseX = 0.4};
    const ScanSize size{.columns = 160, .rows = 200, .sizeX = 200.0_nm, .sizeY = 100.0_nm};
    const HeightMap map = sampledMap(size, shape);
    EXPECT_NEAR(momentsOf(map).mean, 0.0, 1e-20);
    EXPECT_NEAR(momentsOf(map).rms, 1.5_nm, 1e-12 * 1.5_nm);
    double square = 0.0;
    for (int row = 0; row < map.rows; ++row) {
        for (int column = 0; column < map.columns; ++column) {
            const HeightSample s =
                shape.at((column + 0.5) * map.pitchX, (map.rows - row - 0.5) * map.pitchY);
            ASSERT_EQ(s.height, map.at(row, column));
            square += (s.dx * s.dx + s.dy * s.dy) / static_cast<double>(map.heights.size());
        }
    }
    const double kx = 2.0 * std::numbers::pi / 40.0_nm;
    const double ky = 2.0 * std::numbers::pi / 25.0_nm;
    EXPECT_NEAR(std::sqrt(square), 1.5_nm * std::hypot(kx, ky), 1e-12);
}

TEST(EggBox, DerivativesAreThoseOfTheHeight) {
    const EggBox shape{
        .amplitude = 1.0, .periodX = 4.0, .periodY = 3.0, .phaseX = 0.4, .phaseY = 1.1};
    const double x = 0.7;
    const double y = 0.2;
    const double step = 1e-5;
    const HeightSample s = shape.at(x, y);
    EXPECT_NEAR(s.dx, (shape.height(x + step, y) - shape.height(x - step, y)) / (2 * step), 1e-9);
    EXPECT_NEAR(s.dy, (shape.height(x, y + step) - shape.height(x, y - step)) / (2 * step), 1e-9);
    EXPECT_NEAR(s.dxx, (shape.at(x + step, y).dx - shape.at(x - step, y).dx) / (2 * step), 1e-9);
    EXPECT_NEAR(s.dxy, (shape.at(x, y + step).dx - shape.at(x, y - step).dx) / (2 * step), 1e-9);
    EXPECT_NEAR(s.dyy, (shape.at(x, y + step).dy - shape.at(x, y - step).dy) / (2 * step), 1e-9);
}

TEST(TrapezoidGrating, HasTheMeanAndRmsOfItsProfile) {
    const double pitch = 100.0_nm;
    const double depth = 20.0_nm;
    const double top = 30.0_nm;
    const double flank = 15.0_nm;
    const TrapezoidGrating shape{
        .pitch = pitch, .depth = depth, .topWidth = top, .flankWidth = flank};
    const ScanSize size{.columns = 20000, .rows = 2, .sizeX = 400.0_nm, .sizeY = 1.0_nm};
    const Moments moments = momentsOf(sampledMap(size, shape));
    const double duty = (top + flank) / pitch;
    EXPECT_NEAR(moments.mean, depth * duty, 1e-9 * depth);
    EXPECT_NEAR(moments.rms, depth * std::sqrt(duty - flank / (3.0 * pitch) - duty * duty),
                1e-6 * depth);
}

TEST(TrapezoidGrating, TurnsAndTakesVerticalWalls) {
    const TrapezoidGrating wall{.pitch = 10.0_nm, .depth = 2.0_nm, .topWidth = 4.0_nm};
    EXPECT_EQ(wall.height(3.999_nm, 0.0), 2.0_nm);
    EXPECT_EQ(wall.height(4.001_nm, 0.0), 0.0);
    EXPECT_EQ(wall.height(-0.001_nm, 0.0), 0.0);
    TrapezoidGrating turned = wall;
    turned.angle = 0.5 * std::numbers::pi;
    EXPECT_EQ(turned.height(7.0_nm, 1.0_nm), 2.0_nm);
    EXPECT_EQ(turned.height(1.0_nm, 7.0_nm), 0.0);
}

TEST(Nanoparticles, StandAsHighAsTheyAreWide) {
    const ScanSize size{.columns = 8, .rows = 8, .sizeX = 600.0_nm, .sizeY = 600.0_nm};
    for (const double tip : {0.0, 10.0_nm, 40.0_nm}) {
        const Nanoparticles shape({.count = 12,
                                   .medianRadius = 14.0_nm,
                                   .spread = 0.3,
                                   .smallest = 8.0_nm,
                                   .largest = 25.0_nm,
                                   .scanTipRadius = tip,
                                   .clearance = 2.0_nm,
                                   .seed = 3},
                                  size);
        ASSERT_EQ(shape.particles().size(), 12U);
        for (const Nanoparticles::Particle& p : shape.particles()) {
            EXPECT_GE(p.radius, 8.0_nm);
            EXPECT_LE(p.radius, 25.0_nm);
            EXPECT_DOUBLE_EQ(shape.height(p.x, p.y), 2.0 * p.radius);
            // The tip's center keeps the distance of both radii from the particle's center.
            const double off = 0.5 * p.radius;
            const double tipCenter = shape.height(p.x + off, p.y) + tip;
            EXPECT_NEAR(std::hypot(off, tipCenter - p.radius), p.radius + tip, 1e-20);
        }
    }
}

TEST(Nanoparticles, OfAWideTipReachDownToThePlane) {
    const ScanSize size{.columns = 8, .rows = 8, .sizeX = 600.0_nm, .sizeY = 600.0_nm};
    const double tip = 40.0_nm;
    const Nanoparticles shape({.count = 1,
                               .medianRadius = 10.0_nm,
                               .smallest = 9.0_nm,
                               .largest = 11.0_nm,
                               .scanTipRadius = tip},
                              size);
    const Nanoparticles::Particle& p = shape.particles().front();
    const double edge = 2.0 * std::sqrt(p.radius * tip);
    EXPECT_NEAR(shape.height(p.x + edge * (1.0 - 1e-9), p.y), 0.0, 1e-6_nm);
    EXPECT_EQ(shape.height(p.x + edge * (1.0 + 1e-9), p.y), 0.0);
}

TEST(Nanoparticles, RefuseToOverfillAScan) {
    EXPECT_THROW(
        Nanoparticles(
            {.count = 500, .medianRadius = 14.0_nm, .smallest = 8.0_nm, .largest = 25.0_nm},
            {.columns = 8, .rows = 8, .sizeX = 100.0_nm, .sizeY = 100.0_nm}),
        Error);
}

TEST(AtomicSteps, RiseByOneStepAtEachTerraceAndSlopeDownBetween) {
    const ScanSize size{.columns = 64, .rows = 64, .sizeX = 400.0_nm, .sizeY = 400.0_nm};
    const AtomicSteps shape({.stepHeight = 0.235_nm, .terraceWidth = 50.0_nm, .edgeWidth = 1.0_nm},
                            size);
    const double slope = (shape.height(110.0_nm, 0.0) - shape.height(90.0_nm, 7.0_nm)) / 20.0_nm;
    EXPECT_NEAR(slope, -0.235 / 50.0, 1e-6);
    // across the step at 125 nm
    const double rise = shape.height(145.0_nm, 0.0) - shape.height(105.0_nm, 0.0);
    EXPECT_NEAR(rise, 0.235_nm * (1.0 - 40.0 / 50.0), 1e-6_nm);
    EXPECT_NEAR(shape.height(0.0, 0.0), 0.0, 1e-6_nm);
    EXPECT_NEAR(shape.height(200.0_nm, 0.0), 0.0, 1e-6_nm);
}

/// Power of each wave of a map, by the transform's definition.
template <class Visit>
void forEachWave(const HeightMap& map, const Visit& visit) {
    const double unit = 2.0 * std::numbers::pi;
    for (int ky = 0; ky < map.rows; ++ky) {
        for (int kx = 0; kx < map.columns; ++kx) {
            std::complex<double> sum;
            for (int row = 0; row < map.rows; ++row) {
                for (int column = 0; column < map.columns; ++column) {
                    sum += map.at(row, column) *
                           std::polar(1.0, -unit * (static_cast<double>(kx * column) / map.columns +
                                                    static_cast<double>(ky * row) / map.rows));
                }
            }
            const int sx = 2 * kx > map.columns ? kx - map.columns : kx;
            const int sy = 2 * ky > map.rows ? ky - map.rows : ky;
            visit(unit * std::hypot(sx / map.sizeX(), sy / map.sizeY()),
                  std::norm(sum) / std::pow(static_cast<double>(map.heights.size()), 2));
        }
    }
}

TEST(SelfAffine, HasItsRmsAndItsGradientExactlyOnTheGrid) {
    const ScanSize size{.columns = 30, .rows = 24, .sizeX = 300.0_nm, .sizeY = 360.0_nm};
    const SelfAffine recipe{.rms = 2.0_nm,
                            .hurst = 0.7,
                            .longestWave = 300.0_nm,
                            .rollOffWave = 150.0_nm,
                            .shortestWave = 50.0_nm,
                            .seed = 4};
    const HeightMap map = selfAffineMap(size, recipe);
    EXPECT_NEAR(momentsOf(map).rms, 2.0_nm, 1e-12 * 2.0_nm);
    EXPECT_NEAR(momentsOf(map).mean, 0.0, 1e-12 * 2.0_nm);

    const double lowest = 2.0 * std::numbers::pi / 300.0_nm;
    const double rollOff = 2.0 * std::numbers::pi / 150.0_nm;
    const double highest = 2.0 * std::numbers::pi / 50.0_nm;
    double power = 0.0;          // of the formula, not yet scaled
    double gradientPower = 0.0;  // of the formula [1/m^2]
    double gradientOfMap = 0.0;  // [1]
    forEachWave(map, [&](double q, double wavePower) {
        const bool within = q > 0.999999 * lowest && q < 1.000001 * highest;
        const double density = !within       ? 0.0
                               : q < rollOff ? 1.0
                                             : std::pow(q / rollOff, -2.0 * (1.0 + 0.7));
        power += density;
        gradientPower += q * q * density;
        gradientOfMap += q * q * wavePower;
        if (!within) {
            ASSERT_LT(wavePower, 1e-24 * 1.0_nm * 1.0_nm);
        }
    });
    EXPECT_NEAR(std::sqrt(gradientOfMap), 2.0_nm * std::sqrt(gradientPower / power), 1e-12);
}

TEST(SelfAffine, IsTheSameForOneSeedAndAnotherForAnother) {
    const ScanSize size{.columns = 16, .rows = 16, .sizeX = 1.0_um, .sizeY = 1.0_um};
    const SelfAffine one{.rms = 1.0_nm,
                         .longestWave = 1.0_um,
                         .rollOffWave = 1.0_um,
                         .shortestWave = 0.1_um,
                         .seed = 1};
    SelfAffine other = one;
    other.seed = 2;
    EXPECT_EQ(selfAffineMap(size, one).heights, selfAffineMap(size, one).heights);
    EXPECT_NE(selfAffineMap(size, one).heights, selfAffineMap(size, other).heights);
}

TEST(SelfAffine, RefusesABandWithoutWaves) {
    const ScanSize size{.columns = 16, .rows = 16, .sizeX = 1.0_um, .sizeY = 1.0_um};
    EXPECT_THROW(
        (void)selfAffineMap(
            size,
            {.rms = 1.0_nm, .longestWave = 1.0_nm, .rollOffWave = 1.0_nm, .shortestWave = 0.5_nm}),
        Error);
}

TEST(Spherulites, ABareOneHasItsDomeAndRings) {
    const ScanSize size{.columns = 8, .rows = 8, .sizeX = 2.0_um, .sizeY = 2.0_um};
    const Spherulites dome({.nuclei = 1, .domeHeight = 50.0_nm, .domeRadius = 5.0_um}, size);
    double highest = 0.0;
    Vector3 center = Vector3::Zero();
    for (int i = 0; i < 400; ++i) {
        for (int j = 0; j < 400; ++j) {
            const double height = dome.height(i * 5.0_nm, j * 5.0_nm);
            if (height > highest) {
                highest = height;
                center = Vector3(i * 5.0_nm, j * 5.0_nm, height);
            }
        }
    }
    EXPECT_NEAR(highest, 50.0_nm, 0.2_nm);
    const double expected = 50.0_nm * std::pow(1.0 - 0.1, 2);
    EXPECT_NEAR(dome.height(center.x() + 0.5_um, center.y()), expected, 0.2_nm);
}

TEST(Spherulites, MeetInAGrooveWithoutAJump) {
    const ScanSize size{.columns = 8, .rows = 8, .sizeX = 2.0_um, .sizeY = 2.0_um};
    const Spherulites shape({.nuclei = 2,
                             .bandHeight = 5.0_nm,
                             .bandPeriod = 200.0_nm,
                             .fibrilHeight = 2.0_nm,
                             .fibrilLength = 200.0_nm,
                             .fibrils = 40,
                             .grooveDepth = 20.0_nm,
                             .grooveWidth = 40.0_nm,
                             .seed = 2},
                            size);
    double lowest = 0.0;
    for (int line = 0; line < 20; ++line) {
        double before = shape.height(0.0, line * 0.1_um);
        for (int i = 1; i <= 20000; ++i) {
            const double height = shape.height(i * 0.1_nm, line * 0.1_um);
            ASSERT_LT(std::abs(height - before), 0.2_nm) << i << ' ' << line;
            before = height;
            lowest = std::min(lowest, height);
        }
    }
    EXPECT_LT(lowest, -13.0_nm);
}

TEST(Synthetic, ScansWithoutPixelsOrSizeAreRefused) {
    EXPECT_THROW((void)flatMap({.columns = 0, .rows = 4, .sizeX = 1.0_nm, .sizeY = 1.0_nm}), Error);
    EXPECT_THROW((void)flatMap({.columns = 4, .rows = 4, .sizeX = 0.0, .sizeY = 1.0_nm}), Error);
    EXPECT_THROW((void)flatMap({.columns = 1 << 30, .rows = 4, .sizeX = 1.0_nm, .sizeY = 1.0_nm}),
                 Error);
}

}  // namespace
}  // namespace asperity
