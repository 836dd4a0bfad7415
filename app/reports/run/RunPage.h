#pragma once

#include "app/reports/page/ReportPage.h"
#include "app/reports/run/ReportedRun.h"

namespace asperity {

/// All that a report says of one run. @param parent name of the page that lists it; empty: none
[[nodiscard]] ReportPage runPage(const ReportedRun& run, const std::string& parent);

}  // namespace asperity
