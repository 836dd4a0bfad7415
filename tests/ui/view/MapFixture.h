#pragma once

#include "core/surface/fit/BSplineFit.h"
#include "tests/support/TestScenes.h"
#include "tests/ui/widgets/MouseEvents.h"
#include "tests/ui/widgets/PanelSamples.h"
#include "ui/view/MapTool.h"
#include "ui/view/OverviewMap.h"

#include <QSignalSpy>
#include <QTest>

#include <gtest/gtest.h>

namespace asperity::test {

/// A whole scan of 128 nm x 128 nm, shown in 320 x 320 pixels.
struct MapFixture : ::testing::Test {
    MapFixture() {
        map.resize(320, 320);
        map.setSurface(fitSurface(flatMap()));
    }
    void use(MapTool& tool) {
        map.addTool(tool);
        map.activate(&tool);
    }
    /// Of a position [nm].
    [[nodiscard]] QPointF pixel(double x, double y) const {
        return map.toPixel({1e-9 * x, 1e-9 * y});
    }
    /// Between two positions [nm].
    void drag(double fromX, double fromY, double toX, double toY,
              Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        dragMouse(map, pixel(fromX, fromY), pixel(toX, toY), modifiers);
    }
    [[nodiscard]] Qt::CursorShape cursorAt(double x, double y) {
        sendMouse(map, QEvent::MouseMove, pixel(x, y), Qt::NoButton);
        return map.cursor().shape();
    }

    static constexpr double kNear = 0.3e-9;  ///< less than a pixel [m]
    OverviewMap map;
};

/// With a shape that is drawn there.
template <class Tool>
struct ShapeFixture : MapFixture {
    ShapeFixture() { use(tool); }

    /// @param from,to of the shape [m]; the rest in nm
    static void expectPoints(const QPointF& from, const QPointF& to, double x1, double y1,
                             double x2, double y2) {
        EXPECT_NEAR(from.x(), 1e-9 * x1, kNear);
        EXPECT_NEAR(from.y(), 1e-9 * y1, kNear);
        EXPECT_NEAR(to.x(), 1e-9 * x2, kNear);
        EXPECT_NEAR(to.y(), 1e-9 * y2, kNear);
    }
    void expectAClickKeepsIt() {
        QSignalSpy drawn(&tool, &Tool::drawn);
        drag(50, 50, 50, 50);
        EXPECT_TRUE(tool.isEmpty());
        drag(20, 30, 100, 90);
        EXPECT_FALSE(tool.isEmpty());
        const auto before = drawn.count();
        EXPECT_GE(before, 1);
        drag(110, 20, 110, 20);
        EXPECT_EQ(drawn.count(), before);
    }

    Tool tool;
};

}  // namespace asperity::test
