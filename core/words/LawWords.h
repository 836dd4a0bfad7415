#pragma once

#include "core/contact/laws/LawChoice.h"
#include "core/scene/Scene.h"

#include <string>

namespace asperity {

/// Why a contact law was taken, in one clause.
[[nodiscard]] std::string whyOf(const LawChoice& choice);

/// The scene's contact law, why it was taken, and how well its table has it.
[[nodiscard]] std::string lawNote(const Scene& scene);

}  // namespace asperity
