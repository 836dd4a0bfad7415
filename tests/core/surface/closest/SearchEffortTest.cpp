// What a closest point is worth that less effort was made for.
#include "core/surface/closest/ClosestPointSearch.h"
#include "core/surface/closest/ContactPoints.h"
#include "tests/core/surface/closest/RoughSurface.h"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity {
namespace {

constexpr double kSlideHeight = 12.0_nm;

struct Slide {
    int queries = 0;
    int wrongLocal = 0;
    int wrongGlobal = 0;
};

bool isFarther(const ClosestPoint& closest, const ClosestPoint& nearest) {
    return std::abs(closest.distance) > std::abs(nearest.distance) + 1e-6_nm;
}

/// Slides a point over a rough sample, each search starting from its own last closest point.
Slide slideOver(const BSplineSurface& surface) {
    ClosestPointTracker tracker;
    ClosestPointTracker none;
    SearchGuess local;
    SearchGuess global;
    Slide slide;
    for (double x = 0.0; x < surface.sizeX(); x += 0.2_nm, ++slide.queries) {
        const double y = surface.sizeY() * (0.5 + 0.4 * std::sin(x / 20.0_nm));
        const Vector3 query(x, y, surface.at(x, y).height + kSlideHeight);
        const ClosestPoint nearest = closestPoint(surface, query, {}, tracker);
        const ClosestPoint byLocal = closestPoint(surface, query, local, none, SearchEffort::Local);
        const ClosestPoint byGlobal =
            closestPoint(surface, query, global, none, SearchEffort::Global);
        EXPECT_EQ(byLocal.proof, SearchProof::NotSought);
        EXPECT_EQ(byGlobal.proof, SearchProof::Likely);
        EXPECT_FALSE(byGlobal.certified());
        slide.wrongLocal += isFarther(byLocal, nearest) ? 1 : 0;
        slide.wrongGlobal += isFarther(byGlobal, nearest) ? 1 : 0;
        local = byLocal.guess();
        global = byGlobal.guess();
    }
    return slide;
}

TEST(SearchEffort, GlobalIsRarelyWrongWhereLocalOftenIs) {
    const Slide slide = slideOver(test::surfaceOf(
        {.name = "", .columns = 200, .rows = 60, .range = 30.0_nm, .smoothing = 1.5}));
    EXPECT_GT(slide.wrongLocal, slide.queries / 20);
    EXPECT_LT(slide.wrongGlobal, slide.wrongLocal / 8);
}

TEST(SearchEffort, OfATipIsToldByItsProof) {
    const BSplineSurface surface =
        test::surfaceOf({.name = "", .columns = 60, .rows = 60, .range = 5.0_nm, .smoothing = 1.0});
    const TipSphere tip{.center = {60.0_nm, 60.0_nm, 17.0_nm}, .radius = 15.0_nm};
    ClosestPointTracker tracker;
    const auto proofWith = [&](SearchEffort effort) {
        return contactPoints(surface, tip, {.reach = 10.0_nm, .effort = effort}, {}, tracker).proof;
    };
    EXPECT_EQ(proofWith(SearchEffort::Local), SearchProof::NotSought);
    EXPECT_EQ(proofWith(SearchEffort::Global), SearchProof::Likely);
    EXPECT_EQ(proofWith(SearchEffort::Certified), SearchProof::Nearest);
}

}  // namespace
}  // namespace asperity
