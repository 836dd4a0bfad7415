#pragma once

#include <exception>

namespace asperity {

// The exit codes are part of the command line's contract.
inline constexpr int kFailed = 1;
inline constexpr int kWrongUsage = 2;
inline constexpr int kFileError = 3;

/// Says on standard error in one sentence what went wrong. @return the exit code that tells it
[[nodiscard]] int tellError(const std::exception_ptr& error);

}  // namespace asperity
