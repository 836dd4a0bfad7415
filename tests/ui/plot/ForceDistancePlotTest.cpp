#include "ui/plot/ForceDistancePlot.h"

#include <QCoreApplication>

#include <gtest/gtest.h>

namespace asperity {
namespace {

/// Its labels at the ends of the distance axis, and its forces, have more or fewer digits.
TEST(ForceDistancePlot, ItsCanvasDoesNotJumpWithItsNumbers) {
    ForceDistancePlot plot;
    plot.resize(400, 200);
    const auto canvasAt = [&plot](double force, double from, double to) {
        plot.forgetRange();
        plot.setCycles({{.approach = {{from, 0.0}, {to, force}}}}, {from, to});
        plot.grab();
        QCoreApplication::sendPostedEvents();
        return plot.canvas().geometry();
    };
    const QRect first = canvasAt(100e-12, 9.6e-9, 10.2e-9);
    EXPECT_EQ(canvasAt(5e-9, -1.0e-9, 60e-9), first);
    EXPECT_EQ(canvasAt(-888e-9, -20.0e-9, 900e-9), first);
}

}  // namespace
}  // namespace asperity
