#pragma once

#include "core/io/hdf5/Hdf5Object.h"
#include "core/io/hdf5/reader/ContentWriter.h"

#include <cstdint>
#include <string>

namespace asperity {

/// What the values of a dataset or an attribute are, and how they are read.
struct Hdf5Values {
    ValueShape shape;
    Hdf5Object memory{-1, H5Tclose};  ///< type that they are read as
    bool hasPointers = false;         ///< texts of any length, which the library makes room for
};

/// Hands over a dataset. Values in other files, of compound types and the like stay away.
/// @param most     bytes of values that the file can hold
/// @param isWanted false: values only where they are few
/// @throw std::runtime_error with the path
void addDataset(ContentWriter& writer, const std::string& path, hid_t dataset, std::uint64_t most,
                bool isWanted);
/// Hands over an attribute. @throw as addDataset()
void addAttribute(ContentWriter& writer, const std::string& path, hid_t attribute);

}  // namespace asperity
