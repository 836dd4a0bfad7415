#pragma once

#include "app/reports/page/ReportPage.h"
#include "app/reports/run/ReportedRun.h"
#include "app/reports/run/TouchSection.h"

#include <optional>
#include <string>
#include <vector>

namespace asperity {

/// A run in the list of all: what is left of it when its scene is gone.
struct IndexedRun {
    std::string name;  ///< of its page
    std::string sample;
    std::string material;
    double tipRadius = 0.0;  ///< [m]
    long touches = 0;
    std::optional<TouchMean> pullOff;       ///< [N]
    std::optional<TouchMean> adhesionWork;  ///< [J]
    double maxIndentation = 0.0;            ///< [m]
    std::string validity;                   ///< a few words
};

[[nodiscard]] IndexedRun indexed(const ReportedRun& run);

/// The page that lists runs, a row each, and leads to their pages. @param name of its files
[[nodiscard]] ReportPage indexPage(const std::string& name, const std::vector<IndexedRun>& runs);

}  // namespace asperity
