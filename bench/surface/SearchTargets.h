#pragma once

#include "bench/BenchRows.h"
#include "bench/surface/BenchReport.h"

namespace asperity {

/// Targets of closest point, force and decoupling, each figure beside its goal; of the works
/// that ran.
[[nodiscard]] std::vector<BenchRow> searchRows(const BenchResults& results);

}  // namespace asperity
