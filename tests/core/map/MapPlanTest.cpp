#include "core/map/MapPlan.h"

#include "core/Error.h"
#include "core/Units.h"
#include "core/scene/Scene.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

const Scene& scene() {
    static const Scene kScene = buildScene(test::plainScene(), test::flatMap());
    return kScene;
}

std::string refusalOf(const MapRequest& request) {
    try {
        (void)planMap(scene(), request);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(MapPlan, IsByItselfEveryPixelOfTheScan) {
    const MapPlan plan = planMap(scene(), {});
    EXPECT_EQ(plan.grid, (MapGrid{64, 64}));
    EXPECT_EQ(plan.setpoint, scene().description.setpoint);
    EXPECT_EQ(plan.quantities.size(), 14U);
    EXPECT_NEAR(plan.position(0, 0).x(), 1.0_nm, 1e-20);
    EXPECT_NEAR(plan.position(0, 0).y(), 127.0_nm, 1e-20);
    EXPECT_NEAR(plan.position(63, 63).x(), 127.0_nm, 1e-20);
    EXPECT_NEAR(plan.position(63, 63).y(), 1.0_nm, 1e-20);
}

TEST(MapPlan, OfARegionHasItsPixels) {
    const MapPlan plan =
        planMap(scene(), {.region = MapRegion{10.0_nm, 20.0_nm, 30.0_nm, 26.0_nm}});
    EXPECT_EQ(plan.grid, (MapGrid{10, 3}));
    EXPECT_NEAR(plan.position(2, 9).x(), 29.0_nm, 1e-20);
    EXPECT_NEAR(plan.position(2, 9).y(), 21.0_nm, 1e-20);
}

TEST(MapPlan, KeepsQuantitiesInTheOrderOfTheTable) {
    const MapPlan plan = planMap(scene(), {.quantities = {"height", "pull_off_force"}});
    EXPECT_EQ(plan.quantities, (std::vector{MapQuantity::PullOffForce, MapQuantity::Height}));
}

TEST(MapPlan, RefusesWhatCannotBeMapped) {
    EXPECT_EQ(refusalOf({.quantities = {"color"}}).substr(0, 62),
              "mode approach has no quantity 'color': expected pull_off_force");
    EXPECT_EQ(refusalOf({.mode = MapMode::Contact, .quantities = {"pull_off_force"}}).substr(0, 56),
              "mode contact has no quantity 'pull_off_force': expected ");
    EXPECT_EQ(refusalOf({.region = MapRegion{0.0, 0.0, 200.0_nm, 20.0_nm}}),
              "the region of the map lies outside the scan, which is 1.28e-07 m wide and 1.28e-07 "
              "m high");
    EXPECT_EQ(refusalOf({.region = MapRegion{20.0_nm, 0.0, 20.0_nm, 20.0_nm}}),
              "the region of the map is empty: expected x0 < x1 and y0 < y1");
    EXPECT_EQ(refusalOf({.grid = MapGrid{0, 8}}),
              "the grid of the map must have 1 to 65536 pixels along each side");
    EXPECT_EQ(refusalOf({.setpoint = -1e-9}), "the setpoint must lie between 1 pN and 1 mN");
}

}  // namespace
}  // namespace asperity
