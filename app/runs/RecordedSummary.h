#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace asperity {

/// What was decided about a term of a run's model when it was made.
struct RecordedTerm {
    std::string name;
    bool on = false;
    bool overruled = false;  ///< by the scene
    double effect = 0.0;     ///< of leaving it out, as a share of what it changes most
    std::string why;
};

/// The program that made a run.
struct RecordedProgram {
    std::string version;
    std::string compiler;
};

/// @return nothing where the folder does not say
[[nodiscard]] std::optional<RecordedProgram> programOf(const std::filesystem::path& folder);

/// What summary.json says that is not found in the run itself again, as its scene has all that was
/// decided settled: why.
struct RecordedSummary {
    std::vector<std::string> notes;
    std::vector<RecordedTerm> terms;
};

/// What an earlier version did not write is empty.
/// @return nothing where the folder has no summary: the run was cut off
/// @throw InputError where it is damaged
[[nodiscard]] std::optional<RecordedSummary> readSummary(const std::filesystem::path& folder);

}  // namespace asperity
