#pragma once

namespace asperity {

/// Version of the program, from the build.
inline constexpr const char* kVersion = ASPERITY_VERSION;

}  // namespace asperity
