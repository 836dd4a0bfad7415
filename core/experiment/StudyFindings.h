#pragma once

#include "core/experiment/StudyStatistics.h"

#include <span>
#include <string>
#include <vector>

namespace asperity {

/// How a finding of the paper stands beside ours.
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
