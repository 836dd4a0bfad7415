#pragma once

#include <exception>
#include <string>

namespace asperity {

// The exit codes are part of the command line's contract.
inline constexpr int kFailed = 1;
inline constexpr int kWrongUsage = 2;
inline constexpr int kFileError = 3;

/// Returns what an error says as one line to print; what it quotes of a file can be of any length
/// and is cut.
[[nodiscard]] std::string messageOf(const std::exception& error);

/// Says on standard error in one sentence what went wrong. @return the exit code that tells it
[[nodiscard]] int tellError(const std::exception_ptr& error);

}  // namespace asperity
