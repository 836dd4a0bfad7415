#pragma once

#include "app/runs/OutputFolder.h"

#include <filesystem>
#include <string>
#include <vector>

namespace asperity {

/// Lists the pages of a report and stands for the whole of it; a name that nobody else gives.
inline constexpr const char* kReportList = "asperity_report.json";

/// Name of the page that lists several runs.
inline constexpr const char* kReportIndex = "index";

/// What `asperity report` leaves in a folder: it replaces all of an earlier report, and no other
/// files of these names unasked.
/// @param pages names without suffix
[[nodiscard]] FolderContent reportContent(const std::filesystem::path& folder,
                                          const std::vector<std::string>& pages);

/// @param pages names without suffix @throw Error
void writeReportList(const std::filesystem::path& folder, const std::vector<std::string>& pages);

}  // namespace asperity
