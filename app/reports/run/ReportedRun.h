#pragma once

#include "app/program/LoadedScene.h"
#include "app/reports/run/RunHistory.h"
#include "app/runs/RecordedSummary.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace asperity {

/// The hash of a file of a run.
struct HashedFile {
    std::string sha256;
    std::string file;  ///< path as the user gave it
};

/// A run, replayed, as its page describes it.
struct ReportedRun {
    std::string name;              ///< of the files of its page
    std::filesystem::path folder;  ///< as the user gave it
    const LoadedScene& loaded;     ///< lives until its page is made
    RunHistory history;
    std::optional<RecordedProgram> program;  ///< that made it; none: its folder does not say
    std::optional<RecordedSummary> summary;  ///< none: the run was cut off
    std::string state;       ///< that it was cut off, a sentence; empty: it is complete
    std::string difference;  ///< first tick that the replay has otherwise; empty: none
    std::vector<HashedFile> hashes;
    std::string overview;     ///< PNG
    std::string deformation;  ///< PNG; empty: the tip never touched
};

}  // namespace asperity
