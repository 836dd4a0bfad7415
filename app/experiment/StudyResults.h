#pragma once

#include "app/experiment/ExperimentFolder.h"

#include <string>

namespace asperity {

/// Writes what the folder's trials say: statistics.csv, findings.csv, and summary.json, which holds
/// both with the counts of trials and faults. Columns and schema: docs/study.md. @throw Error
void writeStudyResults(const ExperimentFolder& folder);

/// The same for people: means by task and material, and the paper's findings beside ours.
[[nodiscard]] std::string studyText(const ExperimentFolder& folder);

}  // namespace asperity
