#pragma once

#include "core/experiment/Study.h"

namespace asperity::test {

/// The paper's materials and tasks on a plane, two repeats.
[[nodiscard]] Study smallStudy();

}  // namespace asperity::test
