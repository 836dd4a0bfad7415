#pragma once

#include "app/maps/ComparedMap.h"

#include <span>
#include <string>

namespace asperity {

/// How much the prediction explains, or why that is not defined.
[[nodiscard]] std::string findingOn(const MapComparison& numbers);

/// One line for people: what was compared with what, and what came out.
[[nodiscard]] std::string sentenceOn(const ComparedMap& compared);

/// The comparison as JSON: docs/maps.md, all numbers in SI units.
[[nodiscard]] std::string comparisonJson(const MeasuredFile& file, const MapPlan& plan,
                                         std::span<const ComparedMap> maps);

}  // namespace asperity
