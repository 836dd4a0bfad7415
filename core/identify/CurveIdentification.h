#pragma once

#include "core/EnumTable.h"
#include "core/contact/laws/ContactLaw.h"
#include "core/curves/MeasuredForceCurve.h"
#include "core/identify/ContactPoint.h"
#include "core/identify/CurvePreparation.h"
#include "core/identify/ElasticFit.h"
#include "core/identify/IdentifiedValue.h"
#include "core/identify/TipLaw.h"

#include <cstdint>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

namespace asperity {

/// Verdict on how well a curve and its simulation agree. Source: docs/measured.md.
enum class FitVerdict : std::uint8_t {
    Matched,     ///< the residuals are at most 2 % of the force range
    Partly,      ///< at most 4 %, in contact 6 %, or a test says that the model lacks something
    NotMatched,  ///< above
    Refused,     ///< nothing can be identified
};

template <>
inline constexpr auto kEnumTable<FitVerdict> =
    std::to_array<EnumRow<FitVerdict>>({{FitVerdict::Matched, "matched"},
                                        {FitVerdict::Partly, "partly", "partly matched"},
                                        {FitVerdict::NotMatched, "not_matched", "not matched"},
                                        {FitVerdict::Refused, "refused"}});

/// Relative standard deviations of what calibrates a curve. Source: docs/measured.md.
struct CalibrationDeviations {
    double stiffness = 0.10;
    double invols = 0.03;
    double tipRadius = 0.10;
    double tipAngle = 2.0 * std::numbers::pi / 180.0;  ///< absolute [rad]
};

/// Known values of tip and sample, and settings of a fit.
struct CurveFitOptions {
    PreparationOptions preparation;
    std::optional<TipForm> tip;  ///< none: only products with the tip's radius are identified
    double filmThickness = 0.0;  ///< of the sample on a rigid base [m]; 0: a half-space
    double poissonRatio = 0.5;
    ContactMethod contact = ContactMethod::Model;
    std::optional<ForceWindow> window;  ///< of the forces fitted; none: all
    bool judgesRetract = true;          ///< the retract is predicted and counts in the verdict
    bool fitsRetract = false;           ///< instead of the approach, which is predicted
    CalibrationDeviations deviations;
};

/// A number of a report.
struct FitNumber {
    std::string key;
    double value = 0.0;
};

struct FitCorrelation {
    std::string first;
    std::string second;
    double value = 0.0;
};

/// Another fit of the same curve.
struct FitVariant {
    std::string key;  ///< "rigid", "elastic", "one", "two"
    std::vector<IdentifiedValue> parameters;
    std::vector<FitNumber> residuals;
};

/// A branch as measured and as simulated. Arrays of one length; `time` may be empty.
struct ComparedBranch {
    BranchSamples measured;          ///< calibrated, its baseline not taken off
    std::vector<double> corrected;   ///< force without baseline [N]
    std::vector<double> separation;  ///< of tip and sample, < 0: indented [m]
    std::vector<double> fitted;      ///< force of the fit, without baseline [N]
    std::vector<double> forward;     ///< the same from the motion of the base alone [N]
};

/// All that is known of a curve after a fit.
struct CurveIdentification {
    FitVerdict verdict = FitVerdict::Refused;
    std::string model;                 ///< "elastic, sphere"
    std::optional<ContactLaw> law;     ///< of a scene with this contact; none: no scene has it
    std::vector<std::string> reasons;  ///< for the verdict, and what limits the values
    std::vector<IdentifiedValue> parameters;
    std::vector<FitNumber> residuals;  ///< rms, as shares of the force range
    std::vector<FitVariant> variants;
    std::vector<FitNumber> tests;
    std::vector<FitNumber> contactPoints;  ///< base by each method [m]
    std::vector<FitCorrelation> correlations;
    std::vector<PreparationStep> steps;
    double forceRange = 0.0;     ///< of the cycle [N]
    double noise = 0.0;          ///< of the force [N]
    std::optional<TipForm> tip;  ///< that was named
    bool fitsApproach = true;    ///< false: it is predicted
    bool fitsRetract = false;    ///< same
    ComparedBranch approach;
    ComparedBranch retract;

    [[nodiscard]] const IdentifiedValue* find(const std::string& key) const noexcept;
};

/// Prepares a curve, fits it elastically and predicts what was not fitted. A curve that must be
/// refused gets that verdict, with the reason. @throw Error where the options do not go together
[[nodiscard]] CurveIdentification identifyElastic(const MeasuredForceCurve& curve,
                                                  const CurveFitOptions& options);

/// Smallest range of force, in standard deviations of the noise, and number of samples in contact
/// with which a curve is not refused.
inline constexpr double kMinRangeOverNoise = 10.0;
inline constexpr std::size_t kMinContactSamples = 20;

/// Returns the verdict on residuals in contact and of the cycle, as shares of its force range.
/// @param isDoubtful something speaks against the model
[[nodiscard]] FitVerdict verdictOf(double contact, double cycle, bool isDoubtful) noexcept;

}  // namespace asperity
