#pragma once

#include "core/io/ByteReader.h"
#include "core/io/hdf5/Hdf5Content.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace asperity {

/// Libraries that read HDF5 free and follow what a damaged file says. So a program of its
/// own does: where it crashes, hangs or uses too much memory, this one reports it and continues.

/// The program: beside this one or in ../libexec/asperity, or the same for a folder of the list,
/// folders between colons; one that ASPERITY_HDF5_READER names is first. Empty: there is none.
[[nodiscard]] std::filesystem::path hdf5Reader(std::string_view folders);

/// Reads an HDF5 file.
/// @param paths of groups and datasets that are wanted, with all that is below, and all values: of
///        no other one there is anything. None: of all there are shapes, and values up to 1 KiB
/// @throw InputError where it is no such file or cannot be read; Error without the program
[[nodiscard]] Hdf5Content readHdf5(const ByteSource& file, const std::vector<std::string>& paths);

// The HDF5 library frees and follows what a damaged file says, and crashes. So each file of
// ours has a seal before the library's own bytes, in the block that HDF5 leaves to programs: size
// and CRC-32 of all that follows. Other programs skip it.

/// Bytes of the block: the least that HDF5 has.
inline constexpr std::uint64_t kSealBytes = 512;

/// Writes the seal of a file whose first kSealBytes are free for it. @throw Error
void sealHdf5(const std::filesystem::path& path);

/// @throw InputError where the file has no seal, or does not hold what it was sealed with
void requireSeal(const ByteSource& file);

}  // namespace asperity
