#include "tests/ui/view/ZoomViewFixture.h"
#include "vtkplugins/pictures/Palette.h"

#include <algorithm>
#include <cmath>

namespace asperity::test {

namespace {

/// 0: gray.
int chroma(const QColor& color) {
    return std::max({color.red(), color.green(), color.blue()}) -
           std::min({color.red(), color.green(), color.blue()});
}

}  // namespace

struct UndersideTest : ZoomViewTest {
    void SetUp() override {
        ZoomViewTest::SetUp();
        hills = std::make_unique<Scene>(hillyScene());
        view->setScene(hills.get());
        view->setOptions({.axes = false, .scaleBars = false, .grid = false});
    }
    void TearDown() override { view->setScene(nullptr); }

    /// What is seen at positions of the scan beside the tip.
    std::vector<QColor> seenFrom(ViewDirection side) {
        view->lookFrom(side);
        const QImage picture = pictureOf(momentsOf(*hills).away);
        const ScanWindow window = view->window().value();
        std::vector<QColor> colors;
        for (const double across : {0.05, 0.2, 0.35, 0.65, 0.8, 0.95}) {
            for (const double along : {0.05, 0.2, 0.8, 0.95}) {
                const double x = std::lerp(window.left, window.right, across);
                const double y = std::lerp(window.bottom, window.top, along);
                colors.push_back(colorAt(picture, {x, y, hills->surface.at(x, y).height}));
            }
        }
        return colors;
    }

    std::unique_ptr<Scene> hills;
};

TEST_F(UndersideTest, HasTheColorOfTheWallsAndNotThatOfHeights) {
    const int walls =
        chroma({kLightPalette.side.red, kLightPalette.side.green, kLightPalette.side.blue});
    for (const QColor& color : seenFrom(ViewDirection::Bottom)) {
        EXPECT_LE(chroma(color), walls + 3) << color.name().toStdString();
    }
    const std::vector<QColor> above = seenFrom(ViewDirection::Top);
    const auto colored = std::ranges::count_if(
        above, [&](const QColor& color) { return chroma(color) > walls + 20; });
    EXPECT_GT(2 * colored, static_cast<std::ptrdiff_t>(above.size()));
}

TEST_F(UndersideTest, IsLitSoThatItsShapeIsSeen) {
    int darkest = 255;
    int brightest = 0;
    for (const QColor& color : seenFrom(ViewDirection::Bottom)) {
        darkest = std::min(darkest, color.lightness());
        brightest = std::max(brightest, color.lightness());
    }
    EXPECT_GT(darkest, 60);
    EXPECT_GT(brightest, darkest + 15);
}

}  // namespace asperity::test
