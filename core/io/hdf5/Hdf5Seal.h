#pragma once

#include "core/io/ByteSource.h"

#include <cstdint>
#include <filesystem>

namespace asperity {

// The HDF5 library frees and follows what a damaged file tells it to, and crashes. So each file of
// ours has a seal before the library's own bytes, in the block that HDF5 leaves to programs: size
// and CRC-32 of all that follows. Other programs skip it.

/// Bytes of the block: the least that HDF5 has.
inline constexpr std::uint64_t kSealBytes = 512;

/// Writes the seal of a file whose first kSealBytes are free for it. @throw Error
void sealHdf5(const std::filesystem::path& path);

/// @throw InputError where the file has no seal, or does not hold what it was sealed with
void requireSeal(const ByteSource& file);

}  // namespace asperity
