#pragma once

#include "app/experiment/ExperimentFolder.h"

#include <string>
#include <vector>

namespace asperity {

/// A study with one aid changed.
struct AidVariant {
    std::string name;  ///< of its folder; "as_given" is the study itself
    Study study;
};

/// The study as it is given, then without coupling, without forces, without the picture of the
/// deformation, with a guide to the target: those that differ from it.
[[nodiscard]] std::vector<AidVariant> aidVariants(const Study& study);

/// One variant's results.
struct AidResult {
    std::string name;
    std::vector<TrialRecord> trials;
};

/// Writes how error, time and the motion of the handle of each variant differ from those of the
/// first one, by task: columns in docs/study.md. @throw Error
void writeAids(const std::filesystem::path& path, const Study& study,
               const std::vector<AidResult>& results);

}  // namespace asperity
