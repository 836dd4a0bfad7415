#pragma once

#include "app/commands/ConvertOptions.h"

#include <filesystem>
#include <string>
#include <vector>

namespace asperity {

/// A file of the folder for each input: "scan.spm" becomes "scan.gsf"; "scan.001" and "scan.002",
/// which would share it, "scan.001.gsf" and "scan.002.gsf". An input that would still share one has
/// no output: the text is empty.
[[nodiscard]] std::vector<ConvertedFile> filesInFolder(const std::vector<std::string>& inputs,
                                                       const std::filesystem::path& folder,
                                                       const std::string& extension);

/// Converts files one after the other and says of each what came out of it; a bad one is told and
/// left out. @throw Error at the end when there was any; Canceled
void convertMany(const ConvertOptions& options);

}  // namespace asperity
