#include "core/studies/extremes/ContactExtremes.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

constexpr MaugisUnits kUnits{.radius = 1e-9, .force = 1e-9, .indentation = 1e-10};

TEST(ContactErrors, StatesOnTheSameBranchAreHeldAgainstEachOtherByForceAndRadius) {
    const ContactCourse one{.states = {{.force = 2e-9, .contactRadius = 1e-9}}};
    const ContactCourse other{.states = {{.force = 1e-9, .contactRadius = 2e-9}}};
    const StateErrors errors = contactErrors(one, other, {{0.0, false}}, 0, kUnits);
    EXPECT_DOUBLE_EQ(errors.force, 0.5);
    EXPECT_DOUBLE_EQ(errors.contactRadius, 0.5);
    EXPECT_EQ(errors.jump, 0.0);
}

TEST(ContactErrors, WhereOnlyOneHasJumpedThePositionsOfTheJumpsCount) {
    const ContactState apart;
    const ContactState bonded{.force = -1e-9, .branch = ContactBranch::Bonded};
    const ContactCourse late{.states = {apart, bonded}, .jumpIn = -1e-9, .pullOff = -4e-9};
    const ContactCourse early{.states = {bonded, apart}, .jumpIn = -2e-9, .pullOff = -3e-9};
    const std::vector<ContactStop> way{{-1.5e-9, false}, {-3.5e-9, true}};
    const StateErrors in = contactErrors(late, early, way, 0, kUnits);
    EXPECT_EQ(in.force, 0.0);
    EXPECT_DOUBLE_EQ(in.jump, 0.5);
    EXPECT_DOUBLE_EQ(contactErrors(late, early, way, 1, kUnits).jump, 0.25);
}

}  // namespace
}  // namespace asperity
