#pragma once

#include "app/commands/CurveFileOptions.h"
#include "app/runs/RunFolder.h"
#include "core/io/heightmap/HeightMapFormat.h"
#include "core/surface/GivenScale.h"
#include "core/surface/leveling/LevelingStep.h"

#include <optional>
#include <string>
#include <vector>

namespace asperity {

/// Options of `asperity convert`.
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
    CurveFileOptions curves;             ///< where the output is the table of a force curve
    bool force = false;                  ///< files that are there may be replaced
};

/// Input and output of one conversion.
struct ConvertedFile {
    std::string input;
    std::string output;
};

/// The formats that a map is written in with these options.
[[nodiscard]] HeightMapFormats targetFormats(const ConvertOptions& options);

/// All extensions that a map is written with, each format by its first.
[[nodiscard]] std::string targetExtensions();

/// Refuses options that no output file of this name can follow.
/// @param option that names the file, for messages
/// @throw CLI::ValidationError
void requireTarget(const ConvertOptions& options, const std::string& option,
                   const std::string& file);

/// Refuses output files that cannot be written, would replace a file or the input, or hold no map,
/// before long work is done for them.
/// @throw CLI::ValidationError; Error
void requireWritableTargets(const ConvertOptions& options, const ConvertedFile& file);

/// Shows how far writing is. @throw Error; Canceled
void writeTarget(const ConvertOptions& options, const std::string& file, const HeightRows& map,
                 const HeightMapMeta& meta);

}  // namespace asperity
