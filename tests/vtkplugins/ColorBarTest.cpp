#include "tests/vtkplugins/NeedsDisplay.h"
#include "vtkplugins/pictures/OffscreenPicture.h"
#include "vtkplugins/pictures/Panel.h"

#include <vtkLookupTable.h>
#include <vtkNew.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace asperity {
namespace {

constexpr int kHeight = 80;
constexpr int kLabels = 26;  // rows below the colors, from the bottom of the picture
constexpr int kBetween = 5;  // columns without ink between two labels, more than within one
constexpr int kWidest = 36;  // of a label of four characters, well below two

/// Columns of the picture in which a label has ink.
std::vector<bool> inkOfLabels(int width, double low, double high) {
    vtkNew<vtkLookupTable> table;
    table->SetRange(low, high);
    table->Build();
    OffscreenPicture picture({.width = width, .height = kHeight});
    picture.paint([&](Painter& painter) {
        drawColorBar(painter, {"displacement", "m", low, high, table},
                     {0.0, 0.0, static_cast<double>(width), kHeight - 30.0});
    });
    const RasterImage image = picture.image();
    std::vector<bool> ink(static_cast<std::size_t>(width), false);
    for (int row = kHeight - kLabels; row < kHeight; ++row) {
        for (int column = 0; column < width; ++column) {
            const std::uint8_t* at = image.row(row) + static_cast<std::ptrdiff_t>(4) * column;
            ink[static_cast<std::size_t>(column)] =
                ink[static_cast<std::size_t>(column)] || at[0] < 160;
        }
    }
    return ink;
}

/// The widest stretch of ink without a gap between labels.
int widestOf(const std::vector<bool>& ink) {
    int widest = 0;
    int begin = -1;
    int last = -1;
    for (int column = 0; column < static_cast<int>(ink.size()); ++column) {
        if (!ink[static_cast<std::size_t>(column)]) {
            continue;
        }
        begin = begin < 0 || column - last > kBetween ? column : begin;
        last = column;
        widest = std::max(widest, last - begin + 1);
    }
    return widest;
}

TEST(ColorBar, LabelsDoNotRunIntoEachOther) {
    ASPERITY_NEEDS_DISPLAY();
    for (const int width : {260, 280, 300, 320, 400, 640, 1000}) {
        for (const double high : {1e-9, 0.4e-9, 50e-12}) {
            const int widest = widestOf(inkOfLabels(width, -high, high));
            EXPECT_GT(widest, 5) << width << " has no label";
            EXPECT_LT(widest, kWidest) << width << " pixels, to " << high << " m";
        }
    }
}

/// The window's letters: VTK's own are narrower. Advance of W in DejaVu Sans and its bold face.
TEST(Painter, WritesInTheTypefaceOfTheWindow) {
    ASPERITY_NEEDS_DISPLAY();
    OffscreenPicture picture({.width = 400, .height = kHeight});
    std::vector<double> widths;
    picture.paint([&](Painter& painter) {
        const std::string text(20, 'W');
        widths = {painter.textWidth(text, {.size = 15.0}),
                  painter.textWidth(text, {.size = 15.0, .bold = true})};
        painter.text({0.0, 0.5 * kHeight}, text, {.size = 15.0});
    });
    (void)picture.image();
    ASSERT_EQ(widths.size(), 2U);
    EXPECT_NEAR(widths[0], 20 * 0.989 * 15.0, 5.0);
    EXPECT_NEAR(widths[1], 20 * 1.103 * 15.0, 5.0);
}

}  // namespace
}  // namespace asperity
