#pragma once

#include "app/commands/ConvertOptions.h"
#include "core/io/heightmap/HeightMapFormat.h"

#include <string>

namespace asperity {

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
