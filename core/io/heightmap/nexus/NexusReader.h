#pragma once

#include "core/io/hdf5/Hdf5Content.h"
#include "core/io/heightmap/HeightMapFormat.h"

#include <functional>
#include <string>
#include <vector>

namespace asperity {

/// Returns what an HDF5 file holds, with the values at these paths; as readHdf5().
using ReadHdf5Content = std::function<Hdf5Content(const std::vector<std::string>& paths)>;

/// Reads the images of a NeXus file. Their values are read when they are asked for.
/// @param file for messages
/// @throw InputError when it holds none, or none that can be read
[[nodiscard]] StoredScan readNexus(const std::string& file, const ReadHdf5Content& readContent);

}  // namespace asperity
