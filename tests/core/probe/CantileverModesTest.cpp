#include "core/probe/CantileverModes.h"

#include "core/Error.h"
#include "core/Units.h"
#include "tests/core/contact/laws/ContactCases.h"
#include "tests/core/probe/ReferenceLever.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace asperity {
namespace {

using test::expectRelative;
using test::referenceLever;
using test::ReferenceTable;

TEST(CantileverModes, AreTheReferenceModes) {
    const ReferenceTable table = test::referenceTable("T17_modes.csv");
    ASSERT_EQ(table.rows(), 12U);
    for (std::size_t row = 0; row < table.rows(); ++row) {
        SCOPED_TRACE(row);
        const CantileverGeometry beam = referenceLever(table.text(row, "geom"));
        const FlexuralMode mode = flexuralMode(beam, static_cast<int>(table.number(row, "n")));
        expectRelative(mode.waveNumber, table.number(row, "beta_l"), 1e-14);
        expectRelative(mode.frequency(), table.number(row, "f_Hz"), 1e-12);
        expectRelative(mode.angularFrequency, table.number(row, "omega"), 1e-12);
        expectRelative(mode.stiffness, table.number(row, "k_n"), 1e-12);
        expectRelative(mode.mass, table.number(row, "m_eff"), 1e-12);
        expectRelative(beamMass(beam), table.number(row, "m_beam"), 1e-12);
        expectRelative(2.0 / mode.angularFrequency, table.number(row, "dt_max_s"), 1e-12);
    }
}

/// Deflection at a share of the length, from the mode shape itself.
double shape(double waveNumber, double share) {
    const double x = waveNumber * share;
    const double sigma = (std::cosh(waveNumber) + std::cos(waveNumber)) /
                         (std::sinh(waveNumber) + std::sin(waveNumber));
    return std::cosh(x) - std::cos(x) - (sigma * (std::sinh(x) - std::sin(x)));
}

TEST(CantileverModes, SlopeAtTheEndIsThatOfTheModeShape) {
    const CantileverGeometry beam = referenceLever("G1_k14");
    for (int number = 1; number <= 4; ++number) {
        const FlexuralMode mode = flexuralMode(beam, number);
        constexpr double kStep = 1e-5;
        // One-sided and of second order: the beam ends there.
        const double end = shape(mode.waveNumber, 1.0);
        const double slope = (3.0 * end - 4.0 * shape(mode.waveNumber, 1.0 - kStep) +
                              shape(mode.waveNumber, 1.0 - 2.0 * kStep)) /
                             (2.0 * kStep);
        EXPECT_NEAR(mode.endSlope * beam.length, slope / end, 1e-4);
    }
    // The fundamental turns its end less than a force at the end does, 3 / (2 l).
    EXPECT_NEAR(flexuralMode(beam, 1).endSlope * beam.length, 1.3765, 1e-4);
}

TEST(CantileverModes, HighModesApproachHalfIntegerMultiplesOfPi) {
    const CantileverGeometry beam = referenceLever("G1_k14");
    for (const int number : {8, 50, 100}) {
        expectRelative(flexuralMode(beam, number).waveNumber, (number - 0.5) * std::numbers::pi,
                       1e-10);
    }
    EXPECT_THROW((void)flexuralMode(beam, 0), Error);
    EXPECT_THROW((void)flexuralMode(beam, 101), Error);
    EXPECT_THROW((void)flexuralMode(CantileverGeometry{}, 1), Error);
}

/// What a lab measures brings back the lever that it was measured on, tip set back or not.
TEST(CantileverModes, StiffnessAndResonanceGiveBackThicknessAndModulus) {
    EXPECT_TRUE(rc::check([] {
        CantileverGeometry beam = referenceLever("G2_k14_130GPa");
        beam.setBack = beam.length * 0.3 * *test::fraction();
        beam.youngsModulus = *test::logUniform(4e9, 1e12);
        beam.thickness = *test::logUniform(0.2e-6, 8e-6);
        beam.density = *test::logUniform(1e3, 2e4);
        const double stiffness = Cantilever(beam).stiffness();
        const double resonance = flexuralMode(beam, 1).frequency();
        CantileverGeometry unknown = beam;
        unknown.youngsModulus = 1.0;
        unknown.thickness = 1.0;
        const CantileverGeometry found = withStiffnessAndResonance(unknown, stiffness, resonance);
        RC_ASSERT(std::abs(found.thickness / beam.thickness - 1.0) < 1e-12);
        RC_ASSERT(std::abs(found.youngsModulus / beam.youngsModulus - 1.0) < 1e-12);
        RC_ASSERT(std::abs(thicknessForResonance(beam, resonance) / beam.thickness - 1.0) < 1e-12);
    }));
}

}  // namespace
}  // namespace asperity
