#include "core/Units.h"
#include "tests/ui/view/ZoomViewFixture.h"
#include "vtkplugins/pictures/Palette.h"

namespace asperity::test {

namespace {

constexpr double kNear = 1.5;  ///< half the outline's width and a pixel's rounding [px]

bool isNear(const QColor& pixel, const Color& color) {
    return std::abs(pixel.red() - color.red) + std::abs(pixel.green() - color.green) +
               std::abs(pixel.blue() - color.blue) <
           30;
}

int pixelsNear(const QImage& picture, const Color& color) {
    int count = 0;
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            count += isNear(picture.pixelColor(x, y), color) ? 1 : 0;
        }
    }
    return count;
}

/// Lowest row in which two pictures differ; -1: in none. @param color that the first one must have
/// there; null: any
int lowestChange(const QImage& with, const QImage& without, const Color* color = nullptr) {
    for (int y = with.height() - 1; y >= 0; --y) {
        for (int x = 0; x < with.width(); ++x) {
            if (with.pixel(x, y) != without.pixel(x, y) &&
                (color == nullptr || isNear(with.pixelColor(x, y), *color))) {
                return y;
            }
        }
    }
    return -1;
}

}  // namespace

struct GhostTest : ZoomViewTest {
    /// Expects that the ghost ends below at a row, fill and outline alike.
    /// @param options with the ghost
    void expectLowest(const Snapshot& snapshot, const ViewOptions& options, const Color& color,
                      double row) {
        view->setOptions({.heightScale = options.heightScale});
        const QImage without = pictureOf(snapshot);
        view->setOptions(options);
        const QImage with = pictureOf(snapshot);
        EXPECT_NEAR(lowestChange(with, without), row, kNear);
        EXPECT_NEAR(lowestChange(with, without, &color), row, kNear) << "outline";
    }
    /// The row of the lowest position of a tip's ball as it is seen: obliquely, below its apex.
    [[nodiscard]] double ballRow(const Vector3& apex) const {
        const double radius = scene->belief.tipRadius();
        return view->onScreen(apex + radius * (Vector3::UnitZ() - view->camera().up())).y();
    }
    [[nodiscard]] std::vector<Snapshot> snapshots() const {
        return {moments.deep, moments.away, moments.neck};
    }
};

TEST_F(GhostTest, TheCommandedTipIsBelowTheRealOne) {
    const QImage without = pictureOf(moments.deep);
    EXPECT_EQ(pixelsNear(without, kLightPalette.commanded), 0);
    view->setOptions({.commandedTip = true});
    EXPECT_GT(pixelsNear(pictureOf(moments.deep), kLightPalette.commanded), 100);
    const Vector3& base = moments.deep.sample.output.base.position;
    EXPECT_LT(base.z(), moments.deep.sample.output.model.tip.z() - 0.5_nm);
}

TEST_F(GhostTest, SeenFromASideItEndsAtItsApexInTheSampleOrAboveIt) {
    for (const ViewDirection side :
         {ViewDirection::Front, ViewDirection::Right, ViewDirection::Back, ViewDirection::Left}) {
        view->lookFrom(side);
        settle();
        for (const Snapshot& snapshot : snapshots()) {
            const Vector3& apex = snapshot.sample.output.base.position;
            expectLowest(snapshot, {.commandedTip = true}, kLightPalette.commanded,
                         view->onScreen(apex).y());
        }
    }
}

TEST_F(GhostTest, SeenObliquelyItEndsAtItsBallsEdgeBelowTheApex) {
    for (const Snapshot& snapshot : snapshots()) {
        const Vector3& apex = snapshot.sample.output.base.position;
        expectLowest(snapshot, {.commandedTip = true}, kLightPalette.commanded, ballRow(apex));
        EXPECT_GT(ballRow(apex), view->onScreen(apex).y() + 5.0);
    }
}

TEST_F(GhostTest, SeenFromAboveAndBelowItsOutlineIsItsUpperEnd) {
    for (const ViewDirection side : {ViewDirection::Top, ViewDirection::Bottom}) {
        view->lookFrom(side);
        settle();
        view->setOptions({.commandedTip = true});
        EXPECT_GT(pixelsNear(pictureOf(moments.deep), kLightPalette.commanded), 100);
    }
}

TEST_F(GhostTest, TheTrueTipIsWhereTheInstrumentHasIt) {
    view->setOptions({.trueTip = true});
    Snapshot snapshot = moments.away;
    snapshot.trueTip.reset();
    EXPECT_EQ(pixelsNear(pictureOf(snapshot), kLightPalette.trueTip), 0) << "it knows none";
    view->lookFrom(ViewDirection::Front);
    for (const Vector3& way : {Vector3(6.0_nm, 0.0, 1.0_nm), Vector3(6.0_nm, 0.0, 5.0_nm),
                               Vector3(-8.0_nm, 4.0_nm, -3.0_nm)}) {
        snapshot.trueTip = snapshot.sample.output.tip + way;
        expectLowest(snapshot, {.trueTip = true}, kLightPalette.trueTip,
                     view->onScreen(*snapshot.trueTip).y());
    }
}

/// Ghosts and the dent lie on each other but for noise, which had them drawn before and behind each
/// other by turns.
TEST_F(GhostTest, NoiseDoesNotMakeItFlicker) {
    view->setOptions({.commandedTip = true, .trueTip = true});
    Snapshot snapshot = moments.deep;
    const Vector3 tip = snapshot.sample.output.tip;
    const auto noisy = [&](double noise) {
        snapshot.trueTip = tip + noise * Vector3::UnitZ();
        snapshot.sample.output.base.position = tip - noise * Vector3::UnitZ();
        return pictureOf(snapshot);
    };
    const QImage one = noisy(1e-13);
    const QImage other = noisy(-1e-13);
    int changed = 0;
    for (int y = 0; y < one.height(); ++y) {
        for (int x = 0; x < one.width(); ++x) {
            changed += one.pixel(x, y) != other.pixel(x, y) ? 1 : 0;
        }
    }
    EXPECT_LT(changed, 50);
}

TEST_F(GhostTest, StretchedHeightsStretchItToo) {
    view->lookFrom(ViewDirection::Front);
    view->setOptions({.heightScale = 3.0});
    pictureOf(moments.deep);
    expectLowest(moments.deep, {.heightScale = 3.0, .commandedTip = true}, kLightPalette.commanded,
                 view->onScreen(moments.deep.sample.output.base.position).y());
}

}  // namespace asperity::test
