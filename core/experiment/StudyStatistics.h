#pragma once

#include "core/experiment/TrialPlan.h"

#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace asperity {

/// A mean with its 95 % confidence interval; what too few values do not tell is no number.
struct Estimate {
    std::size_t count = 0;  ///< of the values
    double mean = 0.0;
    double deviation = 0.0;  ///< of a single value
    double low = 0.0;        ///< of the interval
    double high = 0.0;       ///< of the interval

    /// Returns whether there are enough values for an interval.
    [[nodiscard]] bool hasInterval() const noexcept {
        return std::isfinite(low) && std::isfinite(high) && count > 1;
    }
    [[nodiscard]] bool isAbove(double value) const noexcept { return low > value; }
    [[nodiscard]] bool isBelow(double value) const noexcept { return high < value; }
};

/// Returns the estimate from independent values, by Student's t. Source: Student (1908).
[[nodiscard]] Estimate estimateOf(std::span<const double> values);

/// Pearson's correlation of pairs, with the interval of Fisher's transformation. `mean` is the
/// correlation, `deviation` is no number. Source: Fisher (1921).
[[nodiscard]] Estimate correlationOf(std::span<const double> x, std::span<const double> y);

/// Slope of the straight line through pairs, by least squares; no number where all x are equal.
[[nodiscard]] double slopeOf(std::span<const double> x, std::span<const double> y);

/// Quantity that is estimated from a study.
enum class StudyQuantity : std::uint8_t {
    ErrorPercent,
    Time,           ///< [s]
    ErrorLearning,  ///< change of the error in percent with each repeat
    TimeLearning,   ///< change of the time with each repeat [s]
    TimeAndError,   ///< correlation of both
    FaultShare,     ///< of all trials begun, those that a fault ended
};

template <>
inline constexpr auto kEnumTable<StudyQuantity> = std::to_array<EnumRow<StudyQuantity>>(
    {{StudyQuantity::ErrorPercent, "error_percent"},
     {StudyQuantity::Time, "time_s"},
     {StudyQuantity::ErrorLearning, "error_percent_per_repeat"},
     {StudyQuantity::TimeLearning, "time_s_per_repeat"},
     {StudyQuantity::TimeAndError, "correlation_of_time_and_error"},
     {StudyQuantity::FaultShare, "share_of_faults"}});

/// One estimate, of the trials of a task, and of a material and lever where these are named.
struct StudyEstimate {
    StudyQuantity quantity = StudyQuantity::ErrorPercent;
    TaskKind task = TaskKind::On;
    std::string material;  ///< empty: of all
    std::string lever;     ///< empty: of all
    Estimate value;
};

/// Returns the estimates from all valid trials: error and time by task, and by task, material
/// and lever; learning and the relation of time and error by task. A participant's mean is one
/// value, and so is the slope of its trials over the repeats: trials of one person are not
/// independent. The correlation is that of the trials' deviations from their cell's mean, so that
/// neither persons nor materials make it.
[[nodiscard]] std::vector<StudyEstimate> studyStatistics(const Study& study,
                                                         std::span<const TrialRecord> trials);

/// Value measured of a trial, and choice of trials.
using TrialValue = std::function<double(const TrialRecord&)>;
using TrialChoice = std::function<bool(const TrialRecord&)>;

/// A mean for each participant of the valid trials.
[[nodiscard]] std::map<int, double> participantMeans(std::span<const TrialRecord> trials,
                                                     const TrialChoice& choice,
                                                     const TrialValue& value);
/// Returns one less other, of the participants that have both.
[[nodiscard]] Estimate pairedDifference(const std::map<int, double>& one,
                                        const std::map<int, double>& other);

/// The estimate of a quantity; null: there is none.
[[nodiscard]] const StudyEstimate* find(std::span<const StudyEstimate> estimates,
                                        StudyQuantity quantity, TaskKind task,
                                        const std::string& material = {});

/// Comparison of a finding of the paper with ours.
enum class FindingVerdict : std::uint8_t {
    Agrees,
    Differs,
    Open,       ///< ours leave it open: an interval holds both answers
    NotTested,  ///< this study has no trials that tell
};

template <>
inline constexpr auto kEnumTable<FindingVerdict> = std::to_array<EnumRow<FindingVerdict>>(
    {{FindingVerdict::Agrees, "agrees"},
     {FindingVerdict::Differs, "differs"},
     {FindingVerdict::Open, "open"},
     {FindingVerdict::NotTested, "not_tested", "not tested"}});

/// One finding of Vogl, Ma, Sitti (2005), VII, beside ours.
struct StudyFinding {
    std::string paper;  ///< what it says
    std::string ours;   ///< the figures that tell
    FindingVerdict verdict = FindingVerdict::NotTested;
};

/// All findings in the order of the paper. What is said of two conditions is compared within each
/// participant; it agrees or differs where the 95 % interval of the difference leaves out 0.
[[nodiscard]] std::vector<StudyFinding> findingsOf(const Study& study,
                                                   std::span<const TrialRecord> trials);

}  // namespace asperity
