#pragma once

#include <string>
#include <string_view>

namespace asperity {

/// The SI unit that a column's name ends in: "N/m" of "guide_stiffness_n_m"; empty: it has none.
[[nodiscard]] std::string unitOfColumn(std::string_view name);

}  // namespace asperity
