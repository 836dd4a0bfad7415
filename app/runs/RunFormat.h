#pragma once

#include "core/EnumTable.h"

#include <cstdint>

namespace asperity {

/// How the tables of a run are kept.
enum class RunFormat : std::uint8_t {
    Csv,   ///< as text, a file each
    Hdf5,  ///< in one HDF5 file of about a tenth of the size
};

template <>
inline constexpr auto kEnumTable<RunFormat> = std::to_array<EnumRow<RunFormat>>(
    {{RunFormat::Csv, "csv", "Text (CSV)"}, {RunFormat::Hdf5, "h5", "Compact (HDF5)"}});

}  // namespace asperity
