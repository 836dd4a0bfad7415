#include "ui/view/ZoomView.h"

#include "core/Units.h"
#include "tests/support/TestScenes.h"
#include "tests/ui/view/ZoomViewFixture.h"
#include "vtkplugins/pictures/Palette.h"

#include <vtkOpenGLRenderWindow.h>

#include <QApplication>
#include <QMouseEvent>
#include <QSignalSpy>

#include <GL/gl.h>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <string>

namespace asperity::test {

namespace {

int difference(const QColor& one, const QColor& other) {
    return std::abs(one.red() - other.red()) + std::abs(one.green() - other.green()) +
           std::abs(one.blue() - other.blue());
}

/// Pixels that differ plainly, of a thousand.
double perMilleDifferent(const QImage& one, const QImage& other) {
    int different = 0;
    for (int y = 0; y < one.height(); ++y) {
        for (int x = 0; x < one.width(); ++x) {
            different += difference(one.pixelColor(x, y), other.pixelColor(x, y)) > 24 ? 1 : 0;
        }
    }
    return 1000.0 * different / (one.width() * one.height());
}

double residentMegabytes() {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);) {
        if (line.rfind("VmRSS:", 0) == 0) {
            return std::stod(line.substr(6)) / 1024.0;
        }
    }
    return 0.0;
}

}  // namespace

TEST_F(ZoomViewTest, DrawsWithoutErrorsOfOpenGl) {
    pictureOf(moments.away);
    pictureOf(moments.deep);
    view->renderWindow().MakeCurrent();
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

/// As the scale of displacements has it; heights and the tip are never so blue.
bool isDentBlue(const QColor& color) {
    return color.blue() > color.green() + 10 && color.blue() > color.red() + 30;
}

TEST_F(ZoomViewTest, ShowsTheDentInBlueAndTheNeckInOrange) {
    const TipState& state = moments.deep.sample.output.model;
    // Beside the arrow, inside of the rim: it shows through the tip.
    const Vector3 inDent =
        state.closest.point - 0.6 * state.contact.contactRadius * view->camera().right();
    const QColor rest = colorAt(pictureOf(moments.away), inDent);
    const QColor dent = colorAt(pictureOf(moments.deep), inDent);
    EXPECT_GT(difference(rest, dent), 60);
    EXPECT_TRUE(isDentBlue(dent));

    const TipState& pulled = moments.neck.sample.output.model;
    // Beside the arrow, in front of the tip and its edge.
    const Vector3 onNeck =
        pulled.closest.point + 4.2_nm * towardsEye() + 2.0_nm * view->camera().right();
    const QColor neck = colorAt(pictureOf(moments.neck), onNeck);
    EXPECT_GT(neck.red(), neck.blue() + 30);
}

TEST_F(ZoomViewTest, ShowsTheDentAtTheScansEdge) {
    const Vector3 way(0.0, -64.0_nm, 0.0);  // to the edge that faces the eye
    const auto bluePixels = [](const QImage& picture) {
        int count = 0;
        for (int y = 0; y < picture.height(); ++y) {
            for (int x = 0; x < picture.width(); ++x) {
                count += isDentBlue(picture.pixelColor(x, y)) ? 1 : 0;
            }
        }
        return count;
    };
    EXPECT_EQ(bluePixels(pictureOf(movedBy(moments.away, way))), 0);
    EXPECT_GT(bluePixels(pictureOf(movedBy(moments.deep, way))), 100);
}

TEST_F(ZoomViewTest, ShowsWhatTheScanHoldsNoDataOfInGray) {
    HeightMap map = flatMap();
    for (int row = 0; row < map.rows; ++row) {
        for (int column = 36; column < 44; ++column) {
            map.heights[map.index(row, column)] = std::numeric_limits<double>::quiet_NaN();
        }
    }
    Scene holed = buildScene(plainScene(), map);
    view->setScene(&holed);
    const QImage picture = pictureOf(moments.away);
    const auto colorfulness = [&](double x, double y) {
        const QColor color = colorAt(picture, {x, y, 0.0});
        return std::max({color.red(), color.green(), color.blue()}) -
               std::min({color.red(), color.green(), color.blue()});
    };
    EXPECT_LE(colorfulness(80.5_nm, 63.0_nm), 8);
    EXPECT_LE(colorfulness(76.3_nm, 50.0_nm), 8) << "around the contact";
    EXPECT_GT(colorfulness(93.0_nm, 63.0_nm), 40);
    view->setScene(nullptr);  // which goes before the view
}

TEST_F(ZoomViewTest, ShowsTheForceInRed) {
    const auto redPixels = [](const QImage& picture) {
        int count = 0;
        for (int y = 0; y < picture.height(); ++y) {
            for (int x = 0; x < picture.width(); ++x) {
                const QColor color = picture.pixelColor(x, y);
                count += color.red() > 110 && color.red() > 2.5 * color.green() ? 1 : 0;
            }
        }
        return count;
    };
    EXPECT_GT(redPixels(pictureOf(moments.deep)), 300);
    EXPECT_GT(redPixels(pictureOf(moments.neck)), 100);
}

TEST_F(ZoomViewTest, ShowsTheSameWithTheCacheAsWithoutIt) {
    view->setCacheEnabled(false);
    const QImage plain = pictureOf(moments.deep);
    view->setCacheEnabled(true);
    pictureOf(moments.away);
    const QImage cached = pictureOf(moments.deep);
    EXPECT_LT(perMilleDifferent(plain, cached), 0.5);
    EXPECT_GT(perMilleDifferent(plain, pictureOf(moments.away)), 5.0) << "the eye of this test";
}

TEST_F(ZoomViewTest, HidesWhatIsBehindAHillWithTheCacheToo) {
    const Scene hilly = hillyScene();
    const ViewMoments onHills = momentsOf(hilly);
    view->setScene(&hilly);
    view->setHalfWidth(60.0_nm);
    view->showSnapshot(onHills.deep);
    const QPointF low(300.0, -400.0);  // the eye goes down as far as it may
    QMouseEvent press(QEvent::MouseButtonPress, {300.0, 300.0}, Qt::RightButton, Qt::RightButton,
                      Qt::NoModifier);
    QMouseEvent move(QEvent::MouseMove, low, Qt::NoButton, Qt::RightButton, Qt::NoModifier);
    QApplication::sendEvent(view.get(), &press);
    QApplication::sendEvent(view.get(), &move);
    view->setCacheEnabled(false);
    const QImage plain = pictureOf(onHills.deep);
    view->setCacheEnabled(true);
    pictureOf(onHills.deep);
    EXPECT_LT(perMilleDifferent(plain, pictureOf(onHills.deep)), 0.5);
}

TEST_F(ZoomViewTest, ShowsTheSameHoweverOftenItIsShown) {
    SceneDescription description = plainScene();
    description.sample.material.elastic = description.tip.elastic;  // the tip gives way, too
    const Scene stiff = buildScene(description, flatMap());
    const ViewMoments onStiff = momentsOf(stiff);
    view->setScene(&stiff);
    const QImage once = pictureOf(onStiff.deep);
    for (int i = 0; i < 20; ++i) {
        view->showSnapshot(onStiff.deep);
    }
    EXPECT_EQ(perMilleDifferent(once, pictureOf(onStiff.deep)), 0.0);
}

TEST_F(ZoomViewTest, LeavesNoCrackInTheSurface) {
    // No background shines through where patch and terrain join.
    const QImage picture = pictureOf(moments.deep);
    const QColor background = picture.pixelColor(2, 200);
    const ScanWindow window = view->window().value();
    const Vector3 closest = moments.deep.sample.output.model.closest.point;
    for (int step = 10; step < 490; ++step) {
        const double part = step / 500.0;
        const Vector3 position(std::lerp(window.left, window.right, part),
                               std::lerp(window.bottom, window.top, 0.3), closest.z());
        EXPECT_GT(difference(colorAt(picture, position), background), 20) << part;
    }
}

TEST_F(ZoomViewTest, FollowsTheTip) {
    view->showSnapshot(moments.away);
    const ScanWindow before = view->window().value();
    QSignalSpy moved(view.get(), &ZoomView::frameChanged);
    view->showSnapshot(movedBy(moments.away, {3.0_nm, 0.0, 0.0}));
    EXPECT_TRUE(sameWindow(view->window().value(), before));
    EXPECT_EQ(moved.count(), 0);
    view->showSnapshot(movedBy(moments.away, {20.0_nm, 0.0, 0.0}));
    const ScanWindow after = view->window().value();
    EXPECT_EQ(moved.count(), 1);
    EXPECT_GT(after.left, before.left);
    EXPECT_NEAR(after.right - after.left, before.right - before.left, 1e-15);
}

TEST_F(ZoomViewTest, SaysWhatItsColorsMean) {
    QSignalSpy changed(view.get(), &ZoomView::scalesChanged);
    view->showSnapshot(moments.deep);
    EXPECT_GE(changed.count(), 1);
    const double pushedIn = moments.deep.sample.output.model.contact.indentation;
    EXPECT_GE(view->displacementScale().high, 0.9 * pushedIn);
    EXPECT_LE(view->displacementScale().high, 4.0 * pushedIn);
    EXPECT_FALSE(view->colorScale().colors.empty());
    const int changes = static_cast<int>(changed.count());
    view->showSnapshot(moments.deep);
    EXPECT_EQ(changed.count(), changes) << "the same picture, the same scales";
}

TEST_F(ZoomViewTest, StretchesHeightsOnRequestOnly) {
    const Vector3 high = moments.deep.sample.output.model.closest.point + Vector3(0.0, 0.0, 5.0_nm);
    const QImage plain = pictureOf(moments.deep);
    const double before = view->onScreen(high).y();
    pictureOf(moments.away);
    EXPECT_EQ(view->options().heightScale, 1.0);
    view->setOptions({.heightScale = 5.0});
    EXPECT_GT(perMilleDifferent(plain, pictureOf(moments.deep)), 5.0);
    EXPECT_LT(view->onScreen(high).y(), before);
}

TEST_F(ZoomViewTest, SwitchesAxesScaleBarsGridAndSection) {
    EXPECT_FALSE(ViewOptions{}.grid) << "its lines are taken for relief";
    const QImage all = pictureOf(moments.deep);
    for (const ViewOptions& options :
         {ViewOptions{.axes = false}, ViewOptions{.scaleBars = false}, ViewOptions{.grid = true},
          ViewOptions{.section = true}, ViewOptions{.light = {.azimuth = 10.0}}}) {
        view->setOptions(options);
        EXPECT_GT(perMilleDifferent(all, pictureOf(moments.deep)), 1.0);
    }
    view->setOptions({});
    EXPECT_LT(perMilleDifferent(all, pictureOf(moments.deep)), 0.5) << "as before";
}

TEST_F(ZoomViewTest, ALowViewHasTheScaleOnItsAxesAlone) {
    view->resize(420, 300);
    const auto change = [this](ViewOptions options) {
        options.scaleBars = true;
        view->setOptions(options);
        const QImage with = pictureOf(moments.away);
        options.scaleBars = false;
        view->setOptions(options);
        return perMilleDifferent(with, pictureOf(moments.away));
    };
    EXPECT_EQ(change({}), 0.0) << "bars would lie on the axes";
    EXPECT_GT(change({.axes = false}), 0.5);
}

/// As bright as far from the tip where colors are read: those of what the tip changes.
TEST_F(ZoomViewTest, TheTipDarkensTheSurfaceBelowItWhereNoColorsAreReadThere) {
    const auto brightness = [](const QColor& color) {
        return color.red() + color.green() + color.blue();
    };
    const double radius = scene->belief.tipRadius();
    const Vector3& below = moments.away.sample.output.model.closest.point;
    const Vector3 beside = below + 0.6 * radius * towardsEye();
    const Vector3 far = below + 2.2 * radius * towardsEye();
    const QImage byHeight = pictureOf(moments.away);
    EXPECT_LT(brightness(colorAt(byHeight, beside)), brightness(colorAt(byHeight, far)) - 10);
    EXPECT_GT(brightness(colorAt(byHeight, beside)), 0.6 * brightness(colorAt(byHeight, far)))
        << "the color stays the same";
    SurfaceLook look;
    look.quantity = SurfaceQuantity::Displacement;
    view->setLook(look, SurfaceField(SurfaceQuantity::Displacement));
    settle();
    const QImage byDisplacement = pictureOf(moments.away);
    EXPECT_NEAR(brightness(colorAt(byDisplacement, beside)),
                brightness(colorAt(byDisplacement, far)), 12);
}

TEST_F(ZoomViewTest, TheSurfaceShowsThroughTheLowerEndOfTheTip) {
    const double radius = scene->belief.tipRadius();
    const Vector3 beside =
        moments.deep.sample.output.model.closest.point + 0.45 * radius * view->camera().right();
    const QColor usual = colorAt(pictureOf(moments.deep), beside);
    SurfaceLook look;
    look.of(SurfaceQuantity::Height).map = ColorMap::Gold;
    view->setLook(look, SurfaceField());
    settle();
    EXPECT_GT(difference(colorAt(pictureOf(moments.deep), beside), usual), 20);
}

TEST_F(ZoomViewTest, DrawsOneFrameForEachSnapshot) {
    QSignalSpy frames(view.get(), &ZoomView::frameRendered);
    view->showSnapshot(moments.away);
    EXPECT_EQ(frames.count(), 1);
    view->showSnapshot(moments.deep);
    EXPECT_EQ(frames.count(), 2);
}

TEST_F(ZoomViewTest, LeavesOutWhatCannotBeDrawn) {
    pictureOf(moments.deep);
    Snapshot broken = moments.deep;
    broken.sample.output.model.tip.x() = std::numeric_limits<double>::quiet_NaN();
    const QImage picture = pictureOf(broken);
    EXPECT_TRUE(view->window().has_value());
    EXPECT_FALSE(picture.isNull());
}

TEST_F(ZoomViewTest, IsEmptyWithoutAScene) {
    view->setScene(nullptr);
    const QImage picture = pictureOf(moments.deep);
    const Color& backdrop = kLightPalette.backdrop;
    EXPECT_EQ(picture.pixelColor(picture.rect().center()),
              QColor(backdrop.red, backdrop.green, backdrop.blue));
    EXPECT_FALSE(view->window().has_value());
    EXPECT_EQ(view->halfWidth(), 0.0);
    EXPECT_TRUE(view->colorScale().colors.empty());
    view->setHalfWidth(10.0_nm);
    view->resetCamera();
    view->setOptions({.heightScale = 2.0});
    QSignalSpy dragged(view.get(), &ZoomView::tipDragged);
    QTest::mousePress(view.get(), Qt::LeftButton, Qt::NoModifier, {100, 100});
    QTest::mouseMove(view.get(), {150, 150});
    EXPECT_EQ(dragged.count(), 0);
}

TEST_F(ZoomViewTest, TakesManyScenesInARow) {
    const Scene hilly = hillyScene();
    const auto changeScene = [&](int times) {
        for (int i = 0; i < times; ++i) {
            view->setScene(i % 2 == 0 ? &hilly : scene.get());
            view->showSnapshot(moments.deep);
            QCoreApplication::processEvents();
        }
    };
    changeScene(20);
    const double before = residentMegabytes();
    changeScene(50);
    EXPECT_LT(residentMegabytes() - before, 20.0);
}

TEST_F(ZoomViewTest, CanBeMadeAndUnmadeManyTimes) {
    for (int i = 0; i < 5; ++i) {
        ZoomView another;
        another.resize(300, 200);
        another.setScene(scene.get());
        another.showSnapshot(moments.deep);  // not on the screen yet
        another.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&another));
        another.showSnapshot(moments.deep);
        QCoreApplication::processEvents();
    }
}

TEST_F(ZoomViewTest, FitsItsPictureToItsSize) {
    view->showSnapshot(moments.deep);
    view->resize(400, 560);
    settle();
    const ScanWindow window = view->window().value();
    for (const double x : {window.left, window.right}) {
        for (const double y : {window.bottom, window.top}) {
            const QPointF corner = view->onScreen({x, y, 0.0});
            EXPECT_TRUE(QRectF(0.0, 0.0, 400.0, 560.0).contains(corner));
        }
    }
    EXPECT_EQ(view->frame().size(), QSize(400, 560));
}

TEST_F(ZoomViewTest, DrawsAllPixelsFromASideThatIsChosen) {
    view->resize(1200, 800);
    settle();
    view->setDirection(view->camera().azimuth() + 0.1, view->camera().elevation());
    view->showSnapshot(moments.deep);
    EXPECT_EQ(view->frame().size(), QSize(1200, 800));
}

TEST_F(ZoomViewTest, DrawsFewerPixelsWhileTheCameraTurns) {
    view->resize(1200, 800);
    settle();
    view->showSnapshot(moments.deep);
    ASSERT_EQ(view->frame().size(), QSize(1200, 800));
    const Vector3 apex = moments.deep.sample.output.model.tip;
    turn();
    view->showSnapshot(moments.deep);
    const QSize turning = view->frame().size();
    const QPointF whileTurning = view->onScreen(apex);
    EXPECT_LT(turning.width() * turning.height(), 510'000);
    EXPECT_GT(turning.width() * turning.height(), 490'000);
    settle();
    view->showSnapshot(moments.deep);
    EXPECT_EQ(view->frame().size(), QSize(1200, 800));
    EXPECT_LT((view->onScreen(apex) - whileTurning).manhattanLength(), 2.0);
}

/// Where the processor draws, each of both takes so long that the window must answer in between.
TEST_F(ZoomViewTest, DrawsInLargerBuffersOnlyAfterTheyAreMade) {
    view->resize(400, 300);
    settle();
    view->showSnapshot(moments.deep);
    view->resize(1200, 800);
    view->showSnapshot(moments.deep);
    EXPECT_EQ(view->frame().size(), QSize(400, 300)) << "the buffers are made";
    EXPECT_TRUE(eventually([&] { return view->frame().size() == QSize(1200, 800); }));
}

TEST_F(ZoomViewTest, DrawsAllPixelsOfASmallViewWhileTheCameraTurns) {
    view->showSnapshot(moments.deep);
    const QSize still = view->frame().size();
    turn();
    view->showSnapshot(moments.deep);
    EXPECT_EQ(view->frame().size(), still);
}

/// On a screen with two pixels a point.
class FineView : public ZoomView {
protected:
    int metric(PaintDeviceMetric metric) const override {
        if (metric == PdmDevicePixelRatio) {
            return 2;
        }
        return metric == PdmDevicePixelRatioScaled ? static_cast<int>(2 * devicePixelRatioFScale())
                                                   : ZoomView::metric(metric);
    }
};

TEST_F(ZoomViewTest, LettersAreScaledOnceOnAScreenOfSmallPixels) {
    FineView fine;
    fine.resize(500, 400);
    fine.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&fine));
    fine.setScene(scene.get());
    ASSERT_TRUE(eventually([&] { return !fine.frame().isNull(); }));  // drawn when idle
    EXPECT_EQ(fine.frame().size(), QSize(1000, 800));
    EXPECT_EQ(fine.frame().devicePixelRatio(), 2.0);
    EXPECT_EQ(fine.renderWindow().GetDPI(), 72) << "not by VTK as well";
    const ScanWindow window = fine.window().value();
    EXPECT_TRUE(
        QRectF(0.0, 0.0, 500.0, 400.0).contains(fine.onScreen({window.left, window.bottom, 0.0})));
}

}  // namespace asperity::test
