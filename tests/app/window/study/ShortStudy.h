#pragma once

#include "core/experiment/Study.h"
#include "tests/support/ScratchFolder.h"

#include <filesystem>

namespace asperity::test {

/// Task B on polystyrene, two trials at one target, no training.
[[nodiscard]] Study shortStudy();

/// Writes a study with all that it names into a folder. @return its file
std::filesystem::path writtenStudy(ScratchFolder& folder, const Study& study);

}  // namespace asperity::test
