#include "core/Units.h"
#include "tests/vtkplugins/Fakes.h"
#include "vtkplugins/pictures/RestingPatch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace asperity {
namespace {

constexpr double kRadius = 3.0_nm;

/// A patch 10 nm to either side of the origin.
SurfacePatch patchOf(const std::function<double(double)>& restAt,
                     const std::function<double(double)>& movedAt) {
    SurfacePatch patch{.columns = 101, .rows = 101, .rest = {}, .points = {}, .normals = {}};
    for (int row = 0; row < patch.rows; ++row) {
        for (int column = 0; column < patch.columns; ++column) {
            const double x = 0.2_nm * (column - 50);
            const double y = 0.2_nm * (row - 50);
            patch.rest.emplace_back(x, y, restAt(x));
            patch.points.emplace_back(x, y, restAt(x) + movedAt(x));
        }
    }
    return patch;
}

double flat(double) { return 0.0; }

TEST(ContactCircle, IsOnePieceAtTheContactsRadius) {
    const DeformationView dent = test::hertzDent();
    const auto pieces =
        contactCircle(dent.patch, {dent.contactPoint, Vector3::UnitZ(), dent.contactRadius});
    ASSERT_EQ(pieces.size(), 1U);
    EXPECT_LT((pieces[0].front() - pieces[0].back()).norm(), 1e-20);
    // Half as deep as the middle of the dent (Hertz).
    const double height = dent.patch.rest[0].z() - 0.5 * kRadius * kRadius / dent.tipRadius;
    for (const Vector3& point : pieces[0]) {
        EXPECT_NEAR((point - dent.contactPoint).head<2>().norm(), kRadius, 1e-18);
        EXPECT_NEAR(point.z(), height, 5.0_pm);
    }
}

TEST(ContactCircle, LiesOnASurfaceThatHasNotMovedAlikeAllAround) {
    const auto moved = [](double x) { return 0.1 * x - 0.2_nm; };
    const auto pieces =
        contactCircle(patchOf(flat, moved), {Vector3::Zero(), Vector3::UnitZ(), kRadius});
    ASSERT_EQ(pieces.size(), 1U);
    for (const Vector3& point : pieces[0]) {
        EXPECT_NEAR(point.z(), moved(point.x()), 2.0_pm);
    }
}

TEST(ContactCircle, DoesNotRunUpAWall) {
    const auto wall = [](double x) { return x > 1.5_nm ? 4.0_nm : 0.0; };
    const auto pieces =
        contactCircle(patchOf(wall, flat), {Vector3::Zero(), Vector3::UnitZ(), kRadius});
    EXPECT_GT(pieces.size(), 2U);
    for (const auto& piece : pieces) {
        for (const Vector3& point : piece) {
            EXPECT_LT(std::abs(point.z() - piece.front().z()), 0.4_nm);
        }
    }
}

TEST(ContactCircle, FollowsATiltedContact) {
    const auto slope = [](double x) { return 0.5 * x; };
    const Vector3 outward = Vector3(-0.5, 0.0, 1.0).normalized();
    const auto pieces = contactCircle(patchOf(slope, flat), {Vector3::Zero(), outward, kRadius});
    ASSERT_EQ(pieces.size(), 1U);
    for (const Vector3& point : pieces[0]) {
        EXPECT_NEAR(point.norm(), kRadius, 1e-15);
        EXPECT_NEAR(point.dot(outward), 0.0, 1e-15);
    }
}

}  // namespace
}  // namespace asperity
