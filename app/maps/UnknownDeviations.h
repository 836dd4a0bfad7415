#pragma once

#include "app/maps/MapPart.h"

#include <cstddef>
#include <string>
#include <vector>

namespace asperity {

/// Returns in how many of the computed pixels a standard deviation is not known, and why, in one
/// sentence: a blank is no deviation of 0. Empty where all are known, or the quantity is none.
/// @param place of the quantity in the plan  @throw Error as MapPart::read()
[[nodiscard]] std::string unknownDeviations(const MapPlan& plan, const MapPart& part,
                                            std::size_t place);

/// The same of all standard deviations of a map, each with its name.
[[nodiscard]] std::vector<std::string> unknownDeviations(const MapPlan& plan, const MapPart& part);

}  // namespace asperity
