#pragma once

#include "app/experiment/ExperimentFolder.h"

#include <string>
#include <vector>

namespace asperity {

/// Writes what the folder's trials say: statistics.csv, findings.csv, and summary.json, which holds
/// both with the counts of trials and faults. Columns and schema: docs/study.md. @throw Error
void writeStudyResults(const ExperimentFolder& folder);

/// The same for people: means by task and material, and the paper's findings beside ours.
[[nodiscard]] std::string studyText(const ExperimentFolder& folder);

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

/// Draws the figures of the paper of what is in the folder, each as PNG and SVG: force against time
/// by task and material (11), mean error (12) and mean time (13) with their intervals.
/// There is a QGuiApplication. @throw Error
void writeStudyFigures(const ExperimentFolder& folder);

}  // namespace asperity
