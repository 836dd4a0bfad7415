#pragma once

#include "tests/support/Places.h"

#include <filesystem>
#include <string>

namespace asperity::test {

/// A scene that ships with the program, e.g. "polystyrene".
[[nodiscard]] inline std::filesystem::path shippedScene(const std::string& name) {
    return dataFolder() / "scenes" / (name + ".toml");
}

}  // namespace asperity::test
