#include "core/words/ModelWords.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

TEST(ForceErrorText, NamesWhatTheLawMisses) {
    SceneNeeds needs{.measured = true, .wholeError = 0.002, .lawError = 0.052};
    needs.lawMisses = {ModelTerm::SphereCorrection};
    EXPECT_EQ(
        forceErrorText(needs),
        "forces within 5.4 % of their rms in 97 ticks of 100: 0.2 % by what is left out, 5.2 % by "
        "what no contact law has beside the rest (sphere correction)");
}

TEST(ForceErrorText, SaysWhereNothingWasMeasured) {
    EXPECT_EQ(forceErrorText({}), "error of the forces not measured");
}

TEST(ForceErrorText, DoesNotRoundAnErrorToNone) {
    EXPECT_EQ(forceErrorText({.measured = true}),
              "forces within 0 % of their rms in 97 ticks of 100");
    EXPECT_EQ(forceErrorText({.measured = true, .wholeError = 1e-7}),
              "forces within 0.01 % of their rms in 97 ticks of 100");
    EXPECT_EQ(forceErrorText({.measured = true, .wholeError = 2.96}),
              "forces within 296 % of their rms in 97 ticks of 100");
}

TEST(ModelNote, ListsWhatIsLeftOutButForWhatTheLawMisses) {
    SceneNeeds needs{.tolerance = 0.05, .lawMisses = {ModelTerm::SphereCorrection}};
    EXPECT_EQ(modelNote(needs),
              "model: error of the forces not measured (tolerance 5 %), nothing left out");
    needs.terms = {{.term = ModelTerm::SphereCorrection, .on = false},
                   {.term = ModelTerm::Friction, .on = false},
                   {.term = ModelTerm::Torsion},
                   {.term = ModelTerm::MountTilt, .on = false}};
    EXPECT_EQ(modelNote(needs), "model: error of the forces not measured (tolerance 5 %); left "
                                "out: friction, mount tilt");
}

}  // namespace
}  // namespace asperity
