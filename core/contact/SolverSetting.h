#pragma once

#include "core/EnumTable.h"

#include <cstdint>

namespace asperity {

/// How a Maugis-Dugdale state is found: a choice of speed only, within the bound that the table
/// states of itself. Folds are exact in every setting.
enum class SolverSetting : std::uint8_t {
    Exact,   ///< afresh each time
    Newton,  ///< by Newton's method from the previous state
    Table,   ///< from a table over transition parameter and indentation
};

template <>
inline constexpr auto kEnumTable<SolverSetting> =
    std::to_array<EnumRow<SolverSetting>>({{SolverSetting::Exact, "exact"},
                                           {SolverSetting::Newton, "newton"},
                                           {SolverSetting::Table, "table"}});

}  // namespace asperity
