#pragma once

#include "core/EnumTable.h"
#include "core/deformation/SurfaceQuantity.h"
#include "vtkplugins/pictures/ColorMaps.h"

#include <QString>

#include <array>

namespace asperity {

/// Which values the colors range over.
enum class RangeRule : std::uint8_t {
    Full,      ///< from the lowest to the highest
    Percent,   ///< without one percent at each end
    Permille,  ///< without one per mille at each end
    Own,       ///< typed numbers
};

template <>
inline constexpr auto kEnumTable<RangeRule> =
    std::to_array<EnumRow<RangeRule>>({{RangeRule::Full, "full", "Full range"},
                                       {RangeRule::Percent, "percent", "1–99 %"},
                                       {RangeRule::Permille, "permille", "0.1–99.9 %"},
                                       {RangeRule::Own, "own", "Own range"}});

/// How the values of one quantity are colored.
struct QuantityColors {
    ColorMap map = ColorMap::Standard;
    RangeRule rule = RangeRule::Full;
    double low = 0.0;     ///< of the own range [unit of the quantity]
    double high = 1.0;    ///< likewise
    bool pinned = false;  ///< the range stays as it is, whatever is shown

    bool operator==(const QuantityColors&) const = default;
};

/// How a surface is colored, in all views alike; each quantity keeps its own colors.
struct SurfaceLook {
    static constexpr std::size_t kQuantities = kEnumTable<SurfaceQuantity>.size();

    SurfaceQuantity quantity = SurfaceQuantity::Height;
    QString channel;  ///< of the file, for SurfaceQuantity::Channel
    std::array<QuantityColors, kQuantities> colors{};

    /// Values of either sign begin with the diverging map, those of a force map without the few
    /// that stick out.
    SurfaceLook() {
        for (const SurfaceQuantityRow& row : kEnumTable<SurfaceQuantity>) {
            of(row.value).map = row.isSigned ? ColorMap::Diverging : ColorMap::Standard;
        }
        of(SurfaceQuantity::ForceMap).rule = RangeRule::Percent;  // as the sheets of a map have it
    }
    [[nodiscard]] QuantityColors& of(SurfaceQuantity which) {
        return colors.at(static_cast<std::size_t>(which));
    }
    [[nodiscard]] const QuantityColors& of(SurfaceQuantity which) const {
        return colors.at(static_cast<std::size_t>(which));
    }
    /// The range of a quantity is no more pinned or typed.
    void freeRange(SurfaceQuantity which) {
        of(which).pinned = false;
        if (of(which).rule == RangeRule::Own) {
            of(which).rule = RangeRule::Full;
        }
    }
    bool operator==(const SurfaceLook&) const = default;
};

}  // namespace asperity
