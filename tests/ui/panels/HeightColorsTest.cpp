#include "ui/panels/HeightColors.h"

#include "vtkplugins/pictures/Palette.h"

#include <vtkLookupTable.h>

#include <gtest/gtest.h>

#include <array>

namespace asperity {
namespace {

TEST(HeightColors, AreThoseOfThe3DViews) {
    const auto table = heightTable(-1e-9, 3e-9);
    const ColorScale scale = heightColors(-1e-9, 3e-9);
    for (int i = 0; i <= 40; ++i) {
        const double height = -1e-9 + 4e-9 * i / 40.0;
        std::array<double, 3> expected{};
        table->GetColor(height, expected.data());
        const QColor color = colorAt(scale, height);
        EXPECT_NEAR(color.redF(), expected[0], 0.006) << height;
        EXPECT_NEAR(color.greenF(), expected[1], 0.006) << height;
        EXPECT_NEAR(color.blueF(), expected[2], 0.006) << height;
    }
    EXPECT_EQ(colorAt(scale, -5.0), colorAt(scale, -1e-9));
    EXPECT_EQ(colorAt(scale, 5.0), colorAt(scale, 3e-9));
}

}  // namespace
}  // namespace asperity
