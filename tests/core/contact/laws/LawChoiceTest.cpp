#include "core/contact/laws/ContactModel.h"
#include "tests/core/contact/laws/ContactCases.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

TEST(LawChoice, TakesWhatWasAskedFor) {
    for (const ContactLaw law : kValues<ContactLaw>) {
        EXPECT_EQ(chooseLaw(law, test::paperPair("rubber")).law, law);
        EXPECT_EQ(chooseLaw(law, test::paperPair("rubber")).reason, LawReason::AskedFor);
    }
}

TEST(LawChoice, TakesTheSphereFromAThirdOfTheTipsRadiusOn) {
    const ContactPair stiff = test::paperPair("PS");  // a/R = 0.26 without load
    EXPECT_EQ(chooseLaw({}, stiff).law, ContactLaw::Split);
    EXPECT_EQ(chooseLaw({}, test::paperPair("SiO2")).law, ContactLaw::Split);
    EXPECT_EQ(chooseLaw({}, test::paperPair("rubber")).law, ContactLaw::SphereSplit);
    // The ratio goes with (w / E* R)^(1/3) or slower: a narrow band around 0.3 decides.
    ContactPair pair = stiff;
    pair.reducedModulus = stiff.reducedModulus / 1.35;
    EXPECT_EQ(chooseLaw({}, pair).law, ContactLaw::Split) << chooseLaw({}, pair).unloadedRatio;
    pair.reducedModulus = stiff.reducedModulus / 1.75;
    EXPECT_EQ(chooseLaw({}, pair).law, ContactLaw::SphereSplit)
        << chooseLaw({}, pair).unloadedRatio;
}

TEST(LawChoice, NeedsNoAdhesionForHertz) {
    ContactPair pair = test::paperPair("rubber");
    pair.workOfAdhesion = 0.0;
    EXPECT_EQ(chooseLaw({}, pair).law, ContactLaw::Hertz);
    EXPECT_EQ(chooseLaw({}, pair, 10e-9).law, ContactLaw::HertzFilm);
    EXPECT_EQ(chooseLaw({}, pair, 0.0, 0.3).law, ContactLaw::Sneddon) << "a paraboloid has no cone";
}

}  // namespace
}  // namespace asperity
