#pragma once

#include "app/reports/page/ReportPage.h"
#include "app/reports/run/RunHistory.h"

namespace asperity {

/// The force–distance curves of the first touches.
void addCurves(PageContent& page, const RunHistory& history);

}  // namespace asperity
