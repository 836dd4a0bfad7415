#pragma once

#include "app/program/LoadedScene.h"
#include "core/map/MapPlan.h"

#include <string>

namespace asperity {

/// SHA-256 of all that the values of a map depend on: the program's version and commit, the scan's
/// content, the scene with the model that it is computed with, and the plan; 64 hexadecimal digits.
[[nodiscard]] std::string mapKey(const LoadedScene& loaded, const MapPlan& plan);

}  // namespace asperity
