#include "core/Units.h"
#include "core/surface/closest/ClosestPointSearch.h"
#include "core/surface/closest/ContactPoints.h"
#include "core/surface/fit/BSplineFit.h"
#include "core/surface/nurbs/NurbsClosestPoint.h"
#include "core/surface/nurbs/NurbsShapes.h"
#include "core/surface/synthetic/SyntheticSurface.h"
#include "tests/core/surface/closest/RoughSurface.h"
#include "tests/support/AllocationCounter.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

namespace asperity {
namespace {

TEST(ClosestPoint, DoesNotAllocate) {
    const BSplineSurface surface = fitSurface(
        sampledMap({.columns = 32, .rows = 32, .sizeX = 64.0_nm, .sizeY = 64.0_nm},
                   EggBox{.amplitude = 20.0_nm, .periodX = 30.0_nm, .periodY = 30.0_nm}));
    const std::size_t before = test::allocationCount();
    double sum = 0.0;
    SearchGuess guess;
    for (int i = 0; i < 500; ++i) {
        const Vector3 query(0.2_nm * i - 10.0_nm, 30.0_nm, 60.0_nm - 0.3_nm * i);
        const ClosestPoint closest = closestPoint(surface, query, guess);
        guess = {.x = closest.point.x(), .y = closest.point.y(), .valid = i % 3 != 0};
        sum += closest.distance;
    }
    const Vector3 noPoint = Vector3::Constant(std::numeric_limits<double>::quiet_NaN());
    sum += closestPoint(surface, noPoint, guess).distance;
    EXPECT_EQ(test::allocationCount(), before);
    EXPECT_NE(sum, 0.0);
}

TEST(ContactPoints, DoNotAllocateOnARoughMap) {
    const BSplineSurface surface =
        test::surfaceOf({.name = "", .columns = 48, .rows = 48, .range = 20.0_nm});
    const std::size_t before = test::allocationCount();
    double sum = 0.0;
    std::size_t several = 0;
    ContactPoints points;
    for (int i = 0; i < 300; ++i) {
        const Vector3 center(0.4_nm * i - 10.0_nm, 0.3_nm * i, 30.0_nm - 0.05_nm * i);
        std::array<SearchGuess, kMaxContactPoints> known;
        const std::size_t kept = i % 3 == 0 ? 0 : points.list.all().size();
        for (std::size_t k = 0; k < kept; ++k) {
            known[k] = points.list.all()[k].guess();
        }
        points = contactPoints(surface, {.center = center, .radius = 15.0_nm}, 10.0_nm,
                               {known.data(), kept});
        sum += points.list.all().front().distance;
        several += points.list.all().size() > 1 ? 1U : 0U;
    }
    EXPECT_EQ(test::allocationCount(), before);
    EXPECT_NE(sum, 0.0);
    EXPECT_GT(several, 10U);
}

TEST(NurbsClosestPoint, DoesNotAllocate) {
    const NurbsSurface torus = torusSurface({}, 200.0_nm, 60.0_nm);
    const std::size_t before = test::allocationCount();
    double sum = 0.0;
    for (int i = 0; i < 200; ++i) {
        const Vector3 query(3.0_nm * i - 200.0_nm, 30.0_nm, 60.0_nm - 1.3_nm * i);
        sum += nearestPoints(torus, query, {.within = 150.0_nm}).nearest().closest.distance;
    }
    sum += nearestPoints(torus, Vector3::Zero(), {}).nearest().closest.distance;
    EXPECT_EQ(test::allocationCount(), before);
    EXPECT_NE(sum, 0.0);
}

TEST(AllocationCounter, CountsWhatIsAllocated) {
    const std::size_t before = test::allocationCount();
    const std::vector<double> memory(100);
    EXPECT_GT(test::allocationCount(), before);
    EXPECT_EQ(memory.size(), 100U);
}

}  // namespace
}  // namespace asperity
