#pragma once

#include "app/reports/page/ReportPage.h"
#include "app/reports/run/RunSections.h"
#include "app/runs/OutputFolder.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace asperity {

/// All that a report says of one run. @param parent name of the page that lists it; empty: none
[[nodiscard]] ReportPage runPage(const ReportedRun& run, const std::string& parent);

/// A run in the list of all: the results that outlive its scene.
struct IndexedRun {
    std::string name;  ///< of its page
    std::string sample;
    std::string material;
    double tipRadius = 0.0;  ///< [m]
    long cycles = 0;
    std::optional<CycleMean> pullOff;       ///< [N]
    std::optional<CycleMean> adhesionWork;  ///< [J]
    double maxIndentation = 0.0;            ///< [m]
    std::string validity;                   ///< a few words
};

[[nodiscard]] IndexedRun indexed(const ReportedRun& run);

/// The page that lists runs, a row each, and leads to their pages. @param name of its files
[[nodiscard]] ReportPage indexPage(const std::string& name, const std::vector<IndexedRun>& runs);

/// Lists the pages of a report and represents all of it; a name that nobody else gives.
inline constexpr const char* kReportList = "asperity_report.json";

/// Name of the page that lists several runs.
inline constexpr const char* kReportIndex = "index";

/// Returns the content of a folder of `asperity report`: it replaces all of an earlier report, and
/// no other files of these names unasked.
/// @param pages names without suffix
[[nodiscard]] FolderContent reportContent(const std::filesystem::path& folder,
                                          const std::vector<std::string>& pages);

/// @param pages names without suffix @throw Error
void writeReportList(const std::filesystem::path& folder, const std::vector<std::string>& pages);

}  // namespace asperity
