#include "vtkplugins/pictures/Palette.h"

#include "vtkplugins/pictures/ColorMaps.h"

#include <vtkLookupTable.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace asperity {

namespace {

/// A table that runs evenly through the anchor colors.
vtkSmartPointer<vtkLookupTable> tableThrough(std::span<const Color> anchors, double low,
                                             double high) {
    auto table = vtkSmartPointer<vtkLookupTable>::New();
    table->SetNumberOfTableValues(kColorTableSize);
    table->SetTableRange(low, high);
    for (int entry = 0; entry < kColorTableSize; ++entry) {
        const double position = static_cast<double>(entry) / (kColorTableSize - 1) *
                                static_cast<double>(anchors.size() - 1);
        const std::size_t left = std::min(static_cast<std::size_t>(position), anchors.size() - 2);
        const double part = position - static_cast<double>(left);
        const auto from = anchors[left].fractions();
        const auto to = anchors[left + 1].fractions();
        table->SetTableValue(entry, std::lerp(from[0], to[0], part),
                             std::lerp(from[1], to[1], part), std::lerp(from[2], to[2], part));
    }
    return table;
}

}  // namespace

// The curves have the colors of Okabe and Ito (2008).
constexpr Palette kLightPalette{.paper = {255, 255, 255},
                                .window = {243, 245, 247},
                                .backdrop = {234, 237, 240},
                                .ink = {31, 41, 51},
                                .muted = {95, 107, 118},
                                .faint = {216, 222, 228},
                                .accent = {0, 108, 170},
                                .wash = {232, 243, 250},
                                .onAccent = {255, 255, 255},
                                .fault = {186, 26, 46},
                                .caution = {138, 80, 0},
                                .refused = {251, 221, 221},
                                .side = {178, 184, 191},
                                .tip = {96, 112, 128},
                                .tipBody = {186, 194, 203},
                                .lever = {196, 202, 208},
                                .force = {200, 40, 60},
                                .marker = {222, 30, 90},
                                .path = {31, 41, 51},
                                .zoom = {213, 94, 0},
                                .guide = {213, 94, 0},
                                .target = {0, 180, 60},
                                .commanded = {0, 114, 178},
                                .trueTip = {0, 128, 92},
                                .blue = {0, 114, 178},
                                .orange = {213, 94, 0},
                                .green = {0, 158, 115},
                                .purple = {204, 121, 167},
                                .sky = {86, 180, 233},
                                .yellow = {230, 159, 0},
                                .gray = {70, 70, 70}};

constexpr Palette kDarkPalette{.paper = {30, 35, 41},
                               .window = {20, 24, 29},
                               .backdrop = {24, 28, 34},
                               .ink = {226, 232, 238},
                               .muted = {158, 170, 182},
                               .faint = {62, 71, 81},
                               .accent = {94, 180, 242},
                               .wash = {32, 54, 73},
                               .onAccent = {13, 22, 31},
                               .fault = {255, 128, 128},
                               .caution = {240, 182, 84},
                               .refused = {84, 34, 40},
                               .side = {88, 96, 106},
                               .tip = {150, 166, 182},
                               .tipBody = {186, 194, 203},
                               .lever = {160, 168, 177},
                               .force = {255, 112, 124},
                               .marker = {255, 82, 140},
                               .path = {226, 232, 238},
                               .zoom = {255, 146, 64},
                               .guide = {255, 146, 64},
                               .target = {70, 236, 110},
                               .commanded = {82, 168, 240},
                               .trueTip = {70, 214, 160},
                               .blue = {82, 168, 240},
                               .orange = {255, 146, 64},
                               .green = {52, 206, 150},
                               .purple = {226, 150, 196},
                               .sky = {150, 214, 255},
                               .yellow = {246, 208, 92},
                               .gray = {176, 182, 188}};

vtkSmartPointer<vtkLookupTable> divergingTable(double limit) {
    return tableThrough(palette::kDiverging, -limit, limit);
}

vtkSmartPointer<vtkLookupTable> heightTable(double low, double high) {
    return tableThrough(palette::kHeights, low, high);
}

}  // namespace asperity
