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
    std::string file;  ///< path as the user gave it, or name in a bundle
};

/// A run, replayed, as its page describes it.
struct ReportedRun {
    std::string name;              ///< of the files of its page
    std::filesystem::path folder;  ///< or bundle, as the user gave it
    std::string scan;              ///< its file, or its name in the bundle; empty: a shape
    const LoadedScene& loaded;     ///< lives until its page is made
    RunHistory history;
    std::optional<RecordedProgram> program;  ///< that made it; none: its folder does not say
    std::optional<RecordedSummary> summary;  ///< none: the run was cut off
    std::string state;                 ///< that it was cut off, a sentence; empty: it is complete
    std::string difference;            ///< first tick that the replay has otherwise; empty: none
    std::optional<HashedFile> bundle;  ///< none: the run is a folder
    std::vector<HashedFile> hashes;    ///< of its files, in the bundle where there is one
    std::string overview;              ///< PNG
    std::string deformation;           ///< PNG; empty: the tip never touched
};

}  // namespace asperity
