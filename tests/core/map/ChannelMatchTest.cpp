#include "core/map/ChannelMatch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace asperity {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

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
    EXPECT_THAT(quantitiesLike(approach, "N", "Adhesion"), ElementsAre(MapQuantity::AdhesionForce));
    EXPECT_THAT(quantitiesLike(approach, "N", "Adhesion force"),
                ElementsAre(MapQuantity::AdhesionForce));
    EXPECT_THAT(quantitiesLike(approach, "Pa", "DMTModulus"),
                ElementsAre(MapQuantity::ApparentModulus));
    EXPECT_THAT(quantitiesLike(approach, "m", "HeightSensor"), ElementsAre(MapQuantity::Height));
    const MapPlan contact = planOf(MapMode::Contact);
    EXPECT_THAT(quantitiesLike(contact, "m", "height, retrace"),
                ElementsAre(MapQuantity::HeightRetrace));
    EXPECT_THAT(quantitiesLike(contact, "N", "FRICTION"), ElementsAre(MapQuantity::FrictionForce));
}

TEST(ChannelMatch, LeavesToTheUserWhatTheTitleDoesNotSay) {
    const MapPlan approach = planOf(MapMode::Approach);
    EXPECT_THAT(quantitiesLike(approach, "m", "Deformation"),
                ElementsAre(MapQuantity::SnapInDistance, MapQuantity::Height,
                            MapQuantity::Indentation, MapQuantity::ContactRadius));
    EXPECT_THAT(quantitiesLike(planOf(MapMode::Contact), "m", "Height"),
                ElementsAre(MapQuantity::HeightTrace, MapQuantity::HeightRetrace));
}

TEST(ChannelMatch, ComparesAmountsOfOneUnitOnly) {
    const MapPlan approach = planOf(MapMode::Approach);
    EXPECT_THAT(quantitiesLike(approach, "V", "Friction"), IsEmpty());
    EXPECT_THAT(quantitiesLike(approach, "", "validity"), IsEmpty());
    EXPECT_FALSE(isMeasurable(MapQuantity::Iterations));
}

TEST(ChannelMatch, ChoosesAmongThePlansQuantities) {
    const MapPlan plan{.grid = {2, 2},
                       .region = {0.0, 0.0, 1.0, 1.0},
                       .setpoint = 1e-9,
                       .quantities = {MapQuantity::Indentation, MapQuantity::AdhesionForce}};
    EXPECT_THAT(quantitiesLike(plan, "m", "Deformation"), ElementsAre(MapQuantity::Indentation));
    EXPECT_THAT(quantitiesLike(plan, "N/m", "Stiffness"), IsEmpty());
}

}  // namespace
}  // namespace asperity
