#pragma once

#include <filesystem>

namespace asperity {

/// Where the program keeps what it writes for the user, among the user's documents.
[[nodiscard]] std::filesystem::path userFolder();

}  // namespace asperity
