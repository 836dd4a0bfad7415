#pragma once

#include "core/Vector.h"

namespace asperity {

/// A rectangular cantilever with a tip at or near its free end, as a lab describes it.
struct CantileverGeometry {
    double youngsModulus = 0.0;  ///< of the beam [Pa]
    double poissonRatio = 0.0;   ///< of the beam
    double length = 0.0;         ///< clamp to free end [m]
    double width = 0.0;          ///< [m]
    double thickness = 0.0;      ///< [m]
    double tipHeight = 0.0;      ///< beam axis to tip apex [m]
    double mountTilt = 0.0;      ///< free end down [rad]
    double azimuth = 0.0;  ///< of the beam in the image plane, 0: clamp to free end along +x [rad]
    double setBack = 0.0;  ///< free end to tip, along the beam [m]
    double density = 2330.0;       ///< of the beam, silicon's [kg/m^3]
    double qualityFactor = 100.0;  ///< of the fundamental resonance

    /// Clamp to tip, where the force acts and the slope is read [m].
    [[nodiscard]] double loadPoint() const noexcept { return length - setBack; }
    /// Returns whether the beam is bent at the tip by more than a fifth of its length up to there,
    /// by linear theory. There it takes 4 % more force than the linear one, growing as the square
    /// of the deflection, and its free end has come nearer to the clamp by 2.4 % of the length.
    /// @param deflection [m] Source: docs/theory.md 5.7.
    [[nodiscard]] bool isBentTooFar(double deflection) const noexcept;

    bool operator==(const CantileverGeometry&) const = default;
};

/// Thickness [m] that gives a beam the stiffness kz [N/m] at its tip.
[[nodiscard]] double thicknessForStiffness(const CantileverGeometry& geometry,
                                           double stiffness) noexcept;

/// St Venant torsion factor beta of a rectangle, J = beta w t^3. Source: docs/theory.md 5.1, T18.
[[nodiscard]] double torsionFactor(double thicknessOverWidth) noexcept;

/// Compliance and lever sensitivities of a cantilever; a tip set back from the free end loads the
/// beam there, and the rest of the beam stays straight. Source: docs/theory.md 5.1-5.4.
class Cantilever {
public:
    /// @throw Error naming the value that is far from that of any lever, or no number: lengths 1 nm
    ///        to 1 m, stiffness 1e-9 to 1e9 N/m, Poisson's ratio 0 to 0.5, tilt a quarter turn
    explicit Cantilever(const CantileverGeometry& geometry);

    /// The same lever, but that no force across it turns it. The signal of torsion stays.
    [[nodiscard]] Cantilever rigidInTorsion() const noexcept;

    [[nodiscard]] const CantileverGeometry& geometry() const noexcept { return geometry_; }
    [[nodiscard]] double stiffness() const noexcept { return stiffness_; }  ///< kz at the tip [N/m]

    /// Tip displacement per force, cantilever frame [m/N].
    [[nodiscard]] const Matrix3& complianceInCantileverFrame() const noexcept {
        return compliance_;
    }
    /// Tip displacement per force, lab frame [m/N].
    [[nodiscard]] const Matrix3& compliance() const noexcept { return labCompliance_; }
    /// Rows are the cantilever's axes in the lab frame: v_cantilever = rotation() * v_lab.
    [[nodiscard]] const Matrix3& rotation() const noexcept { return rotation_; }

    [[nodiscard]] double bendingPerFz() const noexcept { return bendingPerFz_; }  ///< cz [rad/N]
    [[nodiscard]] double bendingPerFx() const noexcept { return bendingPerFx_; }  ///< cx [rad/N]
    [[nodiscard]] double torsionPerFy() const noexcept { return torsionPerFy_; }  ///< cy [rad/N]
    /// Returns whether a force at the tip (lab frame [N]) does so, see CantileverGeometry.
    [[nodiscard]] bool isBentTooFar(const Vector3& force) const noexcept;

    /// kappa: how much bending signal Fx causes next to Fz.
    [[nodiscard]] double couplingRatio() const noexcept {
        return 2.0 * geometry_.tipHeight / geometry_.loadPoint();
    }

private:
    CantileverGeometry geometry_;
    double stiffness_ = 0.0;
    double bendingPerFz_ = 0.0;
    double bendingPerFx_ = 0.0;
    double torsionPerFy_ = 0.0;
    Matrix3 compliance_ = Matrix3::Zero();
    Matrix3 rotation_ = Matrix3::Identity();
    Matrix3 labCompliance_ = Matrix3::Zero();
};

/// One flexural mode of a clamped-free beam, normalized to the deflection of its free end.
struct FlexuralMode {
    double waveNumber = 0.0;        ///< beta_n l, a root of cos x cosh x = -1
    double angularFrequency = 0.0;  ///< omega_n [rad/s]
    double stiffness = 0.0;         ///< k_n [N/m]
    double mass = 0.0;              ///< k_n / omega_n^2 [kg]
    double endSlope = 0.0;          ///< slope of the free end per its deflection [rad/m]

    [[nodiscard]] double frequency() const noexcept;  ///< f_n [Hz]
};

/// Flexural mode `number`, 1: the fundamental. Source: docs/theory.md 7.3, T17; the slope from the
/// mode shape cosh - cos - sigma (sinh - sin).
/// @throw Error when the number is not 1 to 100 or the geometry is no beam
[[nodiscard]] FlexuralMode flexuralMode(const CantileverGeometry& geometry, int number);

/// Mass of the beam without its tip [kg].
[[nodiscard]] double beamMass(const CantileverGeometry& geometry) noexcept;

/// Thickness [m] that gives a beam of known modulus its fundamental resonance [Hz].
[[nodiscard]] double thicknessForResonance(const CantileverGeometry& geometry, double resonance);

/// The beam whose thickness and Young's modulus give both the stiffness at the tip [N/m] and the
/// fundamental resonance [Hz] that were measured on it; length, width and density are kept.
[[nodiscard]] CantileverGeometry withStiffnessAndResonance(CantileverGeometry geometry,
                                                           double stiffness, double resonance);

/// The bent beam's axis at one distance from the clamp, cantilever frame.
struct CantileverShape {
    double deflection = 0.0;         ///< along z of the cantilever [m]
    double slope = 0.0;              ///< of the deflection [rad]
    double lateralDeflection = 0.0;  ///< along y of the cantilever [m]
    double lateralSlope = 0.0;       ///< of the lateral deflection, which no signal shows [rad]
    double torsion = 0.0;            ///< turn about the beam's axis [rad]
};

/// Shape under a force on the tip (lab frame [N]) at `distance` from the clamp, 0 .. length [m].
/// From the tip on the beam is straight.
/// Source: docs/theory.md 5.3.
[[nodiscard]] CantileverShape cantileverShape(const Cantilever& cantilever, const Vector3& force,
                                              double distance) noexcept;

}  // namespace asperity
