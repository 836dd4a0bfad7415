#pragma once

#include <cstdint>
#include <cstdlib>
#include <string>

namespace asperity::test {

/// While one lives, the machine has this much memory, as far as inputs are concerned.
class GivenMemory {
public:
    explicit GivenMemory(std::uint64_t bytes) {
        setenv("ASPERITY_MEMORY", std::to_string(bytes).c_str(), 1);
    }
    ~GivenMemory() { unsetenv("ASPERITY_MEMORY"); }
    GivenMemory(const GivenMemory&) = delete;
    GivenMemory& operator=(const GivenMemory&) = delete;
};

}  // namespace asperity::test
