#include "core/io/recording/ColumnList.h"

#include <algorithm>
#include <array>

namespace asperity {

namespace {

struct NamedUnit {
    std::string_view end;  ///< of a column's name
    std::string_view unit;
};

/// Units of several parts first: they end in others.
constexpr auto kUnits = std::to_array<NamedUnit>({{"_n_s_m", "N s/m"},
                                                  {"_n_m", "N/m"},
                                                  {"_m_s", "m/s"},
                                                  {"_hz", "Hz"},
                                                  {"_rad", "rad"},
                                                  {"_j", "J"},
                                                  {"_m", "m"},
                                                  {"_n", "N"},
                                                  {"_s", "s"}});

}  // namespace

std::string unitOfColumn(std::string_view name) {
    const auto* const found = std::ranges::find_if(
        kUnits, [name](const NamedUnit& unit) { return name.ends_with(unit.end); });
    return found == kUnits.end() ? std::string() : std::string(found->unit);
}

}  // namespace asperity
