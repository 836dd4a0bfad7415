#include "core/scene/ModelTerm.h"

#include "core/contact/laws/ContactLaw.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

/// The sphere's law hides the curvature; it came back with the next law, as a part of what the
/// sphere was said to change.
TEST(ModelTerm, AnOptionThatTheLawHidesIsSwitchedOff) {
    ForceModelOptions model;
    model.law = ContactLaw::SphereSplit;
    model.curvature = true;
    ASSERT_FALSE(has(model, ModelTerm::SampleCurvature));
    const ForceModelOptions flat = without(model, ModelTerm::SampleCurvature);
    EXPECT_FALSE(has(without(flat, ModelTerm::SphereCorrection), ModelTerm::SampleCurvature));
    EXPECT_TRUE(has(without(model, ModelTerm::SphereCorrection), ModelTerm::SampleCurvature));
}

}  // namespace
}  // namespace asperity
