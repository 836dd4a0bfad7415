#pragma once

namespace asperity {

/// Cores that this process may use, at least 1: a launcher such as mpirun binds its processes to
/// some of the machine's.
[[nodiscard]] int allowedCores() noexcept;

}  // namespace asperity
