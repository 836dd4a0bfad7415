#include "core/Units.h"
#include "core/map/PixelCycle.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity {
namespace {

constexpr double kFlank = 20.0 * std::numbers::pi / 180.0;
constexpr double kBead = 2.5_um;
constexpr double kAside = 17.0_nm;
constexpr double kLoad = 2.0_nN;
constexpr double kStiffness = 0.1;  // [N/m]
constexpr Elastic kGel{.youngsModulus = 10e3, .poissonRatio = 0.5};

/// A groove of two flanks along y, in the middle of 128 x 32 pixels.
struct Groove {
    double pitch = 50.0_nm;
    int columns = 128;
    int rows = 32;

    [[nodiscard]] double middle() const { return 0.5 * columns * pitch; }
    [[nodiscard]] HeightMap map() const {
        HeightMap map{.columns = columns, .rows = rows, .pitchX = pitch, .pitchY = pitch};
        for (int row = 0; row < rows; ++row) {
            for (int column = 0; column < columns; ++column) {
                const double x = (column + 0.5) * pitch - middle();
                map.heights.push_back(std::abs(x) * std::tan(kFlank));
            }
        }
        return map;
    }
};

SceneDescription beadOnGel() {
    SceneDescription scene = test::plainScene();
    scene.choices.law = ContactLaw::Hertz;
    scene.tip.radius = kBead;
    scene.sample.material.elastic = kGel;
    scene.sample.material.workOfAdhesion = 0.0;
    scene.sample.material.friction = {};
    scene.truth.material = scene.sample.material;
    scene.probe.thickness = thicknessForStiffness(scene.probe, kStiffness);
    scene.truth.stiffness = kStiffness;
    return scene;
}

/// A bead between two planes, apart from the program: Hertz on each, and the lever's compliance.
struct BeadInGroove {
    double modulus;      ///< E* [Pa]
    Matrix3 compliance;  ///< of the lever [m/N]
    Vector2 center = Vector2::Zero();
    double deeper = 0.0;     ///< indentation [m]
    double shallower = 0.0;  ///< [m]
    Vector2 force = Vector2::Zero();

    /// The state of a bead with its center at (x, z) from the groove's bottom.
    void place(double x, double z) {
        center = {x, z};
        deeper = kBead - z * std::cos(kFlank) + x * std::sin(kFlank);
        shallower = kBead - z * std::cos(kFlank) - x * std::sin(kFlank);
        const double right = hertz(deeper);
        const double left = hertz(shallower);
        force = {(left - right) * std::sin(kFlank), (left + right) * std::cos(kFlank)};
    }
    [[nodiscard]] double hertz(double indentation) const {
        return 4.0 / 3.0 * modulus * std::sqrt(kBead) * std::pow(std::max(0.0, indentation), 1.5);
    }
    /// Distance of the contact points [m].
    [[nodiscard]] double apart() const {
        const double right = kBead - deeper;
        const double left = kBead - shallower;
        return std::hypot((right + left) * std::sin(kFlank), (right - left) * std::cos(kFlank));
    }
    void solve() {
        double x = kAside;
        for (int i = 0; i < 200; ++i) {
            double low = 0.0;
            double high = 2.0 * kBead;
            for (int k = 0; k < 100; ++k) {
                const double z = 0.5 * (low + high);
                place(x, z);
                (force.y() > kLoad ? low : high) = z;
            }
            const double bent = compliance(0, 0) * force.x() + compliance(0, 2) * force.y();
            x += 0.3 * (kAside + bent - x);
        }
    }
};

/// The bead sits on both flanks, one 13 nm deeper than the other: both bear.
TEST(FurtherContacts, OfABeadInAGrooveBearThoughTheyLieFarBehindTheFirst) {
    const Groove groove;
    const Scene scene = buildScene(beadOnGel(), groove.map());
    BeadInGroove exact{.modulus = scene.belief.contact.pair().reducedModulus,
                       .compliance = scene.belief.cantilever.compliance()};
    exact.solve();
    EXPECT_NEAR(exact.deeper, 119.3_nm, 0.1_nm);
    ASSERT_GT(exact.deeper - exact.shallower, 10.0_nm);

    const Vector2 position(groove.middle() + kAside, 0.5 * groove.rows * groove.pitch);
    const MapInstrument instrument(scene, false);
    VerticalPath path(instrument, position);
    const CycleStates states = runCycle(path, kLoad);
    ASSERT_TRUE(states.engaged);
    EXPECT_EQ(states.engaged->atSetpoint.state.points, 2);
    const MapValues values = valuesOf(states, path);
    // What the spline through the pixels makes of the groove's bottom and flanks.
    constexpr double kFit = 2e-3;
    EXPECT_NEAR(values[MapQuantity::Indentation], exact.deeper, kFit * exact.deeper);
    EXPECT_NEAR(values[MapQuantity::LateralForce], std::abs(exact.force.x()), 0.02 * 0.065_nN);
    EXPECT_NEAR(values[MapQuantity::Height], 40.6_nm, 0.3_nm);
}

/// 2 nN on two flanks 1.6 um apart lower the shallower contact by a sixth: that is said.
TEST(FurtherContacts, OfABeadInAGrooveSayThatTheyInteract) {
    const Groove groove;
    const Scene scene = buildScene(beadOnGel(), groove.map());
    const MapInstrument instrument(scene, false);
    VerticalPath path(instrument, {groove.middle() + kAside, 0.5 * groove.rows * groove.pitch});
    const CycleStates states = runCycle(path, kLoad);
    ASSERT_TRUE(states.engaged);
    const TipState& state = states.engaged->atSetpoint.state;
    EXPECT_FALSE(state.overlapping);
    BeadInGroove exact{.modulus = scene.belief.contact.pair().reducedModulus,
                       .compliance = scene.belief.cantilever.compliance()};
    exact.solve();
    const double sunk =
        exact.hertz(exact.deeper) / (std::numbers::pi * exact.modulus * exact.apart());
    EXPECT_NEAR(state.interaction, sunk / exact.shallower, 0.01 * state.interaction);
    const ValidityFlags flags = instrument.validity(state);
    EXPECT_TRUE(flags.has(Validity::InteractingContacts));
    EXPECT_FALSE(flags.has(Validity::OverlappingContacts));
}

/// The default scene without adhesion and friction, on 96 x 96 pixels of 1 nm.
template <class Height>
Scene elasticScene(double youngsModulus, const Height& height) {
    constexpr int kPixels = 96;
    HeightMap map{.columns = kPixels, .rows = kPixels, .pitchX = 1.0_nm, .pitchY = 1.0_nm};
    for (int row = 0; row < kPixels; ++row) {
        for (int column = 0; column < kPixels; ++column) {
            map.heights.push_back(height((column + 0.5 - kPixels / 2.0) * 1.0_nm,
                                         (kPixels / 2.0 - row - 0.5) * 1.0_nm));
        }
    }
    SceneDescription description = test::plainScene();
    description.choices.law = ContactLaw::Hertz;
    description.sample.material.elastic.youngsModulus = youngsModulus;
    description.sample.material.workOfAdhesion = 0.0;
    description.sample.material.friction = {};
    return buildScene(description, map);
}

/// The tip with its undeflected apex in the middle at a height [m].
TipState stateAt(const Scene& scene, double height) {
    EquilibriumMemory memory;
    return tipEquilibrium(scene.believedSurface(), scene.belief,
                          {.position = {48.0_nm, 48.0_nm, height}}, memory);
}

ValidityFlags flagsOf(const Scene& scene, const TipState& state) {
    return MapInstrument(scene, false).validity(state);
}

/// Bumps 5 nm apart under a contact that is far wider than they are: no sum of single ones.
TEST(FurtherContacts, WhoseCirclesOverlapSaySo) {
    const auto bumps = [](double x, double y) {
        constexpr double kWave = 2.0 * std::numbers::pi / 5.0_nm;
        return 0.6_nm * std::cos(kWave * x) * std::cos(kWave * y);
    };
    const Scene soft = elasticScene(20e6, bumps);
    const TipState wide = stateAt(soft, -4.0_nm);
    EXPECT_GT(wide.points, 1);
    EXPECT_TRUE(wide.overlapping);
    EXPECT_TRUE(flagsOf(soft, wide).has(Validity::OverlappingContacts));
    const TipState touching = stateAt(soft, 0.55_nm);
    EXPECT_GT(touching.contact.contactRadius, 0.0);
    EXPECT_FALSE(touching.overlapping);
    EXPECT_FALSE(flagsOf(soft, touching).has(Validity::OverlappingContacts));
}

/// Six crests around the tip: the forces of four are summed, and that there are more is said.
TEST(FurtherContacts, OfWhichThereAreMoreThanAreSummedSaySo) {
    for (const int crests : {4, 6}) {
        const Scene scene = elasticScene(2e9, [&](double x, double y) {
            const double across = std::hypot(x, y);
            return 20.0_nm * std::pow(across / 20.0_nm, 2) *
                   (1.0 + 0.15 * std::cos(crests * (std::atan2(y, x) + 0.1)));
        });
        const TipState state = stateAt(scene, 0.0);
        EXPECT_EQ(state.points, 4);
        EXPECT_EQ(flagsOf(scene, state).has(Validity::SearchNotExhaustive), crests > 4) << crests;
    }
}

}  // namespace
}  // namespace asperity
