#include "ui/panels/HeightColours.h"

#include "vtkplugins/pictures/Palette.h"

#include <vtkLookupTable.h>

#include <gtest/gtest.h>

#include <array>

namespace asperity {
namespace {

TEST(HeightColours, AreThoseOfThe3DViews) {
    const auto table = heightTable(-1e-9, 3e-9);
    const ColourScale scale = heightColours(-1e-9, 3e-9);
    for (int i = 0; i <= 40; ++i) {
        const double height = -1e-9 + 4e-9 * i / 40.0;
        std::array<double, 3> expected{};
        table->GetColor(height, expected.data());
        const QColor colour = colourAt(scale, height);
        EXPECT_NEAR(colour.redF(), expected[0], 0.006) << height;
        EXPECT_NEAR(colour.greenF(), expected[1], 0.006) << height;
        EXPECT_NEAR(colour.blueF(), expected[2], 0.006) << height;
    }
    EXPECT_EQ(colourAt(scale, -5.0), colourAt(scale, -1e-9));
    EXPECT_EQ(colourAt(scale, 5.0), colourAt(scale, 3e-9));
}

}  // namespace
}  // namespace asperity
