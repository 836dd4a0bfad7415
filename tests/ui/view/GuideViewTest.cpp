#include "tests/ui/view/ZoomViewFixture.h"

namespace asperity::test {
namespace {

using GuideView = ZoomViewTest;

/// Pixels of one picture that differ from another's.
int difference(const QImage& one, const QImage& other) {
    int count = 0;
    for (int y = 0; y < one.height(); ++y) {
        for (int x = 0; x < one.width(); ++x) {
            count += one.pixel(x, y) != other.pixel(x, y) ? 1 : 0;
        }
    }
    return count;
}

TEST_F(GuideView, EachGuideIsDrawnAndGoesWithIt) {
    Snapshot snapshot = moments.away;
    const QImage without = pictureOf(snapshot);
    VirtualFixture& guide = snapshot.sample.input.settings.guide;
    guide.point = snapshot.sample.output.model.tip;
    int last = 0;
    for (const FixtureKind kind : {FixtureKind::Point, FixtureKind::Line, FixtureKind::Plane}) {
        guide.kind = kind;
        const int drawn = difference(pictureOf(snapshot), without);
        EXPECT_GT(drawn, last + 20) << static_cast<int>(kind);
        last = drawn;
    }
    guide.kind = FixtureKind::None;
    EXPECT_EQ(difference(pictureOf(snapshot), without), 0);
}

}  // namespace
}  // namespace asperity::test
