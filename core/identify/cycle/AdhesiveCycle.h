#pragma once

#include "core/EnumTable.h"
#include "core/contact/laws/TwoWorkContact.h"
#include "core/identify/cycle/MeasuredCycle.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace asperity {

/// Effect of a wrong InvOLS on the spring constant of a file.
enum class SpringCalibration : std::uint8_t {
    Thermal,  ///< from a thermal spectrum with the same InvOLS: k goes with its inverse square
    Fixed,    ///< from elsewhere: k holds
};

template <>
inline constexpr auto kEnumTable<SpringCalibration> = std::to_array<EnumRow<SpringCalibration>>(
    {{SpringCalibration::Thermal, "thermal"}, {SpringCalibration::Fixed, "fixed"}});

/// A lever as its file calibrates it, whose true InvOLS is `gain` times the file's.
struct CycleLever {
    double stiffness = 0.0;  ///< by the file [N/m]
    double gain = 1.0;
    SpringCalibration calibration = SpringCalibration::Thermal;

    [[nodiscard]] double trueStiffness() const noexcept {  ///< [N/m]
        return calibration == SpringCalibration::Thermal ? stiffness / (gain * gain) : stiffness;
    }
    /// Force in the file over the true one.
    [[nodiscard]] double forceFactor() const noexcept {
        return stiffness / (trueStiffness() * gain);
    }
};

/// Tip, sample and lever of a quasi-static cycle.
struct AdhesiveParameters {
    ContactLaw law = ContactLaw::Jkr;  ///< without a tail or a film
    double tipRadius = 0.0;            ///< [m]
    double reducedModulus = 0.0;       ///< E* [Pa]
    double approachWork = 0.0;         ///< work of adhesion while the contact grows [J/m^2]
    double retractWork = 0.0;          ///< the same while it shrinks; as on approach but for JKR
    double cohesiveRange = 0.0;        ///< h0 of the Maugis laws [m]
    double contactPoint = 0.0;         ///< x0, base position at first touch of unbent lever [m]
    CycleLever lever;
};

/// Returns whether the law holds for the parameters.
[[nodiscard]] bool isWithinLaw(const AdhesiveParameters& parameters) noexcept;

/// Forward simulation of a quasi-static cycle: the tip is free until it snaps in where its law does
/// on this lever, then bonded at the same base position, until the fold of the base position.
/// Forces are as the file's calibration shows them. Source: docs/theory.md 7.1.
class AdhesiveCycle {
public:
    /// @throw Error where isWithinLaw() is false
    explicit AdhesiveCycle(const AdhesiveParameters& parameters);

    [[nodiscard]] const AdhesiveParameters& parameters() const noexcept { return parameters_; }

    /// Force at the next base position [N].
    [[nodiscard]] double force(double base, ContactMemory& memory) const noexcept;
    /// The law with which the contact grows.
    [[nodiscard]] ContactModel growing() const noexcept { return contact_.growing(); }
    /// Base position of the snap-in [m]; none: the law has no adhesion.
    [[nodiscard]] std::optional<double> snapIn() const noexcept;
    /// Base position at which the contact breaks [m]; none: the law has no adhesion.
    [[nodiscard]] std::optional<double> pullOff() const noexcept;
    /// The last force before that [N].
    [[nodiscard]] double pullOffForce() const noexcept;
    /// The strongest pull on the way out as a force, <= 0 [N].
    [[nodiscard]] double lowestForce() const noexcept;
    /// Transition parameter of the Maugis laws, 0 of others.
    [[nodiscard]] double transitionParameter() const noexcept { return contact_.lambda(); }

    /// Memory of a tip that has been in contact with growing load.
    [[nodiscard]] ContactMemory bonded() const noexcept;
    /// As force(), but a contact beyond its end keeps its last force: smooth for fits.
    [[nodiscard]] double bondedForce(double base, ContactMemory& memory) const noexcept;

private:
    [[nodiscard]] ContactState next(double base, ContactMemory& memory) const noexcept;

    AdhesiveParameters parameters_;
    double compliance_;  ///< of the true lever [m/N]
    ContactModel contact_;
    std::optional<TwoWorkContact> two_;  ///< of `contact_`, made once
    double lastForce_ = 0.0;             ///< of the law at its end on this lever [N]
};

/// Forces of a simulated cycle, a value a sample of the measured one [N].
struct SimulatedCycle {
    std::vector<double> approach;
    std::vector<double> dwell;
    std::vector<double> retract;
};

/// Simulates a cycle from its measured base motion alone.
[[nodiscard]] SimulatedCycle simulated(const AdhesiveCycle& model, const MeasuredCycle& cycle);

}  // namespace asperity
