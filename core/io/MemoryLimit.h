#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace asperity {

/// Returns the memory that one input may use: half of the machine's [bytes]. ASPERITY_MEMORY
/// [bytes] replaces the machine's, for tests.
[[nodiscard]] std::uint64_t memoryForInput();

/// Refuses an input before it is decoded. @param needed bytes of memory that it will use
/// @param location in the file, for the message
/// @throw InputError with both numbers where that exceeds memoryForInput()
void requireMemory(std::uint64_t needed, const std::string& file, const std::string& location);

/// Refuses images before they are decoded that no scan is packed as: a file of 2 MB can hold a
/// billion equal pixels, and a hundred such images one after the other. Up to 1 GiB may be packed
/// in any way, as a scan that was stopped at once.
/// @param decoded bytes of all images of the file so far @param packed bytes of the file
/// @throw InputError with both numbers where that exceeds 64 times the file
void requireUsualPacking(std::uint64_t decoded, std::uint64_t packed, const std::string& file,
                         const std::string& location);

/// Asks for the pages of memory that is about to be filled, all at once: a fault for each costs
/// more than to fill it. Advice only; the content is not changed.
void requestPages(void* memory, std::size_t bytes) noexcept;

}  // namespace asperity
