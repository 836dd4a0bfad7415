#pragma once

#include "app/reports/page/ReportPage.h"
#include "app/reports/run/ReportedRun.h"

namespace asperity {

/// The deformed sample at the deepest indentation and before pull-off, and the numbers of these
/// moments as the contact model has them.
void addPictures(PageContent& page, const ReportedRun& run);

}  // namespace asperity
