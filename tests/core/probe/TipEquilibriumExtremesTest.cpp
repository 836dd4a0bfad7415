#include "core/Units.h"
#include "core/probe/TipEquilibrium.h"
#include "core/scene/Scene.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

namespace asperity {
namespace {

using Limits = std::numeric_limits<double>;

constexpr std::array kOddNumbers{Limits::quiet_NaN(),
                                 Limits::infinity(),
                                 -Limits::infinity(),
                                 Limits::max(),
                                 -Limits::max(),
                                 1e200,
                                 499.0,
                                 1e-5,
                                 Limits::min(),
                                 Limits::denorm_min(),
                                 -1e-310};

bool isFinite(const TipState& state) {
    return state.tip.allFinite() && state.force.allFinite() && state.slip.allFinite() &&
           state.normal.allFinite() && std::isfinite(state.normalForce) &&
           std::isfinite(state.effectiveRadius) && std::isfinite(state.contact.force);
}

void expectStateOrStatus(const TipState& state) {
    EXPECT_TRUE(isFinite(state));
    EXPECT_TRUE(state.contact.solved() || !state.converged);
}

TEST(TipEquilibriumExtremes, ABaseAtAnOddPositionIsSolvedOrNamed) {
    for (const HeightMap& map : {test::flatMap(), test::hillyMap(), test::ridgedMap(20.0_nm)}) {
        const Scene scene = buildScene(test::plainScene(), map);
        for (const double odd : kOddNumbers) {
            SCOPED_TRACE(odd);
            for (const Vector3& position :
                 {Vector3(odd, 64.0_nm, 1.0_nm), Vector3(64.0_nm, odd, 1.0_nm),
                  Vector3(64.0_nm, 64.0_nm, odd), Vector3(odd, odd, odd)}) {
                EquilibriumMemory memory;
                const BaseMotion base{.position = position, .velocity = {1e-6, 0.0, 0.0}};
                expectStateOrStatus(tipEquilibrium(scene.surface, scene.belief, base, memory));
                expectStateOrStatus(heldTip(scene.surface, scene.belief, base, memory));
                EXPECT_TRUE(memory.deflection.allFinite());
            }
        }
    }
}

TEST(TipEquilibriumExtremes, NoNumberIsNoPosition) {
    const Scene scene = buildScene(test::plainScene(), test::flatMap());
    EquilibriumMemory memory;
    memory.deflection = Vector3(0.0, 0.0, 1.0_nm);
    const BaseMotion base{.position = {64.0_nm, Limits::quiet_NaN(), 0.0}};
    const TipState state = tipEquilibrium(scene.surface, scene.belief, base, memory);
    EXPECT_EQ(state.contact.status, ContactStatus::ApproachOutOfRange);
    EXPECT_FALSE(state.converged);
    EXPECT_EQ(state.force, Vector3::Zero());
    EXPECT_EQ(memory.deflection.z(), 1.0_nm);
}

TEST(TipEquilibriumExtremes, AnOddVelocityIsRestOrADirection) {
    const Scene scene = buildScene(test::plainScene(), test::hillyMap());
    for (const double odd : kOddNumbers) {
        SCOPED_TRACE(odd);
        for (const Vector3& velocity :
             {Vector3(odd, 0.0, 0.0), Vector3(0.0, odd, -odd), Vector3(odd, odd, odd)}) {
            EquilibriumMemory memory;
            const BaseMotion base{.position = {64.0_nm, 64.0_nm, 0.0}, .velocity = velocity};
            const TipState state = tipEquilibrium(scene.surface, scene.belief, base, memory);
            EXPECT_TRUE(isFinite(state));
            EXPECT_TRUE(state.contact.solved());
            EXPECT_LE(state.slip.norm(), 1.0 + 1e-12);
        }
    }
}

}  // namespace
}  // namespace asperity
