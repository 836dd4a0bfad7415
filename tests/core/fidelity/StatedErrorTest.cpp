#include "core/fidelity/RequiredTerms.h"
#include "core/scene/Scene.h"
#include "tests/core/fidelity/StatedErrors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace asperity {
namespace {

/// What the program does not show either.
constexpr double kNone = 1e-4;
constexpr double kSmall = 0.01;

TEST(StatedError, IsNoSmallerThanTheTrueOneAndNotMuchLarger) {
    int close = 0;
    const std::vector<test::StatedErrorScene> scenes = test::statedErrorScenes();
    ASSERT_EQ(scenes.size(), 15U);
    for (const test::StatedErrorScene& each : scenes) {
        Scene scene = buildScene(each.description);
        const RequiredTerms needs = fitModel(scene);
        const double stated = needs.statedError();
        const double error = test::trueErrors(scene, needs).worst();
        EXPECT_GE(stated + kNone, error) << each.name;
        close += stated <= std::max(3.0 * error, kSmall) ? 1 : 0;
    }
    EXPECT_GE(close, 12);
}

}  // namespace
}  // namespace asperity
