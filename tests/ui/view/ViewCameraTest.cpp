#include "ui/view/ViewCamera.h"

#include "core/Units.h"

#include <vtkCamera.h>
#include <vtkNew.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace asperity {

namespace {

constexpr double kAspect = 1.4;

const FrameBox kBox{.middle = {500.0_nm, 300.0_nm, 20.0_nm},
                    .halfWidth = 40.0_nm,
                    .below = 12.0_nm,
                    .above = 6.0_nm,
                    .tipTop = 45.0_nm};

/// Where a position is seen: -1 ... 1 from left to right and from bottom to top.
Vector2 seenAt(const ViewCamera& view, const Vector3& position) {
    vtkNew<vtkCamera> camera;
    view.apply(camera, kBox, kAspect);
    const Vector3 arm = position - Vector3(camera->GetFocalPoint());
    const double halfHeight = camera->GetParallelScale();
    return {arm.dot(view.right()) / (halfHeight * kAspect), arm.dot(view.up()) / halfHeight};
}

}  // namespace

TEST(ViewCamera, SeesTheWholeFrameFromEverySide) {
    for (int step = 0; step < 32; ++step) {
        const double azimuth = 0.2 * step;
        for (const double elevation : {-3.0, 0.0, 0.3, 3.0}) {
            ViewCamera view;
            view.turn(azimuth, elevation);
            for (const double x : {-40.0_nm, 40.0_nm}) {
                for (const double y : {-40.0_nm, 40.0_nm}) {
                    for (const double z : {-12.0_nm, 6.0_nm}) {
                        const Vector2 seen = seenAt(view, kBox.middle + Vector3(x, y, z));
                        EXPECT_LE(seen.cwiseAbs().maxCoeff(), 1.0) << azimuth << " " << elevation;
                    }
                }
            }
            EXPECT_LE(seenAt(view, kBox.middle + Vector3(0.0, 0.0, 45.0_nm)).y(), 1.0);
        }
    }
}

TEST(ViewCamera, LeavesRoomForWordsAroundTheFrameOfAWideAndOfANarrowView) {
    for (const double aspect : {0.5, 1.0, 3.0}) {
        for (const double words : {0.02, 0.1}) {
            for (int step = 0; step < 16; ++step) {
                ViewCamera view;
                view.turn(0.4 * step, 0.0);
                vtkNew<vtkCamera> camera;
                view.apply(camera, kBox, aspect, {.under = words, .beside = words});
                const double halfHeight = camera->GetParallelScale();
                double lowest = 1.0;
                double widest = 0.0;
                for (const double x : {-40.0_nm, 40.0_nm}) {
                    for (const double y : {-40.0_nm, 40.0_nm}) {
                        const Vector3 arm = kBox.middle + Vector3(x, y, -12.0_nm) -
                                            Vector3(camera->GetFocalPoint());
                        lowest = std::min(lowest, arm.dot(view.up()) / halfHeight);
                        widest = std::max(widest,
                                          std::abs(arm.dot(view.right())) / (halfHeight * aspect));
                    }
                }
                EXPECT_GE(lowest, -1.0 + 2.0 * words) << aspect;
                EXPECT_LE(widest, 1.0 - 2.0 * words) << aspect;
                const Vector3 top = kBox.middle + Vector3(0.0, 0.0, 45.0_nm);
                EXPECT_LE((top - Vector3(camera->GetFocalPoint())).dot(view.up()), halfHeight);
            }
        }
    }
}

TEST(ViewCamera, FillsTheView) {
    const ViewCamera view;
    double widest = 0.0;
    for (const double x : {-40.0_nm, 40.0_nm}) {
        for (const double y : {-40.0_nm, 40.0_nm}) {
            widest = std::max(widest, seenAt(view, kBox.middle + Vector3(x, y, 0.0)).x());
        }
    }
    EXPECT_GT(widest, 0.75);
}

TEST(ViewCamera, StaysAboveTheSurface) {
    ViewCamera view;
    view.turn(0.0, -10.0);
    EXPECT_GT(view.out().z(), 0.1);
    view.turn(0.0, 10.0);
    EXPECT_GT(view.out().z(), 0.9);
    EXPECT_GT(view.up().z(), 0.0) << "never upside down";
}

TEST(ViewCamera, LooksThroughVtksCameraTheSameWay) {
    vtkNew<vtkCamera> camera;
    ViewCamera view;
    view.turn(0.7, 0.2);
    view.apply(camera, kBox, kAspect);
    const Vector3 towards(camera->GetDirectionOfProjection());
    EXPECT_LT((towards + view.out()).norm(), 1e-12);
    const std::array<double, 2> range{camera->GetClippingRange()[0], camera->GetClippingRange()[1]};
    EXPECT_GT(range[1] - range[0], 4.0 * kBox.halfWidth);
}

TEST(ViewCamera, FindsTheHorizontalMoveThatLooksLikeAMoveInTheView) {
    for (const double azimuth : {0.0, 1.0, 2.5, 4.0}) {
        ViewCamera view;
        view.turn(azimuth, 0.1);
        const Vector3 move = view.horizontalMove(3.0_nm, -2.0_nm);
        EXPECT_EQ(move.z(), 0.0);
        EXPECT_NEAR(move.dot(view.right()), 3.0_nm, 1e-20);
        EXPECT_NEAR(move.dot(view.up()), -2.0_nm, 1e-20);
    }
}

TEST(ViewCamera, ResetsToItsFirstDirection) {
    ViewCamera view;
    const Vector3 first = view.out();
    view.turn(1.0, 0.3);
    EXPECT_GT((view.out() - first).norm(), 0.3);
    view.reset();
    EXPECT_EQ(view.out(), first);
}

TEST(ViewCamera, LooksFromTheSidesOfTheScan) {
    const auto sees = [](ViewDirection side, const Vector3& right, const Vector3& up) {
        ViewCamera view;
        view.lookFrom(side);
        EXPECT_LT((view.right() - right).norm(), 1e-12) << static_cast<int>(side);
        EXPECT_LT((view.up() - up).norm(), 1e-12) << static_cast<int>(side);
        vtkNew<vtkCamera> camera;
        view.apply(camera, kBox, kAspect);
        EXPECT_LT((Vector3(camera->GetViewUp()) - up).norm(), 1e-12);
        EXPECT_LT((Vector3(camera->GetDirectionOfProjection()) + view.out()).norm(), 1e-12);
    };
    const Vector3 x = Vector3::UnitX();
    const Vector3 y = Vector3::UnitY();
    const Vector3 z = Vector3::UnitZ();
    sees(ViewDirection::Front, x, z);
    sees(ViewDirection::Back, -x, z);
    sees(ViewDirection::Right, y, z);
    sees(ViewDirection::Left, -y, z);
    sees(ViewDirection::Top, x, y);
    sees(ViewDirection::Bottom, x, -y);
}

TEST(ViewCamera, SeesNoHeightsFromAboveAndNoGroundFromItsEdge) {
    ViewCamera view;
    view.lookFrom(ViewDirection::Top);
    EXPECT_EQ(view.heightSeen(), 0.0);
    EXPECT_NEAR(view.horizontalMove(0.0, 2.0_nm).y(), 2.0_nm, 1e-20);
    view.lookFrom(ViewDirection::Front);
    EXPECT_EQ(view.heightSeen(), 1.0);
    const Vector3 move = view.horizontalMove(3.0_nm, 2.0_nm);
    EXPECT_NEAR(move.x(), 3.0_nm, 1e-20);
    EXPECT_NEAR(move.y(), 0.0, 1e-20) << "no move along the line of sight";
    view.turn(0.0, 0.1);
    EXPECT_NEAR(view.out().z(), std::sin(0.1), 1e-12) << "turns on from there";
}

TEST(ViewCamera, WithPerspectiveHasTheSameScaleInTheMiddle) {
    ViewCamera view;
    vtkNew<vtkCamera> camera;
    view.apply(camera, kBox, kAspect);
    const double before = camera->GetParallelScale();
    view.setPerspective(true);
    view.apply(camera, kBox, kAspect);
    EXPECT_EQ(camera->GetParallelProjection(), 0);
    EXPECT_EQ(camera->GetParallelScale(), before);
    const double halfAngle = 0.5 * camera->GetViewAngle() * std::numbers::pi / 180.0;
    EXPECT_NEAR(std::tan(halfAngle) * camera->GetDistance(), before, 1e-9 * before);
}

}  // namespace asperity
