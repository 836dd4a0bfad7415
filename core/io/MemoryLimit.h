#pragma once

#include <cstdint>
#include <string>

namespace asperity {

/// Returns what one input may take of the machine's memory: half of it [bytes]. ASPERITY_MEMORY
/// [bytes] stands for the machine's, for tests.
[[nodiscard]] std::uint64_t memoryForInput();

/// Refuses an input before it is decoded. @param needed bytes of memory that it will take
/// @param place in the file, for the message
/// @throw InputError with both numbers where that exceeds memoryForInput()
void requireMemory(std::uint64_t needed, const std::string& file, const std::string& place);

}  // namespace asperity
