#pragma once

#include "app/runs/RunFormat.h"
#include "core/surface/GivenScale.h"
#include "core/surface/leveling/LevelingStep.h"

#include <optional>
#include <string>
#include <vector>

namespace asperity {

/// What `asperity convert` was called with.
struct ConvertOptions {
    std::string input;
    std::vector<std::string>
        others;             ///< the output file, or further inputs where there is a folder
    std::string folder;     ///< of the output files; empty: there is one output file
    std::string extension;  ///< of the files in the folder: "gsf"
    std::string channel;
    bool all = false;  ///< all channels, whatever they show
    int bits = 0;      ///< of a sample, where the format leaves a choice; 0: as the format does
    GivenScale scale;
    LevelingSteps leveling;
    std::optional<LevelPoints> levelPoints;  ///< of the step three_point
    bool residual = false;
    double smoothingPixels = 1.0;        ///< of the residual's surface
    double smoothingLength = 0.0;        ///< above 0: in place of smoothingPixels [m]
    double tipRadius = 0.0;              ///< of the tip whose shape is taken out [m]; 0: none is
    std::string certainty;               ///< file for the certainty map; empty: none
    std::optional<RunFormat> runFormat;  ///< the input is a run, and its tables are converted
    bool force = false;                  ///< files that are there may go
};

/// What one conversion reads, and what it writes.
struct ConvertedFile {
    std::string input;
    std::string output;
};

}  // namespace asperity
