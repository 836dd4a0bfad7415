#include "vtkplugins/pictures/Palette.h"

#include <vtkLookupTable.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace asperity {

namespace {

constexpr int kTableSize = 511;  // odd: one entry is exactly the middle

/// A table that runs evenly through the anchor colors.
vtkSmartPointer<vtkLookupTable> tableThrough(std::span<const Color> anchors, double low,
                                             double high) {
    auto table = vtkSmartPointer<vtkLookupTable>::New();
    table->SetNumberOfTableValues(kTableSize);
    table->SetTableRange(low, high);
    for (int entry = 0; entry < kTableSize; ++entry) {
        const double place =
            static_cast<double>(entry) / (kTableSize - 1) * static_cast<double>(anchors.size() - 1);
        const std::size_t left = std::min(static_cast<std::size_t>(place), anchors.size() - 2);
        const double part = place - static_cast<double>(left);
        const auto from = anchors[left].fractions();
        const auto to = anchors[left + 1].fractions();
        table->SetTableValue(entry, std::lerp(from[0], to[0], part),
                             std::lerp(from[1], to[1], part), std::lerp(from[2], to[2], part));
    }
    return table;
}

}  // namespace

Color seriesColor(std::size_t index) {
    static constexpr std::array<Color, 7> kColors = {{{0, 114, 178},
                                                      {213, 94, 0},
                                                      {0, 158, 115},
                                                      {204, 121, 167},
                                                      {86, 180, 233},
                                                      {230, 159, 0},
                                                      {70, 70, 70}}};
    return kColors.at(index % kColors.size());
}

vtkSmartPointer<vtkLookupTable> divergingTable(double limit) {
    return tableThrough(palette::kDiverging, -limit, limit);
}

vtkSmartPointer<vtkLookupTable> heightTable(double low, double high) {
    return tableThrough(palette::kHeights, low, high);
}

}  // namespace asperity
