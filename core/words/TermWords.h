#pragma once

#include "core/fidelity/SceneNeeds.h"

#include <string>

namespace asperity {

/// Why a term of a scene's model is worth what it is, in one clause with the quantity that decides;
/// of one that matters and is not in also what took its place. @param need one of the scene's
[[nodiscard]] std::string whyOf(const TermNeed& need, const SceneNeeds& needs);

}  // namespace asperity
