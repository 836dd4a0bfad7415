#include "core/studies/extremes/ExtremesGrid.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

TEST(ExtremesGrid, HasAsManyStatesAsAreAskedFor) {
    for (const double asked : {1e4, 3e4, 1e5, 1.1e6, 1e7, 1e9}) {
        const auto states = static_cast<double>(ExtremesGrid::ofAbout(asked).states());
        EXPECT_NEAR(states / asked, 1.0, 0.1) << asked;
    }
}

TEST(ExtremesGrid, ReachesTheEndsOfItsRangesWhateverTheNumberOfStates) {
    for (const double asked : {1e4, 1e6}) {
        const ContactGrid contact = ExtremesGrid::ofAbout(asked).contact;
        EXPECT_DOUBLE_EQ(contact.tipRadii.front(), 0.5e-9);
        EXPECT_DOUBLE_EQ(contact.tipRadii.back(), 10e-6);
        EXPECT_DOUBLE_EQ(contact.moduli.front(), 1e4);
        EXPECT_DOUBLE_EQ(contact.moduli.back(), 1e12);
    }
}

}  // namespace
}  // namespace asperity
