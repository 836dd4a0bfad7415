#include "core/probe/DetectorCalibration.h"

#include "core/Error.h"
#include "core/Units.h"
#include "tests/core/probe/ReferenceLever.h"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity {
namespace {

using test::expectRelative;
using test::referenceLever;

DetectorCalibration calibrated() { return {.invOls = 50_nm, .torsionPerVolt = 2e-4}; }

/// On a hard wall a volt is a known deflection; the slope must be that of a lever so deflected.
TEST(DetectorCalibration, InvOlsGivesTheSlopeOfAnEndForce) {
    CantileverGeometry geometry = referenceLever("G1_k14");
    geometry.setBack = 8.0_um;
    const Cantilever lever(geometry);
    const Vector3 force(0.0, 0.0, 30_nN);
    const double deflection = (lever.compliance() * force).z();
    const LeverSignals expected = leverSignals(lever, force);
    const VoltsToSignals conversion(lever, calibrated());
    const LeverSignals signals =
        conversion.signals({.vertical = deflection / 50_nm, .lateral = 0.5});
    expectRelative(signals.bending, expected.bending, 1e-13);
    expectRelative(signals.torsion, 1e-4, 1e-15);
}

TEST(DetectorCalibration, CrossTalkIsTakenOut) {
    const Cantilever lever(referenceLever("G1_k14"));
    DetectorCalibration detector = calibrated();
    const DetectorVolts clean{.vertical = 0.7, .lateral = -0.2};
    const LeverSignals expected = VoltsToSignals(lever, detector).signals(clean);
    detector.verticalCrossTalk = 0.05;
    detector.lateralCrossTalk = -0.1;
    const DetectorVolts mixed{.vertical = clean.vertical + 0.05 * clean.lateral,
                              .lateral = clean.lateral - 0.1 * clean.vertical};
    const LeverSignals signals = VoltsToSignals(lever, detector).signals(mixed);
    expectRelative(signals.bending, expected.bending, 1e-14);
    expectRelative(signals.torsion, expected.torsion, 1e-14);
}

TEST(DetectorCalibration, NoiseOfVoltsBecomesNoiseOfSlopes) {
    const Cantilever lever(referenceLever("G1_k14"));
    const DetectorVolts sigma{.vertical = 1e-3, .lateral = 2e-3};
    DetectorCalibration detector = calibrated();
    detector.torsionPerVolt = -2e-4;  // wired the other way round: the noise has no sign
    const LeverSignals plain = VoltsToSignals(lever, detector).sigma(sigma);
    expectRelative(plain.bending, 1e-3 * 50_nm * 1.5 / 150_um, 1e-14);
    expectRelative(plain.torsion, 4e-7, 1e-14);
    detector.verticalCrossTalk = 0.5;
    const LeverSignals mixed = VoltsToSignals(lever, detector).sigma(sigma);
    expectRelative(mixed.bending, plain.bending * std::sqrt(2.0), 1e-14);
    expectRelative(mixed.torsion, plain.torsion, 1e-14);
}

TEST(DetectorCalibration, RefusesVoltsWithoutSensitivities) {
    const Cantilever lever(referenceLever("G1_k14"));
    DetectorCalibration detector = calibrated();
    detector.invOls.reset();
    EXPECT_THROW((VoltsToSignals{lever, detector}), Error);
    detector = calibrated();
    detector.torsionPerVolt.reset();
    EXPECT_THROW((VoltsToSignals{lever, detector}), Error);
    detector = calibrated();
    detector.verticalCrossTalk = 2.0;
    detector.lateralCrossTalk = 0.5;
    EXPECT_THROW((VoltsToSignals{lever, detector}), Error);
}

/// What an instrument's setpoint in volts or nanometers counts.
TEST(DetectorCalibration, ShowsAForceAlongZAndTheFrictionAlongTheLever) {
    for (const double tilt : {0.0, 0.2}) {
        CantileverGeometry geometry = referenceLever("G1_k14");
        geometry.mountTilt = tilt;
        const Cantilever lever(geometry);
        const Vector3 axis = bendingAxis(lever);
        const Vector3 force(3_nN, 4_nN, 5_nN);
        const double perZ = leverSignals(lever, Vector3::UnitZ()).bending;
        expectRelative(axis.dot(force), leverSignals(lever, force).bending / perZ, 1e-14);
        EXPECT_EQ(axis.z(), 1.0);
        EXPECT_EQ(axis.y(), 0.0);
        const double volts = 5_nN * shownDeflectionPerForce(lever) / 50_nm;
        const double slope =
            VoltsToSignals(lever, calibrated()).signals({.vertical = volts}).bending;
        expectRelative(slope, std::abs(5_nN * perZ), 1e-14);
    }
    const Cantilever level(referenceLever("G1_k14"));
    expectRelative(shownDeflectionPerForce(level), 1.0 / level.stiffness(), 1e-13);
}

}  // namespace
}  // namespace asperity
