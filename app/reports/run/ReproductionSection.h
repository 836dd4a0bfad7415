#pragma once

#include "app/reports/page/ReportPage.h"
#include "app/reports/run/ReportedRun.h"

namespace asperity {

/// How to repeat the run: programs, commands, hashes, and whether the replay was the same.
void addReproduction(PageContent& page, const ReportedRun& run);

}  // namespace asperity
