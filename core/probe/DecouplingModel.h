#pragma once

#include "core/EnumTable.h"

#include <cstdint>

namespace asperity {

/// How the signals become a force.
enum class DecouplingModel : std::uint8_t {
    Planar,    ///< nothing assumed but that the force lies in the plane of normal and motion
    Estimator  ///< weighted least squares of all that is known
};

template <>
inline constexpr auto kEnumTable<DecouplingModel> = std::to_array<EnumRow<DecouplingModel>>(
    {{DecouplingModel::Planar, "planar"}, {DecouplingModel::Estimator, "estimator"}});

}  // namespace asperity
