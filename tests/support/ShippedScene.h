#pragma once

#include <filesystem>
#include <string>

namespace asperity::test {

/// A scene that ships with the program, e.g. "polystyrene".
[[nodiscard]] inline std::filesystem::path shippedScene(const std::string& name) {
    return std::filesystem::path(ASPERITY_DATA_DIR) / "scenes" / (name + ".toml");
}

}  // namespace asperity::test
