#pragma once

#include "core/surface/Provenance.h"

#include <nlohmann/json.hpp>
#include <vector>

namespace asperity {

/// A list of objects with `what`, `value` and `source`.
[[nodiscard]] nlohmann::ordered_json provenanceJson(const std::vector<Provenance>& entries);

}  // namespace asperity
