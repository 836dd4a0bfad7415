#pragma once

#include "app/reports/page/ReportPage.h"
#include "app/reports/run/RunHistory.h"

namespace asperity {

/// What the results do not hold for, in words: flags and faults with their ticks.
void addValidity(PageContent& page, const RunHistory& history);

}  // namespace asperity
