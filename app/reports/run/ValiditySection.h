#pragma once

#include "app/reports/page/ReportPage.h"
#include "app/reports/run/RunHistory.h"
#include "core/scene/LawRangeTally.h"

namespace asperity {

/// What the results do not hold for, in words: flags and faults with their ticks.
/// @param lawRange of the same ticks
void addValidity(PageContent& page, const RunHistory& history, const LawRangeTally& lawRange);

}  // namespace asperity
