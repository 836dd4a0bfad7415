#include "core/map/MapComparison.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

using Quantities = std::vector<MapQuantity>;

MapPlan planOf(MapMode mode) {
    MapPlan plan{.mode = mode, .grid = {2, 2}, .region = {0.0, 0.0, 1.0, 1.0}, .setpoint = 1e-9};
    for (const MapQuantityRow& row : kEnumTable<MapQuantity>) {
        if (hasQuantity(mode, row)) {
            plan.quantities.push_back(row.value);
        }
    }
    return plan;
}

TEST(ChannelMatch, GoesByUnitAndTitle) {
    const MapPlan approach = planOf(MapMode::Approach);
    EXPECT_EQ(quantitiesLike(approach, "N", "Adhesion"), (Quantities{MapQuantity::AdhesionForce}));
    EXPECT_EQ(quantitiesLike(approach, "N", "Adhesion force"),
              (Quantities{MapQuantity::AdhesionForce}));
    EXPECT_EQ(quantitiesLike(approach, "Pa", "DMTModulus"),
              (Quantities{MapQuantity::ApparentModulus}));
    EXPECT_EQ(quantitiesLike(approach, "m", "HeightSensor"), (Quantities{MapQuantity::Height}));
    const MapPlan contact = planOf(MapMode::Contact);
    EXPECT_EQ(quantitiesLike(contact, "m", "height, retrace"),
              (Quantities{MapQuantity::HeightRetrace}));
    EXPECT_EQ(quantitiesLike(contact, "N", "FRICTION"), (Quantities{MapQuantity::FrictionForce}));
}

TEST(ChannelMatch, LeavesToTheUserWhatTheTitleDoesNotSay) {
    const MapPlan approach = planOf(MapMode::Approach);
    EXPECT_EQ(quantitiesLike(approach, "m", "Deformation"),
              (Quantities{MapQuantity::SnapInDistance, MapQuantity::Height,
                          MapQuantity::Indentation, MapQuantity::ContactRadius}));
    EXPECT_EQ(quantitiesLike(planOf(MapMode::Contact), "m", "Height"),
              (Quantities{MapQuantity::HeightTrace, MapQuantity::HeightRetrace}));
}

TEST(ChannelMatch, ComparesAmountsOfOneUnitOnly) {
    const MapPlan approach = planOf(MapMode::Approach);
    EXPECT_EQ(quantitiesLike(approach, "V", "Friction"), Quantities{});
    EXPECT_EQ(quantitiesLike(approach, "", "validity"), Quantities{});
    EXPECT_FALSE(isMeasurable(MapQuantity::Iterations));
    EXPECT_FALSE(isMeasurable(MapQuantity::AdhesionForceDeviation));
}

TEST(ChannelMatch, ChoosesAmongThePlansQuantities) {
    const MapPlan plan{.grid = {2, 2},
                       .region = {0.0, 0.0, 1.0, 1.0},
                       .setpoint = 1e-9,
                       .quantities = {MapQuantity::Indentation, MapQuantity::AdhesionForce}};
    EXPECT_EQ(quantitiesLike(plan, "m", "Deformation"), (Quantities{MapQuantity::Indentation}));
    EXPECT_EQ(quantitiesLike(plan, "N/m", "Stiffness"), Quantities{});
}

}  // namespace
}  // namespace asperity
