#pragma once

#include "tests/support/Places.h"

#include <filesystem>

namespace asperity::test {

/// A shipped scan of atomic steps.
inline const std::filesystem::path kSteps = dataFolder() / "samples/steps.gsf";

}  // namespace asperity::test
