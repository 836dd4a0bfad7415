#pragma once

#include "app/reports/page/ReportPage.h"

namespace asperity {

struct Scene;

/// Tip, lever, material and what else the forces follow from, each with its source; and where the
/// instrument is not what the model takes it to be.
void addParameters(PageContent& page, const Scene& scene);

}  // namespace asperity
