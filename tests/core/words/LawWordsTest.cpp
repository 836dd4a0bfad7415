#include "core/words/LawWords.h"

#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

TEST(LawWords, SayWhyALawWasTaken) {
    EXPECT_EQ(whyOf({ContactLaw::Jkr, LawReason::AskedFor}), "as asked for");
    EXPECT_EQ(whyOf({ContactLaw::Jkr, LawReason::TermsOfScene}), "as the scene says of its terms");
    EXPECT_EQ(whyOf({ContactLaw::Hertz, LawReason::NoAdhesion}), "auto: no adhesion");
    EXPECT_EQ(whyOf({ContactLaw::HertzFilm, LawReason::FilmWithoutAdhesion}),
              "auto: a film, no adhesion");
}

TEST(LawWords, NameTheWidthThatDecided) {
    EXPECT_EQ(whyOf({ContactLaw::Split, LawReason::NarrowContact, 0.26}),
              "auto: contact radius over tip radius is 0.26 without load, below 0.3: "
              "Maugis-Dugdale, exact from DMT to JKR, with its van der Waals tail before contact");
    EXPECT_EQ(whyOf({ContactLaw::SphereSplit, LawReason::WideContact, 2.5}),
              "auto: contact radius over tip radius is 2.5 without load, above 0.3: the paraboloid "
              "does not hold, the exact sphere does");
}

TEST(LawWords, TellOfTheTableWhereThereIsOne) {
    SceneDescription description = test::plainScene();
    description.choices.law = ContactLaw::Hertz;
    EXPECT_EQ(lawNote(buildScene(description, test::flatMap())),
              "contact law: hertz (as asked for)");
    description.choices = {.law = ContactLaw::Maugis, .solver = SolverTier::Table};
    EXPECT_NE(lawNote(buildScene(description, test::flatMap()))
                  .find("(as asked for); tabulated, error at most "),
              std::string::npos);
}

}  // namespace
}  // namespace asperity
