#pragma once

#include "core/fidelity/SceneNeeds.h"

#include <string>

namespace asperity {

/// The error of a model's force and what makes it up, for people, in one clause: "forces within
/// 5.4 % of their rms in 97 ticks of 100: 0.2 % by what is left out, 5.2 % by what no contact law
/// has beside the rest (sphere correction)".
[[nodiscard]] std::string forceErrorText(const SceneNeeds& needs);

/// The same with the terms that the model leaves out, but for those its law has no room for: they
/// are told with the error.
[[nodiscard]] std::string modelNote(const SceneNeeds& needs);

}  // namespace asperity
