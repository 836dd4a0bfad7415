#pragma once

#include <cstddef>

namespace asperity::test {

/// How often the program has asked for memory so far: by operator new, and by the malloc family in
/// our own code and in the headers it includes (Eigen goes past operator new).
[[nodiscard]] std::size_t allocationCount() noexcept;

}  // namespace asperity::test
