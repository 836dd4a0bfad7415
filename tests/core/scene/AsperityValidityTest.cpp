#include "core/Units.h"
#include "core/contact/laws/AttractiveTail.h"
#include "core/probe/TipEquilibrium.h"
#include "core/scene/Scene.h"
#include "core/scene/TipValidity.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace asperity {
namespace {

/// A Gaussian bump on a plane, and the tip that presses on its top.
struct Bump {
    double height = 0.0;     ///< [m]
    double width = 0.0;      ///< standard deviation [m]
    double tipRadius = 0.0;  ///< [m]
    double pitch = 0.0;      ///< [m]
    double smoothing = 0.0;  ///< [pixel]
    double scale = 1.0;      ///< of all lengths and of the work of adhesion
    bool attracts = false;   ///< beside the contact, in the model

    [[nodiscard]] double curvature() const { return height / (width * width); }  ///< [1/m]
};

constexpr int kPixels = 129;

double middleOf(const Bump& bump) { return 0.5 * kPixels * bump.pitch * bump.scale; }

Scene sceneOf(const Bump& bump) {
    const double pitch = bump.pitch * bump.scale;
    HeightMap map{.columns = kPixels, .rows = kPixels, .pitchX = pitch, .pitchY = pitch};
    for (int row = 0; row < kPixels; ++row) {
        for (int column = 0; column < kPixels; ++column) {
            const double away = std::hypot(column - kPixels / 2, row - kPixels / 2) * bump.pitch;
            const double ratio = away / bump.width;
            map.heights.push_back(bump.scale * bump.height * std::exp(-0.5 * ratio * ratio));
        }
    }
    SceneDescription description = test::plainScene();
    description.sample.smoothingPixels = bump.smoothing;
    description.sample.material.workOfAdhesion *= bump.scale;
    description.tip.radius = bump.scale * bump.tipRadius;
    description.choices.law = ContactLaw::Split;
    description.choices.bodyAttraction = bump.attracts;
    return buildScene(description, std::move(map));
}

TipState pressedOn(const Scene& scene, const Bump& bump) {
    const double middle = middleOf(bump);
    const double top = scene.surface.at(middle, middle).height;
    EquilibriumMemory memory;
    const BaseMotion base{.position = {middle, middle, top - 0.2_nm * bump.scale}};
    return tipEquilibrium(scene.surface, scene.belief, base, memory);
}

ValidityFlags flagsOn(const Bump& bump) {
    const Scene scene = sceneOf(bump);
    const TipState state = pressedOn(scene, bump);
    EXPECT_EQ(state.contact.branch, ContactBranch::Bonded);
    EXPECT_TRUE(state.converged);
    return asperityValidity(scene, scene.belief, state);
}

/// The bump is known before it is smoothed: by how much its effective radius is off then.
TEST(AsperityValidity, CurvatureIsUnresolvedWhereSmoothingChangesTheRadiusByATenth) {
    for (const double scale : {1.0, 0.125, 16.0}) {
        for (const double pixels : {1.5, 3.0, 4.0, 5.0, 8.0, 12.0}) {  // width of the bump
            Bump bump{.tipRadius = 100.0_nm, .pitch = 1.0_nm, .smoothing = 1.0, .scale = scale};
            bump.width = pixels * bump.pitch;
            bump.height = 0.1 * bump.width;
            const Scene scene = sceneOf(bump);
            const double seen = pressedOn(scene, bump).effectiveRadius / scale;
            const double right = bump.tipRadius / (1.0 + bump.curvature() * bump.tipRadius);
            const double off = std::abs(seen / right - 1.0);
            SCOPED_TRACE(testing::Message() << pixels << " pixels: off by " << off);
            if (off < 0.08 || off > 0.12) {
                EXPECT_EQ(flagsOn(bump).has(Validity::UnresolvedCurvature), off > 0.1);
            }
        }
    }
}

TEST(AsperityValidity, ASharpTipsOwnCurvatureOutweighsABlurredOne) {
    Bump faint{.height = 0.05_nm, .width = 2.0_nm, .tipRadius = 10.0_nm, .pitch = 1.0_nm};
    faint.smoothing = 1.0;
    EXPECT_FALSE(flagsOn(faint).has(Validity::UnresolvedCurvature));
    faint.tipRadius = 100.0_nm;
    EXPECT_TRUE(flagsOn(faint).has(Validity::UnresolvedCurvature));
}

/// How much the gap at fixed force departs from the paraboloid's, averaged over the contact as a
/// flat punch presses, relative to the paraboloid's own: 2/3 of a^2 / (2 R_eff).
double departure(const Bump& bump, double contactRadius, double effectiveRadius) {
    constexpr int kSteps = 2000;
    double sum = 0.0;
    for (int i = 0; i < kSteps; ++i) {  // r^2 = a^2 (1 - u^2), u uniform
        const double u = (i + 0.5) / kSteps;
        const double half = 0.5 * contactRadius * contactRadius * (1.0 - u * u);  // r^2/2
        const double square = half / (bump.width * bump.width);
        sum += bump.height * (std::exp(-square) - 1.0 + square) / kSteps;
    }
    return sum / (contactRadius * contactRadius / (3.0 * effectiveRadius));
}

TEST(AsperityValidity, AContactIsBeyondItsAsperityWhereThatIsNoParaboloidByATenth) {
    for (const double scale : {1.0, 8.0}) {
        const Bump bump{.height = 1.0_nm,
                        .width = 10.0_nm,
                        .tipRadius = 1.0_um,
                        .pitch = 1.0_nm,
                        .scale = scale};
        const Scene scene = sceneOf(bump);
        TipState state = pressedOn(scene, bump);
        int beyond = 0;
        for (double radius = 1.0_nm; radius < 20.0_nm; radius += 1.0_nm) {
            const double off = departure(bump, radius, state.effectiveRadius / scale);
            SCOPED_TRACE(testing::Message() << radius << " m: off by " << off);
            state.contact.contactRadius = radius * scale;
            const bool flagged =
                asperityValidity(scene, scene.belief, state).has(Validity::BeyondAsperity);
            if (off < 0.08 || off > 0.12) {
                EXPECT_EQ(flagged, off > 0.1);
            }
            beyond += flagged ? 1 : 0;
        }
        EXPECT_GT(beyond, 5);
        EXPECT_LT(beyond, 17);
    }
}

/// Attraction of the cap by plane and flanks beyond the range of cohesion, less that by the
/// paraboloid, over the pull-off force 1.5 pi w R_eff.
double shareOfBump(const Bump& bump, const TipState& state) {
    constexpr int kSteps = 100'000;
    const double step = bump.tipRadius / kSteps;
    const double touch = kContactSeparation - state.contact.indentation;
    const auto traction = [touch](double gap) {
        const double cohesive = kContactSeparation + kCohesiveRange;
        const double cube = std::pow(std::max(0.0, touch + gap), 3);
        return std::pow(kContactSeparation, 3) * cube / std::pow(cube + std::pow(cohesive, 3), 2);
    };
    double sum = 0.0;
    for (int i = 0; i < kSteps; ++i) {
        const double r = (i + 0.5) * step;
        const double ratio = r / bump.width;
        const double cap = bump.tipRadius - std::sqrt(bump.tipRadius * bump.tipRadius - r * r);
        const double below = bump.height * (1.0 - std::exp(-0.5 * ratio * ratio));
        const double ofLaw = cap + 0.5 * r * r * bump.curvature();
        sum += (traction(cap + below) - traction(ofLaw)) * r * step;
    }
    return sum * 4.0 / (1.5 * kContactSeparation * state.effectiveRadius);
}

TEST(AsperityValidity, ThePlaneUnderALowAsperityAttractsABluntTip) {
    int flagged = 0;
    for (const double height : {2.0_nm, 4.0_nm, 8.0_nm, 12.0_nm, 16.0_nm, 24.0_nm, 48.0_nm}) {
        Bump bump{.height = height, .tipRadius = 2.0_um, .pitch = 4.0_nm};
        bump.width = std::sqrt(height * 40.0_nm);  // of 40 nm radius at its top
        const Scene scene = sceneOf(bump);
        const TipState state = pressedOn(scene, bump);
        const double ratio = kContactSeparation / (kContactSeparation + height);
        const double ofPlane = 4.0 / 3.0 * bump.tipRadius / state.effectiveRadius * ratio * ratio;
        const double share = shareOfBump(bump, state);
        SCOPED_TRACE(testing::Message() << height << " m: share " << share);
        EXPECT_GT(share, 0.8 * ofPlane) << "2 pi w R (D0 / D)^2";
        const bool attracts =
            asperityValidity(scene, scene.belief, state).has(Validity::BodyAttraction);
        if (share < 0.045 || share > 0.055) {
            EXPECT_EQ(attracts, share > 0.05);
        }
        Bump inModel = bump;
        inModel.attracts = true;
        EXPECT_FALSE(flagsOn(inModel).has(Validity::BodyAttraction)) << "the force has it";
        flagged += attracts ? 1 : 0;
    }
    EXPECT_GT(flagged, 1);
    EXPECT_LT(flagged, 6);
}

/// Whether the model of a scene has the term by itself, before it is fitted.
TEST(AsperityValidity, ASceneHasTheAttractionBesideWhereItsFlagWouldBeSet) {
    Bump bump{.height = 4.0_nm, .tipRadius = 2.0_um, .pitch = 4.0_nm};
    bump.width = std::sqrt(bump.height * 40.0_nm);
    SceneDescription description = sceneOf(bump).description;
    description.choices.bodyAttraction = std::nullopt;
    const Scene scene = withDescription(sceneOf(bump), description);
    EXPECT_TRUE(scene.model.bodyAttraction);
    EXPECT_TRUE(scene.belief.beside != nullptr);
    EXPECT_TRUE(scene.truth.beside != nullptr);
    description.choices.bodyAttraction = false;
    const Scene without = withDescription(scene, description);
    EXPECT_FALSE(without.belief.beside != nullptr);
    EXPECT_TRUE(without.truth.beside != nullptr) << "the instrument has everything";
    description.choices = {.law = ContactLaw::Maugis};
    EXPECT_FALSE(withDescription(scene, description).model.bodyAttraction) << "no tail";
    const Scene flat = buildScene(test::plainScene(), test::flatMap());
    EXPECT_FALSE(flat.model.bodyAttraction);
    EXPECT_FALSE(flat.truth.beside != nullptr);
    const Scene hilly = buildScene(test::plainScene(), test::hillyMap());
    EXPECT_FALSE(hilly.truth.beside != nullptr) << "a tip sharper than the hills";
}

TEST(AsperityValidity, FlatSamplesAndExactShapesHaveNoAsperity) {
    const Scene flat = buildScene(test::plainScene(), test::flatMap());
    EquilibriumMemory memory;
    const BaseMotion base{.position = {64.0_nm, 64.0_nm, -1.0_nm}};
    const TipState state = tipEquilibrium(flat.surface, flat.belief, base, memory);
    EXPECT_EQ(asperityValidity(flat, flat.belief, state).bits(), 0U);
    SceneDescription description = test::plainScene();
    description.sample.shape = {.kind = ShapeKind::Sphere, .radius = 5.0_nm, .size = 6.0_nm};
    description.tip.radius = 1.0_um;
    const Scene ball = buildScene(description);
    EXPECT_EQ(asperityValidity(ball, ball.belief, state).bits(), 0U);
}

/// Ticks of a tip that stays on a bump, then leaves it: looked up in the first and each eighth.
TEST(AsperityValidity, OfManyTicksTheFirstAndEachEighthLookTheSurfaceUp) {
    Bump bump{.height = 0.05_nm, .width = 2.0_nm, .tipRadius = 100.0_nm, .pitch = 1.0_nm};
    bump.smoothing = 1.0;
    const Scene scene = sceneOf(bump);
    TipState state = pressedOn(scene, bump);
    const Vector3 top = state.closest.point;
    const Vector3 plane = top - Vector3(20.0_nm, 0.0, 0.0);
    ASSERT_TRUE(flagsOn(bump).has(Validity::UnresolvedCurvature));
    AsperityMemory memory;
    for (int tick = 0; tick < 24; ++tick) {
        state.closest.point = tick < 10 ? top : plane;
        const ValidityFlags flags = asperityValidity(scene, scene.belief, state, memory);
        EXPECT_EQ(flags.has(Validity::UnresolvedCurvature), tick < 16) << tick;
    }
    state.contact.branch = ContactBranch::Far;
    EXPECT_EQ(asperityValidity(scene, scene.belief, state, memory).bits(), 0U);
    EXPECT_EQ(memory, AsperityMemory{});
    state.contact.branch = ContactBranch::Bonded;
    state.closest.point = top;
    EXPECT_TRUE(
        asperityValidity(scene, scene.belief, state, memory).has(Validity::UnresolvedCurvature))
        << "a new contact";
}

}  // namespace
}  // namespace asperity
