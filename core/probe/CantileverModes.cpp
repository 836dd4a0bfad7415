#include "core/probe/CantileverModes.h"

#include "core/Error.h"
#include "core/contact/Within.h"

#include <algorithm>
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

void requireWithin(double value, double low, double high, const std::string& what) {
    if (!isWithin(value, low, high)) {
        throw Error("cantilever: " + what);
    }
}

void requireLength(double value, const std::string& name) {
    requireWithin(value, 1e-9, 1.0, name + " must lie between 1 nm and 1 m");
}

/// Bounds far around every lever there is: within them nothing that follows can overflow.
void check(const CantileverGeometry& geometry) {
    requireLength(geometry.length, "length");
    requireLength(geometry.width, "width");
    requireLength(geometry.thickness, "thickness");
    requireLength(geometry.tipHeight, "tip height");
    requireWithin(geometry.youngsModulus, 1.0, 1e15, "Young's modulus must lie in 1 .. 1e15 Pa");
    requireWithin(geometry.density, 1e-3, 1e6, "density must lie in 1e-3 .. 1e6 kg/m^3");
    requireWithin(geometry.qualityFactor, 1e-6, 1e12, "quality factor must lie in 1e-6 .. 1e12");
    requireWithin(geometry.setBack, 0.0, geometry.length - 1e-9,
                  "the tip's set-back must be zero or more and less than the length");
    requireWithin(geometry.poissonRatio, 0.0, 0.5, "Poisson's ratio must lie between 0 and 0.5");
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

using std::numbers::pi;

/// The n-th root of cos x + 1 / cosh x = 0: the term 1 / cosh x shifts the roots of the cosine less
/// and less, so Newton's method starts next to each.
double waveNumber(int number) {
    constexpr int kSteps = 6;
    double x = (number - 0.5) * pi;
    for (int i = 0; i < kSteps; ++i) {
        const double inverse = 1.0 / std::cosh(x);
        const double slope = -std::sin(x) - (inverse * std::tanh(x));
        x -= (std::cos(x) + inverse) / slope;
    }
    return x;
}

/// beta_1^2 = omega_1 l^2 sqrt(rho A / (E I)).
double fundamentalSquare() {
    const double root = waveNumber(1);
    return root * root;
}

double stiffnessAtFreeEnd(const CantileverGeometry& geometry) {
    const double slenderness = geometry.thickness / geometry.length;
    return geometry.youngsModulus * geometry.width * slenderness * slenderness * slenderness / 4.0;
}

/// Shape between clamp and tip.
CantileverShape loadedShape(const Cantilever& cantilever, const Vector3& local, double distance) {
    const CantileverGeometry& beam = cantilever.geometry();
    const double length = beam.loadPoint();
    const double flexibility = 2.0 * cantilever.bendingPerFz() / (length * length);  // 1 / (E I)
    const double ratio = beam.thickness / beam.width;
    const double square = distance * distance;
    const double underEndLoad = square * ((length / 2.0) - (distance / 6.0));
    const double slopeUnderEndLoad = distance * (length - (distance / 2.0));
    const double endMoment = beam.tipHeight * local.x();
    const double lateralLoad = flexibility * ratio * ratio * local.y();
    return {.deflection = flexibility * ((local.z() * underEndLoad) + (endMoment * square / 2.0)),
            .slope = flexibility * ((local.z() * slopeUnderEndLoad) + (endMoment * distance)),
            .lateralDeflection = lateralLoad * underEndLoad,
            .lateralSlope = lateralLoad * slopeUnderEndLoad,
            .torsion = cantilever.torsionPerFy() * local.y() * distance / length};
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
    requireWithin(stiffness_, 1e-9, 1e9,
                  "length, width, thickness and Young's modulus must make a stiffness between 1e-9 "
                  "and 1e9 N/m");

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

bool CantileverGeometry::isBentTooFar(double deflection) const noexcept {
    constexpr double kMaxDeflection = 0.2;  // of the length up to the tip
    return std::abs(deflection) > kMaxDeflection * loadPoint();
}

bool Cantilever::isBentTooFar(const Vector3& force) const noexcept {
    return geometry_.isBentTooFar(compliance_.row(2).dot(rotation_ * force));
}

Cantilever Cantilever::rigidInTorsion() const noexcept {
    Cantilever rigid = *this;
    rigid.compliance_(1, 1) -= torsionPerFy_ * geometry_.tipHeight;
    rigid.labCompliance_ = rotation_.transpose() * rigid.compliance_ * rotation_;
    return rigid;
}

double FlexuralMode::frequency() const noexcept { return angularFrequency / (2.0 * pi); }

double beamMass(const CantileverGeometry& geometry) noexcept {
    return geometry.density * geometry.width * geometry.length * geometry.thickness;
}

FlexuralMode flexuralMode(const CantileverGeometry& geometry, int number) {
    constexpr int kMaxModes = 100;  // far beyond where the beam is still slender
    if (number < 1 || number > kMaxModes) {
        throw Error("cantilever: modes are numbered from 1 to 100");
    }
    const CantileverGeometry beam = Cantilever(geometry).geometry();  // refuses what is no beam
    FlexuralMode mode;
    const double x = waveNumber(number);
    mode.waveNumber = x;
    mode.stiffness = stiffnessAtFreeEnd(beam) * x * x * x * x / 12.0;
    mode.mass = beamMass(beam) / 4.0;
    mode.angularFrequency = std::sqrt(mode.stiffness / mode.mass);
    mode.endSlope = x / (1.0 / std::tanh(x) - 1.0 / std::tan(x)) / beam.length;
    return mode;
}

double thicknessForResonance(const CantileverGeometry& geometry, double resonance) {
    const double omega = 2.0 * pi * resonance;
    return omega * geometry.length * geometry.length / fundamentalSquare() *
           std::sqrt(12.0 * geometry.density / geometry.youngsModulus);
}

CantileverGeometry withStiffnessAndResonance(CantileverGeometry geometry, double stiffness,
                                             double resonance) {
    const double omega = 2.0 * pi * resonance;
    const double squared = fundamentalSquare();
    const double load = geometry.loadPoint();
    const double shortening = load / geometry.length;
    const double atFreeEnd = stiffness * shortening * shortening * shortening;
    const double modal = atFreeEnd * squared * squared / 12.0;
    const double massPerThickness = geometry.density * geometry.width * geometry.length / 4.0;
    geometry.thickness = modal / (omega * omega * massPerThickness);
    const double slenderness = geometry.thickness / load;
    geometry.youngsModulus =
        4.0 * stiffness / (geometry.width * slenderness * slenderness * slenderness);
    return geometry;
}

CantileverShape cantileverShape(const Cantilever& cantilever, const Vector3& force,
                                double distance) noexcept {
    const double loaded = std::min(distance, cantilever.geometry().loadPoint());
    CantileverShape shape = loadedShape(cantilever, cantilever.rotation() * force, loaded);
    shape.deflection += shape.slope * (distance - loaded);
    shape.lateralDeflection += shape.lateralSlope * (distance - loaded);
    return shape;
}

}  // namespace asperity
