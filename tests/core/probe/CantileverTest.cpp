#include "core/Error.h"
#include "core/Units.h"
#include "core/probe/CantileverModes.h"
#include "core/probe/DetectorCalibration.h"
#include "tests/core/probe/ReferenceLever.h"
#include "tests/support/FloatingPointTraps.h"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace asperity {
namespace {

using std::numbers::pi;
using test::expectRelative;
using test::referenceLever;
using test::ReferenceTable;

ASPERITY_TRAP_FLOATING_POINT();

TEST(Cantilever, HasTheReferenceCompliance) {
    const ReferenceTable table = test::referenceTable("T10_compliance.csv");
    ASSERT_EQ(table.rows(), 3U);
    for (std::size_t row = 0; row < table.rows(); ++row) {
        SCOPED_TRACE(table.text(row, "geom"));
        const Cantilever lever(test::leverOfRow(table, row));
        const Matrix3& compliance = lever.complianceInCantileverFrame();
        expectRelative(lever.stiffness(), table.number(row, "kz"), 1e-13);
        expectRelative(compliance(0, 0), table.number(row, "Cxx"), 1e-13);
        expectRelative(compliance(0, 2), table.number(row, "Cxz"), 1e-13);
        expectRelative(compliance(2, 0), table.number(row, "Cxz"), 1e-13);
        expectRelative(compliance(1, 1), table.number(row, "Cyy"), 1e-13);
        expectRelative(compliance(2, 2), table.number(row, "Czz"), 1e-13);
        EXPECT_EQ(compliance(0, 1), 0.0);
        EXPECT_EQ(compliance(1, 2), 0.0);
        expectRelative(lever.bendingPerFz(), table.number(row, "cz"), 1e-13);
        expectRelative(lever.bendingPerFx(), table.number(row, "cx"), 1e-13);
        expectRelative(lever.torsionPerFy(), table.number(row, "cy"), 1e-13);
        expectRelative(lever.couplingRatio(), table.number(row, "kappa"), 1e-13);
    }
}

/// The columns of T10 that stand between geometry and compliance: what the lever reports belongs
/// to the table's moments of inertia and spring constants, too.
TEST(Cantilever, BelongsToTheReferenceSectionsAndSprings) {
    const ReferenceTable table = test::referenceTable("T10_compliance.csv");
    for (std::size_t row = 0; row < table.rows(); ++row) {
        SCOPED_TRACE(table.text(row, "geom"));
        const auto cell = [&](const char* column) { return table.number(row, column); };
        const CantileverGeometry beam = test::leverOfRow(table, row);
        const Cantilever lever(beam);
        const Matrix3& compliance = lever.complianceInCantileverFrame();
        const double square = beam.length * beam.length;
        const double lateral =
            cantileverShape(lever, Vector3::UnitY(), beam.length).lateralDeflection;
        expectRelative(torsionFactor(beam.thickness / beam.width), cell("beta"), 1e-13);
        expectRelative(square / (2.0 * beam.youngsModulus * lever.bendingPerFz()), cell("I"),
                       1e-13);
        expectRelative(square * beam.length / (3.0 * beam.youngsModulus * lateral), cell("Iz"),
                       1e-13);
        expectRelative(beam.tipHeight * beam.length / (cell("G") * lever.torsionPerFy()), cell("J"),
                       1e-13);
        expectRelative(beam.youngsModulus / (2.0 * (1.0 + beam.poissonRatio)), cell("G"), 1e-13);
        expectRelative(1.0 / compliance(0, 0), cell("kx"), 1e-13);
        expectRelative(1.0 / compliance(0, 2), cell("kxz"), 1e-13);
        expectRelative(1.0 / lateral, cell("kyb"), 1e-13);
        expectRelative(1.0 / (beam.tipHeight * lever.torsionPerFy()), cell("kyt"), 1e-13);
        // The thin-plate torsion that the paper takes is stiffer than the true one.
        expectRelative(cell("kyt_thin") * 3.0 * torsionFactor(beam.thickness / beam.width),
                       cell("kyt"), 1e-13);
        // What is left out on purpose stays below one percent.
        EXPECT_LT(cell("Cax"), 0.01 * compliance(0, 0));
    }
}

TEST(Cantilever, TurnsForcesIntoTheReferenceSignalsAndDeflections) {
    const ReferenceTable table = test::referenceTable("T10b_forces_signals.csv");
    ASSERT_EQ(table.rows(), 60U);
    for (std::size_t row = 0; row < table.rows(); ++row) {
        SCOPED_TRACE(row);
        const Cantilever lever(referenceLever(table.text(row, "geom")));
        const Vector3 force = test::vectorOfRow(table, row, "F");
        const LeverSignals signals = leverSignals(lever, force);
        // Fz and Fx may almost cancel in a signal: rounding is relative to their parts.
        const double bent = (lever.bendingPerFz() * std::abs(force.z())) +
                            (lever.bendingPerFx() * std::abs(force.x()));
        EXPECT_NEAR(signals.bending, table.number(row, "alpha"), 1e-13 * bent);
        expectRelative(signals.torsion, table.number(row, "theta"), 1e-13);
        const double lateralSlope =
            cantileverShape(lever, force, lever.geometry().length).lateralSlope;
        expectRelative(lateralSlope, table.number(row, "ypl"), 1e-13);
        const Vector3 deflection = lever.compliance() * force;
        const Vector3 limit = 1e-13 * (lever.compliance().cwiseAbs() * force.cwiseAbs());
        const Vector3 expected = test::vectorOfRow(table, row, "u");
        for (int i = 0; i < 3; ++i) {
            EXPECT_NEAR(deflection(i), expected(i), limit(i));
        }
    }
}

TEST(Cantilever, HasTheReferenceTorsionFactor) {
    const ReferenceTable table = test::referenceTable("T18_torsion_beta.csv");
    ASSERT_EQ(table.rows(), 11U);
    for (std::size_t row = 0; row < table.rows(); ++row) {
        expectRelative(torsionFactor(table.number(row, "t_over_w")), table.number(row, "beta"),
                       1e-14);
    }
}

/// A beam on its side twists as it did before: J = beta w t^3 with the sides exchanged.
TEST(Cantilever, TwistsTheSameOnItsSide) {
    for (const double ratio : {1e-3, 0.2, 0.999, 1.0}) {
        const double ratioOnSide = 1.0 / ratio;
        expectRelative(torsionFactor(ratioOnSide) * ratioOnSide * ratioOnSide, torsionFactor(ratio),
                       1e-14);
    }
}

TEST(CantileverShape, HasTheReferenceShapes) {
    const ReferenceTable table = test::referenceTable("T19_beam_shape.csv");
    ASSERT_EQ(table.rows(), 165U);
    for (std::size_t row = 0; row < table.rows(); ++row) {
        SCOPED_TRACE(row);
        const Cantilever lever(referenceLever(table.text(row, "geom")));
        const Vector3 force = test::vectorOfRow(table, row, "F");
        const CantileverShape shape = cantileverShape(lever, force, table.number(row, "x"));
        expectRelative(shape.deflection, table.number(row, "z"), 1e-12);
        expectRelative(shape.slope, table.number(row, "zp"), 1e-12);
        expectRelative(shape.lateralDeflection, table.number(row, "y"), 1e-12);
        expectRelative(shape.torsion, table.number(row, "theta"), 1e-12);
    }
}

TEST(CantileverShape, EndsInTheSlopeAndTorsionThatTheLeverReports) {
    CantileverGeometry geometry = referenceLever("G1_k14");
    geometry.mountTilt = 0.2;
    geometry.azimuth = 0.7;
    const Cantilever lever(geometry);
    const Vector3 force(3e-9, -2e-9, 1e-8);
    const CantileverShape end = cantileverShape(lever, force, geometry.length);
    const LeverSignals signals = leverSignals(lever, force);
    expectRelative(end.slope, signals.bending, 1e-13);
    expectRelative(end.torsion, signals.torsion, 1e-13);
    const Vector3 deflection = lever.rotation() * (lever.compliance() * force);
    expectRelative(end.deflection, deflection.z(), 1e-12);
}

TEST(Cantilever, IsAsStiffAsItsThicknessWasChosenFor) {
    CantileverGeometry geometry = referenceLever("G1_k14");
    const double thickness = geometry.thickness;
    geometry.thickness = thicknessForStiffness(geometry, 14.0);
    expectRelative(geometry.thickness, thickness, 1e-14);
    expectRelative(Cantilever(geometry).stiffness(), 14.0, 1e-14);
}

/// Numbers of docs/theory.md 5.4 and its formula for the vertical stiffness of a tilted lever.
TEST(Cantilever, StiffensWhenTilted) {
    CantileverGeometry geometry = referenceLever("G1_k14");
    const double tilt = 12.0 * pi / 180.0;
    geometry.mountTilt = tilt;
    const Cantilever lever(geometry);
    const double ratio = geometry.tipHeight / geometry.length;
    const double cosine = std::cos(tilt);
    const double sine = std::sin(tilt);
    const double expected =
        ((cosine * cosine) - (3.0 * ratio * sine * cosine) + (3.0 * ratio * ratio * sine * sine)) /
        lever.stiffness();
    expectRelative(lever.compliance()(2, 2), expected, 1e-13);
    EXPECT_NEAR(1.0 / (lever.compliance()(2, 2) * lever.stiffness()), 1.10, 0.01);
    const LeverSignals signals = leverSignals(lever, Vector3::UnitZ() * 1_nN);
    EXPECT_NEAR(signals.bending / (lever.bendingPerFz() * 1_nN), 0.945, 0.001);
}

TEST(Cantilever, HasAFrameThatTiltsAndTurns) {
    CantileverGeometry geometry = referenceLever("G1_k14");
    geometry.mountTilt = 0.2;
    geometry.azimuth = pi / 2.0;
    const Cantilever lever(geometry);
    const Matrix3& rotation = lever.rotation();
    EXPECT_TRUE((rotation * rotation.transpose()).isIdentity(1e-15));
    EXPECT_NEAR(rotation.determinant(), 1.0, 1e-15);
    // The beam points along +y and its free end is down; its y axis points along -x.
    EXPECT_TRUE(
        rotation.row(0).transpose().isApprox(Vector3(0.0, std::cos(0.2), -std::sin(0.2)), 1e-15));
    EXPECT_TRUE(rotation.row(1).transpose().isApprox(-Vector3::UnitX(), 1e-15));
    // A turned lever answers a turned force as before.
    geometry.azimuth = 0.0;
    const Cantilever straight(geometry);
    const LeverSignals turned = leverSignals(lever, Vector3(-2.0, 1.0, 3.0) * 1_nN);
    const LeverSignals before = leverSignals(straight, Vector3(1.0, 2.0, 3.0) * 1_nN);
    expectRelative(turned.bending, before.bending, 1e-14);
    expectRelative(turned.torsion, before.torsion, 1e-14);
}

/// A tip set back loads a shorter beam; the rest is carried along straight.
TEST(Cantilever, BendsOnlyUpToATipThatIsSetBack) {
    CantileverGeometry geometry = referenceLever("G1_k14");
    const Cantilever shorter(geometry);
    geometry.setBack = 10.0_um;
    geometry.length += geometry.setBack;
    const Cantilever lever(geometry);
    EXPECT_TRUE(lever.compliance().isApprox(shorter.compliance(), 1e-13));
    expectRelative(lever.stiffness(), shorter.stiffness(), 1e-13);
    expectRelative(lever.couplingRatio(), shorter.couplingRatio(), 1e-13);
    const Vector3 force(3e-9, -2e-9, 1e-8);
    const LeverSignals signals = leverSignals(lever, force);
    expectRelative(signals.bending, leverSignals(shorter, force).bending, 1e-13);
    expectRelative(signals.torsion, leverSignals(shorter, force).torsion, 1e-13);

    const CantileverShape tip = cantileverShape(lever, force, geometry.loadPoint());
    const CantileverShape end = cantileverShape(lever, force, geometry.length);
    expectRelative(tip.deflection, (lever.compliance() * force).z(), 1e-12);
    expectRelative(end.deflection, tip.deflection + (tip.slope * geometry.setBack), 1e-13);
    expectRelative(end.lateralDeflection,
                   tip.lateralDeflection + (tip.lateralSlope * geometry.setBack), 1e-13);
    EXPECT_EQ(end.slope, tip.slope);
    EXPECT_EQ(end.lateralSlope, tip.lateralSlope);
    EXPECT_EQ(end.torsion, tip.torsion);
    expectRelative(end.slope, signals.bending, 1e-13);
}

TEST(Cantilever, TakesItsThicknessFromTheStiffnessAtTheTip) {
    CantileverGeometry geometry = referenceLever("G1_k14");
    geometry.setBack = 10.0_um;
    geometry.thickness = thicknessForStiffness(geometry, 14.0);
    expectRelative(Cantilever(geometry).stiffness(), 14.0, 1e-14);
}

TEST(Cantilever, RefusesATipThatIsNotOnTheBeam) {
    CantileverGeometry geometry = referenceLever("G1_k14");
    for (const double bad : {-1e-9, geometry.length, 1.0, std::nan("")}) {
        geometry.setBack = bad;
        EXPECT_THROW(Cantilever{geometry}, Error) << bad;
    }
}

/// Deflection over length of a beam that follows its own bend, under a force P across the unloaded
/// beam at its end: theta'' = -load cos(theta), load = P l^2/(EI), by shooting.
double trueDeflection(double load) {
    constexpr int kSteps = 2000;
    const auto shoot = [load](double bend, double& height) {
        constexpr double kStep = 1.0 / kSteps;
        double angle = 0.0;
        height = 0.0;
        for (int i = 0; i < kSteps; ++i) {  // the midpoint rule
            const double middle = angle + (0.5 * kStep * bend);
            const double middleBend = bend - (0.5 * kStep * load * std::cos(angle));
            angle += kStep * middleBend;
            bend -= kStep * load * std::cos(middle);
            height += kStep * std::sin(middle);
        }
        return bend;
    };
    double low = 0.0;
    double high = load;
    double height = 0.0;
    for (int i = 0; i < 50; ++i) {
        const double bend = 0.5 * (low + high);
        (shoot(bend, height) > 0.0 ? high : low) = bend;
    }
    return height;
}

TEST(Cantilever, IsBentTooFarWhereALinearBeamIsFourPercentTooSoft) {
    const CantileverGeometry geometry = referenceLever("G1_k14");
    const Cantilever lever(geometry);
    const double length = geometry.loadPoint();
    const auto isBent = [&](double share) {  // of the length
        return lever.isBentTooFar({0.0, 0.0, -share * length * lever.stiffness()});
    };
    EXPECT_FALSE(isBent(0.19));
    EXPECT_TRUE(isBent(0.21));
    EXPECT_FALSE(lever.isBentTooFar({0.0, 1e-4, 0.0})) << "torsion bends no beam";
    EXPECT_NEAR(0.2 / trueDeflection(0.6), 1.04, 0.001);  // linear: load / 3
    EXPECT_NEAR(0.3 / trueDeflection(0.9), 1.086, 0.001);
    EXPECT_NEAR(0.02 / trueDeflection(0.06), 1.000411, 1e-6) << "as the square of the deflection";
}

/// Each number alone would do; together they make no lever.
TEST(Cantilever, RefusesAStiffnessThatNoLeverHas) {
    CantileverGeometry geometry = referenceLever("G1_k14");
    geometry.thickness = 1e-9;
    geometry.length = 0.1;
    EXPECT_THROW(Cantilever{geometry}, Error);
    geometry.thickness = 0.5;
    geometry.length = 1e-3;
    EXPECT_THROW(Cantilever{geometry}, Error);
}

TEST(Cantilever, RefusesWhatIsNoBeam) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double bad : {0.0, -1.0, 1e-300, 1e300, nan, infinity}) {
        for (double CantileverGeometry::*field :
             {&CantileverGeometry::youngsModulus, &CantileverGeometry::length,
              &CantileverGeometry::width, &CantileverGeometry::thickness,
              &CantileverGeometry::tipHeight, &CantileverGeometry::density,
              &CantileverGeometry::qualityFactor}) {
            CantileverGeometry geometry = referenceLever("G1_k14");
            geometry.*field = bad;
            EXPECT_THROW(Cantilever{geometry}, Error);
        }
    }
    for (double CantileverGeometry::*field :
         {&CantileverGeometry::poissonRatio, &CantileverGeometry::mountTilt,
          &CantileverGeometry::azimuth}) {
        CantileverGeometry geometry = referenceLever("G1_k14");
        geometry.*field = nan;
        EXPECT_THROW(Cantilever{geometry}, Error);
    }
}

}  // namespace
}  // namespace asperity
