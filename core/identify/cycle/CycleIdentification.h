#pragma once

#include "core/identify/CurveIdentification.h"
#include "core/identify/cycle/AdhesiveFit.h"
#include "core/identify/cycle/ModelComparison.h"

#include <optional>

namespace asperity {

/// Contact law of a fit; sphere or paraboloid follow from the tip.
enum class SampleLaw : std::uint8_t { Elastic, Dmt, Jkr, Maugis, Automatic };

template <>
inline constexpr auto kEnumTable<SampleLaw> =
    std::to_array<EnumRow<SampleLaw>>({{SampleLaw::Elastic, "elastic"},
                                       {SampleLaw::Dmt, "dmt", "DMT"},
                                       {SampleLaw::Jkr, "jkr", "JKR"},
                                       {SampleLaw::Maugis, "md", "Maugis-Dugdale"},
                                       {SampleLaw::Automatic, "auto", "by Tabor number"}});

/// How a curve is identified.
struct CycleFitOptions {
    CurveFitOptions curve;
    SampleLaw law = SampleLaw::Elastic;
    bool twoWorks = false;    ///< of adhesion, on approach and on retract
    bool relaxation = false;  ///< of the sample, with the elastic law
    bool drag = false;        ///< by the wall, with the elastic law
    FittedBranch branch = FittedBranch::Both;
    bool compares = false;  ///< all models that the curve can carry

    /// Returns whether nothing but an elastic contact is asked for.
    [[nodiscard]] bool isPlain() const noexcept {
        return law == SampleLaw::Elastic && !relaxation && !drag;
    }
};

/// Returns a prepared curve for the fits of cycles: its baseline taken off.
[[nodiscard]] MeasuredCycle measuredCycle(const PreparedCurve& curve);

/// Modulus of a sample that counts as rigid [Pa]. By convention, see docs/measured.md.
inline constexpr double kRigidModulus = 70e9;

/// Identifies a curve as it is asked for, and simulates it. A curve that must be refused gets that
/// verdict. @throw Error where the options do not go together
[[nodiscard]] CurveIdentification identifyCurve(const MeasuredForceCurve& curve,
                                                const CycleFitOptions& options);

/// Compares the models that a curve can carry; none, with the reason, where it has no contact.
/// @throw Error where no sphere or paraboloid is named
[[nodiscard]] ModelComparison compareCurve(const MeasuredForceCurve& curve,
                                           const CycleFitOptions& options);

}  // namespace asperity
