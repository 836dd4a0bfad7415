#pragma once

#include "core/experiment/TrialRecord.h"

#include <filesystem>
#include <span>
#include <vector>

namespace asperity {

/// Writes `trials.csv`, a row a trial; a file in its place stays whole until the new one is.
/// Columns: docs/study.md. @throw Error, FileError
void writeTrials(const std::filesystem::path& path, const Study& study,
                 std::span<const TrialRecord> trials);

/// The trials of such a table. @throw InputError on a row that is none of this study
[[nodiscard]] std::vector<TrialRecord> readTrials(const std::filesystem::path& path,
                                                  const Study& study);

/// Writes the moments of one trial. Columns: docs/study.md. @throw Error, FileError
void writeMoments(const std::filesystem::path& path, std::span<const TrialMoment> moments);

/// The same, read again. @throw InputError
[[nodiscard]] std::vector<TrialMoment> readMoments(const std::filesystem::path& path);

}  // namespace asperity
