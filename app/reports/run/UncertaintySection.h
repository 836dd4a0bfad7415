#pragma once

#include "app/reports/page/ReportPage.h"
#include "app/reports/run/TouchSection.h"

#include <vector>

namespace asperity {

struct Scene;

/// What model and calibration leave open in the readings of the touches, and by which input most;
/// nothing where the scene has it off or nothing touched.
void addUncertainty(PageContent& page, const Scene& scene,
                    const std::vector<BudgetedTouch>& touches);

}  // namespace asperity
