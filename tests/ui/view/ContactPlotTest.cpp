#include "ui/view/ContactPlot.h"

#include "core/Units.h"
#include "tests/support/TestScenes.h"
#include "tests/ui/view/ViewMoments.h"
#include "ui/view/ViewFrame.h"
#include "ui/widgets/Theme.h"

#include <QMouseEvent>
#include <QSignalSpy>
#include <QtTest>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity::test {
namespace {

Vector2 tipApex(const ContactSection& section) {
    return *std::min_element(
        section.tip.begin(), section.tip.end(),
        [](const Vector2& one, const Vector2& other) { return one.y() < other.y(); });
}

class ContactPlotTest : public ::testing::Test {
protected:
    void SetUp() override {
        plot.resize(600, 400);
        plot.setScene(&scene);
    }

    Scene scene = flatScene();
    ViewMoments moments = momentsOf(scene);
    ContactPlot plot;
};

TEST_F(ContactPlotTest, IsEmptyWithoutATip) {
    EXPECT_FALSE(plot.section());
    plot.grab();
    plot.showSnapshot(moments.deep);
    EXPECT_TRUE(plot.section());
    plot.setScene(nullptr);
    EXPECT_FALSE(plot.section());
}

TEST_F(ContactPlotTest, IsTrueToScaleUnlessAFactorIsAskedFor) {
    plot.showSnapshot(moments.deep);
    EXPECT_EQ(plot.drawnFactor(), 1.0);
    const auto lengths = [this] {
        const QPointF from = plot.toPixel({0.0, 0.0});
        return QPointF(plot.toPixel({2.0_nm, 0.0}).x() - from.x(),
                       from.y() - plot.toPixel({0.0, 2.0_nm}).y());
    };
    EXPECT_NEAR(lengths().x(), lengths().y(), 1e-9);
    plot.setHeightFactor(5.0);
    EXPECT_NEAR(5.0 * lengths().x(), lengths().y(), 1e-9);
    plot.setHeightFactor(0.0);
    EXPECT_GT(plot.drawnFactor(), 1.0) << "a dent of nanometers is flat";
    EXPECT_NEAR(plot.drawnFactor() * lengths().x(), lengths().y(), 1e-9);
}

/// On polystyrene 5 nN changed the picture by nothing that one saw.
TEST_F(ContactPlotTest, ItsScaleIsThatOfTheContactAtTheSetpointAndStaysThroughACycle) {
    plot.showSnapshot(moments.away);
    const double halfWidth = plot.halfWidth();
    const double contact = unloadedContactRadius(scene.belief.contact.pair());
    EXPECT_GT(halfWidth, 2.5 * contact);
    EXPECT_LT(halfWidth, 4.0 * contact);
    const double surface = plot.toPixel({0.0, 0.0}).y();
    const auto apex = [this] { return plot.toPixel(tipApex(*plot.section())).y(); };
    EXPECT_LT(apex(), surface - 20.0) << "far: the tip is seen above the sample";
    plot.showSnapshot(moments.deep);
    const double deepest = apex();
    EXPECT_GT(deepest, surface + 8.0) << "the dent is seen";
    plot.showSnapshot(moments.neck);
    EXPECT_LT(apex(), deepest) << "a tip that rises, rises in the plot";
    plot.showSnapshot(moments.away);
    EXPECT_EQ(plot.halfWidth(), halfWidth);
    EXPECT_DOUBLE_EQ(plot.toPixel({0.0, 0.0}).y(), surface);
}

TEST_F(ContactPlotTest, ALowPlotShowsTheTipAboveTheSampleToo) {
    plot.resize(600, 160);
    plot.showSnapshot(moments.away);
    EXPECT_GT(plot.toPixel(tipApex(*plot.section())).y(), 26.0) << "below the upper edge";
    const QPointF middle = plot.toPixel({0.0, 0.0});
    EXPECT_NEAR(plot.toPixel({1.0_nm, 0.0}).x() - middle.x(),
                middle.y() - plot.toPixel({0.0, 1.0_nm}).y(), 1e-9)
        << "true to scale";
}

/// Under a large tip on a slope the contact lay beside what was seen: the tip seemed to hover.
TEST_F(ContactPlotTest, ShowsAContactFarBesideTheTipsAxis) {
    const Scene hills = hillyScene();
    plot.setScene(&hills);
    Snapshot moment = momentsOf(hills).deep;
    TipState& state = moment.sample.output.model;
    state.closest.point.x() = state.tip.x() + 2.0 * plot.halfWidth();
    plot.showSnapshot(moment);
    ASSERT_TRUE(plot.section());
    const QPointF contact = plot.toPixel(plot.section()->contact);
    EXPECT_LT(std::abs(contact.x() - 0.5 * plot.width()), 0.45 * plot.width());
}

/// On a flank the tip hovered clear of the surface, and the ends of the contact floated in it.
TEST_F(ContactPlotTest, TurnsThroughAContactThatLiesBesideItsPlane) {
    const Scene hills = hillyScene();
    plot.setScene(&hills);
    Snapshot moment = momentsOf(hills).deep;
    TipState& state = moment.sample.output.model;
    state.closest.point.x() = state.tip.x();
    state.closest.point.y() = state.tip.y() + 0.3 * plot.halfWidth();
    plot.setAzimuth(0.0);
    plot.showSnapshot(moment);
    EXPECT_EQ(plot.azimuth(), 0.0) << "as it was chosen";
    plot.setAzimuth(std::nullopt);
    EXPECT_NEAR(plot.azimuth(), std::numbers::pi / 2.0, 1e-9);
    state.closest.point.x() += 0.02 * plot.halfWidth();
    plot.showSnapshot(moment);
    EXPECT_NEAR(plot.azimuth(), std::numbers::pi / 2.0, 1e-9) << "not for less than one sees";
}

TEST_F(ContactPlotTest, ItsScaleFollowsTheSetpoint) {
    plot.showSnapshot(moments.away);
    const double before = plot.halfWidth();
    scene.description.setpoint *= 400.0;
    plot.showSnapshot(moments.away);
    EXPECT_GT(plot.halfWidth(), 1.5 * before);
}

TEST_F(ContactPlotTest, TheWidthThatAUserChoseIsTold) {
    EXPECT_FALSE(plot.chosenHalfWidth());
    plot.setHalfWidth(12.0_nm);
    EXPECT_EQ(plot.chosenHalfWidth(), 12.0_nm);
    plot.setScene(&scene);
    EXPECT_FALSE(plot.chosenHalfWidth());
}

TEST_F(ContactPlotTest, ASlopingSampleScrollsOnlyBeforeItLeavesTheMiddle) {
    const Scene slope = buildScene(plainScene(), slopedMap(0.4));
    plot.setScene(&slope);
    Snapshot moment = momentsOf(slope).deep;
    plot.showSnapshot(moment);
    const auto below = [&] {
        const Vector2 axis = plot.section()->axis;
        return plot.toPixel({0.0, slope.surface.at(axis.x(), axis.y()).height}).y();
    };
    const double first = below();
    moment.sample.output.model.tip += Vector3(1.0_nm, 0.0, 0.4_nm);
    plot.showSnapshot(moment);
    EXPECT_LT(below(), first - 1.0) << "it is higher there, and is drawn higher";
    moment.sample.output.model.tip += Vector3(60.0_nm, 0.0, 24.0_nm);
    plot.showSnapshot(moment);
    EXPECT_GT(below(), 0.3 * plot.height());
    EXPECT_LT(below(), 0.9 * plot.height());
}

TEST_F(ContactPlotTest, ShowsTheSurfaceWhereThePlotSaysItIs) {
    plot.showSnapshot(moments.deep);
    const QImage picture = plot.grab().toImage();
    const QPointF middle = plot.toPixel(plot.section()->contact);
    const QPointF aside = plot.toPixel({0.9 * plot.halfWidth(), 0.0});
    EXPECT_GT(middle.y(), aside.y() + 1.0) << "the dent lies deeper, on the screen too";
    const auto darkest = [&](const QPointF& at) {
        int lightness = 255;
        for (int dy = -2; dy <= 2; ++dy) {
            lightness =
                std::min(lightness, picture.pixelColor(at.toPoint() + QPoint(0, dy)).lightness());
        }
        return lightness;
    };
    EXPECT_LT(darkest(aside), 110);
    EXPECT_GT(picture.pixelColor(aside.toPoint() - QPoint(0, 30)).lightness(), 200);
}

TEST_F(ContactPlotTest, TurnsItsPlaneWithoutAnotherSnapshot) {
    plot.showSnapshot(moments.deep);
    plot.setAzimuth(std::numbers::pi / 2.0);
    ASSERT_TRUE(plot.section());
    EXPECT_NEAR(plot.section()->direction.y(), 1.0, 1e-12);
}

TEST_F(ContactPlotTest, PointsAtThePlaceUnderThePointerAlongThePlane) {
    plot.setAzimuth(std::numbers::pi / 2.0);
    plot.showSnapshot(moments.deep);
    QSignalSpy hovered(&plot, &ContactPlot::positionHovered);
    const QPointF pixel = plot.toPixel({10.0_nm, 0.0});
    QMouseEvent move(QEvent::MouseMove, pixel, Qt::NoButton, Qt::NoButton, Qt::NoModifier);
    QApplication::sendEvent(&plot, &move);
    ASSERT_EQ(hovered.count(), 1);
    EXPECT_NEAR(hovered[0][0].toDouble(), plot.section()->axis.x(), 1e-15);
    EXPECT_NEAR(hovered[0][1].toDouble(), plot.section()->axis.y() + 10.0_nm, 1e-13);
    QSignalSpy left(&plot, &ContactPlot::pointerLeft);
    QMouseEvent out(QEvent::MouseMove, QPointF(2.0, 2.0), Qt::NoButton, Qt::NoButton,
                    Qt::NoModifier);
    QApplication::sendEvent(&plot, &out);
    EXPECT_EQ(left.count(), 1);
}

/// "283 pN" stood in free air.
TEST_F(ContactPlotTest, ShowsNoForceThatIsWithinItsNoise) {
    const auto redPixels = [&](double sigma) {
        Snapshot moment = moments.deep;
        moment.sample.time += 1.0;
        moment.sample.output.estimate.covariance = sigma * sigma * Matrix3::Identity();
        plot.showSnapshot(moment);
        const QImage picture = plot.grab().toImage();
        int count = 0;
        for (int y = 0; y < picture.height(); ++y) {
            for (int x = 0; x < picture.width(); ++x) {
                count += picture.pixelColor(x, y) == theme::colors().force ? 1 : 0;
            }
        }
        return count;
    };
    const double force = moments.deep.sample.output.estimate.force.norm();
    ASSERT_GT(force, 0.0);
    EXPECT_GT(redPixels(0.1 * force), 50);
    EXPECT_EQ(redPixels(0.4 * force), 0);
}

}  // namespace
}  // namespace asperity::test
