#include "ui/view/ZoomView.h"

#include "core/Units.h"
#include "tests/ui/view/ZoomViewFixture.h"

#include <QOpenGLFunctions>
#include <QSignalSpy>

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
    pictureOf(moments_.away);
    pictureOf(moments_.deep);
    view_->makeCurrent();
    EXPECT_EQ(QOpenGLContext::currentContext()->functions()->glGetError(), GLenum(GL_NO_ERROR));
    view_->doneCurrent();
}

TEST_F(ZoomViewTest, ShowsTheDentInBlueAndTheNeckInOrange) {
    view_->setMagnification(1.0);
    const TipState& state = moments_.deep.sample.output.model;
    // Beside the arrow, inside of the rim.
    const Vector3 inDent =
        state.foot.point - 0.6 * state.contact.contactRadius * view_->camera().right();
    const QColor rest = colourAt(pictureOf(moments_.away), inDent);
    const QColor dent = colourAt(pictureOf(moments_.deep), inDent);
    EXPECT_GT(difference(rest, dent), 60);
    EXPECT_GT(dent.blue(), dent.red() + 30);

    const TipState& pulled = moments_.neck.sample.output.model;
    const Vector3 onNeck = pulled.foot.point - 2.0_nm * view_->camera().right();
    const QColor neck = colourAt(pictureOf(moments_.neck), onNeck);
    EXPECT_GT(neck.red(), neck.blue() + 30);
}

TEST_F(ZoomViewTest, ShowsTheForceInRed) {
    const auto redPixels = [](const QImage& picture) {
        int count = 0;
        for (int y = 0; y < picture.height(); ++y) {
            for (int x = 0; x < picture.width(); ++x) {
                const QColor colour = picture.pixelColor(x, y);
                count += colour.red() > 110 && colour.red() > 2.5 * colour.green() ? 1 : 0;
            }
        }
        return count;
    };
    EXPECT_GT(redPixels(pictureOf(moments_.deep)), 300);
    EXPECT_GT(redPixels(pictureOf(moments_.neck)), 100);
}

TEST_F(ZoomViewTest, ShowsTheSameWithTheCacheAsWithoutIt) {
    view_->setCacheEnabled(false);
    const QImage plain = pictureOf(moments_.deep);
    view_->setCacheEnabled(true);
    pictureOf(moments_.away);
    const QImage cached = pictureOf(moments_.deep);
    EXPECT_LT(perMilleDifferent(plain, cached), 0.5);
    EXPECT_GT(perMilleDifferent(plain, pictureOf(moments_.away)), 5.0) << "the eye of this test";
}

TEST_F(ZoomViewTest, HidesWhatIsUnderTheSurface) {
    // The hole in the terrain is filled: no paper shines through the surface.
    const QImage picture = pictureOf(moments_.deep);
    const ScanWindow window = view_->window().value();
    const Vector3 foot = moments_.deep.sample.output.model.foot.point;
    for (double part = 0.02; part < 0.99; part += 0.002) {
        const Vector3 place(std::lerp(window.left, window.right, part),
                            std::lerp(window.bottom, window.top, 0.3), foot.z());
        EXPECT_LT(colourAt(picture, place).lightness(), 240) << part;
    }
}

TEST_F(ZoomViewTest, FollowsTheTip) {
    view_->showSnapshot(moments_.away);
    const ScanWindow before = view_->window().value();
    QSignalSpy moved(view_.get(), &ZoomView::frameChanged);
    view_->showSnapshot(movedBy(moments_.away, {3.0_nm, 0.0, 0.0}));
    EXPECT_TRUE(sameWindow(view_->window().value(), before));
    EXPECT_EQ(moved.count(), 0);
    view_->showSnapshot(movedBy(moments_.away, {20.0_nm, 0.0, 0.0}));
    const ScanWindow after = view_->window().value();
    EXPECT_EQ(moved.count(), 1);
    EXPECT_GT(after.left, before.left);
    EXPECT_NEAR(after.right - after.left, before.right - before.left, 1e-15);
}

TEST_F(ZoomViewTest, SaysWhatItsColoursMean) {
    QSignalSpy changed(view_.get(), &ZoomView::scalesChanged);
    view_->showSnapshot(moments_.deep);
    EXPECT_GE(changed.count(), 1);
    const double pushedIn = moments_.deep.sample.output.model.contact.indentation;
    EXPECT_GE(view_->displacementScale().high, 0.9 * pushedIn);
    EXPECT_LE(view_->displacementScale().high, 4.0 * pushedIn);
    EXPECT_FALSE(view_->heightScale().colours.empty());
    const int changes = static_cast<int>(changed.count());
    view_->showSnapshot(moments_.deep);
    EXPECT_EQ(changed.count(), changes) << "the same picture, the same scales";
}

TEST_F(ZoomViewTest, MagnifiesByItselfOrAsThePersonWants) {
    view_->showSnapshot(moments_.deep);
    EXPECT_GT(view_->magnification(), 1.0);
    view_->setMagnification(1.0);
    const QImage plain = pictureOf(moments_.deep);
    EXPECT_EQ(view_->magnification(), 1.0);
    view_->setMagnification(8.0);
    EXPECT_EQ(view_->magnification(), 8.0);
    EXPECT_GT(perMilleDifferent(plain, pictureOf(moments_.deep)), 5.0);
}

TEST_F(ZoomViewTest, DrawsOneFrameForEachSnapshot) {
    QSignalSpy frames(view_.get(), &ZoomView::frameRendered);
    view_->showSnapshot(moments_.away);
    EXPECT_EQ(frames.count(), 1);
    view_->showSnapshot(moments_.deep);
    EXPECT_EQ(frames.count(), 2);
}

TEST_F(ZoomViewTest, LeavesOutWhatCannotBeDrawn) {
    pictureOf(moments_.deep);
    Snapshot broken = moments_.deep;
    broken.sample.output.model.tip.x() = std::numeric_limits<double>::quiet_NaN();
    const QImage picture = pictureOf(broken);
    EXPECT_TRUE(view_->window().has_value());
    EXPECT_FALSE(picture.isNull());
}

TEST_F(ZoomViewTest, IsEmptyWithoutAScene) {
    view_->setScene(nullptr);
    const QImage picture = pictureOf(moments_.deep);
    EXPECT_EQ(picture.pixelColor(picture.rect().center()), QColor(Qt::white));
    EXPECT_FALSE(view_->window().has_value());
    EXPECT_EQ(view_->halfWidth(), 0.0);
    EXPECT_TRUE(view_->heightScale().colours.empty());
    view_->setHalfWidth(10.0_nm);
    view_->resetCamera();
    view_->setMagnification(2.0);
    QSignalSpy dragged(view_.get(), &ZoomView::tipDragged);
    QTest::mousePress(view_.get(), Qt::LeftButton, Qt::NoModifier, {100, 100});
    QTest::mouseMove(view_.get(), {150, 150});
    EXPECT_EQ(dragged.count(), 0);
}

TEST_F(ZoomViewTest, TakesManyScenesInARow) {
    const Scene hilly = hillyScene();
    const auto changeScene = [&](int times) {
        for (int i = 0; i < times; ++i) {
            view_->setScene(i % 2 == 0 ? &hilly : scene_.get());
            view_->showSnapshot(moments_.deep);
            QTest::qWait(1);
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
        another.setScene(scene_.get());
        another.showSnapshot(moments_.deep);  // not on the screen yet
        another.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&another));
        another.showSnapshot(moments_.deep);
        QTest::qWait(5);
    }
}

TEST_F(ZoomViewTest, FitsItsPictureToItsSize) {
    view_->showSnapshot(moments_.deep);
    view_->resize(400, 560);
    settle();
    const ScanWindow window = view_->window().value();
    for (const double x : {window.left, window.right}) {
        for (const double y : {window.bottom, window.top}) {
            const QPointF corner = view_->onScreen({x, y, 0.0});
            EXPECT_TRUE(QRectF(0.0, 0.0, 400.0, 560.0).contains(corner));
        }
    }
    EXPECT_EQ(view_->grabFramebuffer().size(), QSize(400, 560));
}

}  // namespace asperity::test
