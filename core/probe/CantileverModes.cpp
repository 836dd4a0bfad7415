#include "core/probe/CantileverModes.h"

#include "core/Error.h"

#include <cmath>
#include <numbers>

namespace asperity {

namespace {

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

}  // namespace

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

}  // namespace asperity
