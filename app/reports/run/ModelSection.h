#pragma once

#include "app/reports/page/ReportPage.h"
#include "app/reports/run/ReportedRun.h"

namespace asperity {

/// Contact law and approximations of the model, with why they were taken, as the run recorded it.
void addModel(PageContent& page, const ReportedRun& run);

}  // namespace asperity
