#pragma once

#include "app/reports/page/ReportPage.h"
#include "app/reports/run/ReportedRun.h"

namespace asperity {

/// What was touched and where: the scan, what its scale comes from, the place of the tip.
void addSample(PageContent& page, const ReportedRun& run);

}  // namespace asperity
