#pragma once

#include "bench/BenchRows.h"
#include "bench/surface/BenchReport.h"

namespace asperity {

/// What closest point, force and decoupling are to reach, each figure beside its goal; of the works
/// that ran.
[[nodiscard]] std::vector<BenchRow> searchRows(const BenchResults& results);

}  // namespace asperity
