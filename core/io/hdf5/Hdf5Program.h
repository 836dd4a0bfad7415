#pragma once

#include "core/io/hdf5/Hdf5Content.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace asperity {

/// Libraries that read HDF5 free and follow what a damaged file tells them to. So a program of its
/// own does: where it crashes, hangs or takes too much memory, this one says so and goes on.

/// The program: beside this one or in ../libexec/asperity, or likewise for a folder of the list,
/// folders between colons; what ASPERITY_HDF5_READER names goes before. Empty: there is none.
[[nodiscard]] std::filesystem::path hdf5Reader(std::string_view folders);

/// Reads an HDF5 file.
/// @param paths of groups and datasets that are wanted, with all that is below, and all values: of
///        no other one there is anything. None: of all there are shapes, and values up to 1 KiB
/// @throw InputError where it is no such file or cannot be read; Error without the program
[[nodiscard]] Hdf5Content readHdf5(const ByteSource& file, const std::vector<std::string>& paths);

}  // namespace asperity
