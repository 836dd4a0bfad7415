#include "core/probe/Cantilever.h"

#include "core/Error.h"
#include "core/contact/Within.h"
#include "core/probe/RequirePositive.h"

#include <cmath>
#include <numbers>
#include <string>

namespace asperity {

namespace {

using std::numbers::pi;

/// beta for thickness <= width. The series over odd n of tanh(x_n) / n^5 converges slowly; as
/// sum 1/n^5 - sum (1 - tanh(x_n)) / n^5 the first part is 31 zeta(5) / 32 and the second falls
/// off exponentially.
double torsionFactorOfPlate(double thicknessOverWidth) noexcept {
    constexpr double kOddSumOfFifthPowers = 1.0045237627951382;  // 31 zeta(5) / 32
    double sum = kOddSumOfFifthPowers;
    for (int n = 1; n <= 13; n += 2) {
        const double decay = std::exp(-n * pi / thicknessOverWidth);
        sum -= 2.0 * decay / (1.0 + decay) / std::pow(n, 5);
    }
    return (1.0 - (192.0 / std::pow(pi, 5) * thicknessOverWidth * sum)) / 3.0;
}

void check(const CantileverGeometry& geometry) {
    requirePositive(geometry.youngsModulus, "cantilever: Young's modulus");
    requirePositive(geometry.length, "cantilever: length");
    requirePositive(geometry.width, "cantilever: width");
    requirePositive(geometry.thickness, "cantilever: thickness");
    requirePositive(geometry.tipHeight, "cantilever: tip height");
    requirePositive(geometry.density, "cantilever: density");
    requirePositive(geometry.qualityFactor, "cantilever: quality factor");
    if (!isWithin(geometry.setBack, 0.0, geometry.length) || geometry.loadPoint() <= 0.0) {
        throw Error("cantilever: the tip's set-back must be zero or more and less than the length");
    }
    if (!isWithin(geometry.poissonRatio, 0.0, 0.5)) {
        throw Error("cantilever: Poisson's ratio must lie between 0 and 0.5");
    }
    if (!isWithin(geometry.mountTilt, -pi / 2.0, pi / 2.0) || !std::isfinite(geometry.azimuth)) {
        throw Error("cantilever: mount tilt must lie within a quarter turn, azimuth be finite");
    }
}

/// Lab to cantilever: azimuth about z first, then the free end tilted down.
Matrix3 labToCantilever(double tilt, double azimuth) {
    const double ct = std::cos(tilt);
    const double st = std::sin(tilt);
    const double ca = std::cos(azimuth);
    const double sa = std::sin(azimuth);
    Matrix3 rotation;
    rotation << ct * ca, ct * sa, -st,  //
        -sa, ca, 0.0,                   //
        st * ca, st * sa, ct;
    return rotation;
}

}  // namespace

double thicknessForStiffness(const CantileverGeometry& geometry, double stiffness) noexcept {
    return geometry.loadPoint() *
           std::cbrt(4.0 * stiffness / (geometry.youngsModulus * geometry.width));
}

double torsionFactor(double thicknessOverWidth) noexcept {
    if (thicknessOverWidth <= 1.0) {
        return torsionFactorOfPlate(thicknessOverWidth);
    }
    // J does not care which side is called thickness.
    return torsionFactorOfPlate(1.0 / thicknessOverWidth) /
           (thicknessOverWidth * thicknessOverWidth);
}

Cantilever::Cantilever(const CantileverGeometry& geometry) : geometry_(geometry) {
    check(geometry);
    const double length = geometry.loadPoint();
    const double height = geometry.tipHeight;
    const double ratio = geometry.thickness / geometry.width;
    const double slenderness = geometry.thickness / length;
    stiffness_ =
        geometry.youngsModulus * geometry.width * slenderness * slenderness * slenderness / 4.0;

    const double axial = 3.0 * height * height / (length * length * stiffness_);
    const double coupled = 3.0 * height / (2.0 * length * stiffness_);
    const double lateralBending = ratio * ratio / stiffness_;
    const double torsion = (1.0 + geometry.poissonRatio) * height * height /
                           (2.0 * torsionFactor(ratio) * length * length * stiffness_);
    compliance_ << axial, 0.0, coupled,      //
        0.0, lateralBending + torsion, 0.0,  //
        coupled, 0.0, 1.0 / stiffness_;
    rotation_ = labToCantilever(geometry.mountTilt, geometry.azimuth);
    labCompliance_ = rotation_.transpose() * compliance_ * rotation_;

    bendingPerFz_ = 3.0 / (2.0 * length * stiffness_);
    bendingPerFx_ = 3.0 * height / (length * length * stiffness_);
    torsionPerFy_ = torsion / height;
}

}  // namespace asperity
