#pragma once

#include "core/experiment/Estimate.h"
#include "core/experiment/TrialRecord.h"

#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace asperity {

/// What is estimated of a study.
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

/// Of all trials that count: error and time by task, and by task, material and lever; learning and
/// the relation of time and error by task. A participant's mean is one value, and so is the slope
/// of its trials over the repeats: trials of one person are not independent. The correlation is
/// that of the trials' deviations from their cell's mean, so that neither persons nor materials
/// make it.
[[nodiscard]] std::vector<StudyEstimate> studyStatistics(const Study& study,
                                                         std::span<const TrialRecord> trials);

/// What is measured of a trial, and which trials are meant.
using TrialValue = std::function<double(const TrialRecord&)>;
using TrialChoice = std::function<bool(const TrialRecord&)>;

/// A mean for each participant of the trials that count.
[[nodiscard]] std::map<int, double> participantMeans(std::span<const TrialRecord> trials,
                                                     const TrialChoice& choice,
                                                     const TrialValue& value);
/// Of the participants that have both: one less other.
[[nodiscard]] Estimate pairedDifference(const std::map<int, double>& one,
                                        const std::map<int, double>& other);

/// The estimate of a quantity; null: there is none.
[[nodiscard]] const StudyEstimate* find(std::span<const StudyEstimate> estimates,
                                        StudyQuantity quantity, TaskKind task,
                                        const std::string& material = {});

}  // namespace asperity
