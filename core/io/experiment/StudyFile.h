#pragma once

#include "core/experiment/Study.h"
#include "core/experiment/TrialPlan.h"

#include <filesystem>
#include <span>
#include <vector>

namespace asperity {

/// Reads a study (TOML); every key is documented in docs/study.md. Paths in it are relative to it.
/// @throw InputError on a mistake, an unknown key, a study that contradicts itself, or a file that
/// it names and that cannot be read
[[nodiscard]] Study readStudy(const std::filesystem::path& path);

/// Writes `study.toml` into a folder with all that it names beside it: scene, materials, levers.
/// Reading it gives the same study. @throw Error, FileError
void writeStudy(const Study& study, const std::filesystem::path& folder);

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
