#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace asperity::test {

/// Result of a content that a process of its own read.
struct BoundedRead {
    bool isRead = false;       ///< else it was refused by name, or `failure` says what happened
    std::string failure;       ///< a crash, no answer, no memory; empty: none of these
    double seconds = 0.0;      ///< of the processor
    std::uint64_t memory = 0;  ///< the most it held at a time, beyond what the process began with
};

/// Reads a content that is called "damaged". @throw InputError where it is refused
using ReadDamaged = std::function<void(std::string_view bytes)>;

/// Reads a content in a process of its own.
/// @param most bytes of memory that the process may ask for, whether it uses them or not
[[nodiscard]] BoundedRead readBounded(std::string_view bytes, std::uint64_t most,
                                      const ReadDamaged& read);
/// Reads all pixels of a content as a height map, without Gwyddion. @param most as above
[[nodiscard]] BoundedRead readBounded(std::string_view bytes, std::uint64_t most);

}  // namespace asperity::test
