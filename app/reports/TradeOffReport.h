#pragma once

#include "core/fidelity/SceneNeeds.h"
#include "core/studies/DeformationStudy.h"
#include "core/studies/TradeOffStudy.h"

#include <vector>

namespace asperity {

/// All three for people, to standard output. @param tolerance of errors, as a share
void printTradeOff(const TradeOff& study, double tolerance);
void printNeeds(const SceneNeeds& needs);
void printDeformations(const std::vector<DeformationResult>& results);

}  // namespace asperity
