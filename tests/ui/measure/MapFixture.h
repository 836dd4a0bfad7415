#pragma once

#include "core/surface/fit/BSplineFit.h"
#include "tests/support/TestScenes.h"
#include "tests/ui/MouseEvents.h"
#include "tests/ui/panels/PanelSamples.h"
#include "ui/panels/MapTool.h"
#include "ui/panels/OverviewMap.h"

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
    /// Of a place [nm].
    [[nodiscard]] QPointF pixel(double x, double y) const {
        return map.toPixel({1e-9 * x, 1e-9 * y});
    }
    /// Between two places [nm].
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

}  // namespace asperity::test
