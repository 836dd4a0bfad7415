#pragma once

#include "core/deformation/HalfSpaceModel.h"

#include <string>

namespace asperity {

/// In one sentence: own force beside the law's, or why the answer is not used.
[[nodiscard]] std::string sentenceOf(const HalfSpaceJudgment& judgment);

}  // namespace asperity
