#include "core/scene/SampleMaterials.h"

#include "core/Error.h"
#include "core/probe/TipEquilibrium.h"
#include "core/scene/Scene.h"
#include "core/scene/TipValidity.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <memory>
#include <utility>

namespace asperity {
namespace {

constexpr double kHardModulus = 4e9;
constexpr double kSoftModulus = 0.5e9;

/// The left half of a scan of this size has one value, the right half the other, with one column of
/// pixels between.
std::shared_ptr<const PixelField> halves(const HeightMap& scan, double left, double right) {
    HeightMap map = scan;
    for (int row = 0; row < map.rows; ++row) {
        for (int column = 0; column < map.columns; ++column) {
            map.heights[map.index(row, column)] = 2 * column < map.columns ? left : right;
        }
    }
    return std::make_shared<const PixelField>(map, "");
}

SceneDescription mappedDescription() {
    SceneDescription description = test::plainScene();
    description.choices.law = ContactLaw::Maugis;  // of all its materials
    const MapSource any{.file = "maps.gwy", .channel = "", .sha256 = ""};
    description.sample.material.maps = {
        .youngsModulus = any, .workOfAdhesion = any, .friction = any, .mask = std::nullopt};
    description.truth.material = description.sample.material;
    return description;
}

SceneMaps mapsOver(const HeightMap& scan) {
    const MaterialMaps maps{.youngsModulus = halves(scan, kHardModulus, kSoftModulus),
                            .workOfAdhesion = halves(scan, 0.02, 0.08),
                            .friction = halves(scan, 0.1, 0.6)};
    return {.sample = maps, .truth = maps};
}

Scene uniformScene(const HeightMap& scan, double modulus, double adhesion, double friction) {
    SceneDescription description = test::plainScene();
    description.choices.law = ContactLaw::Maugis;
    description.sample.material.elastic.youngsModulus = modulus;
    description.sample.material.workOfAdhesion = adhesion;
    description.sample.material.friction.coefficient = friction;
    description.truth.material = description.sample.material;
    return buildScene(description, scan);
}

/// A tip pressed 1 nm deep and drawn along x.
TipState pressed(const Scene& scene, double x) {
    EquilibriumMemory memory;
    return tipEquilibrium(scene.believedSurface(), scene.belief,
                          {.position = {x, 64e-9, -1e-9}, .velocity = {1e-6, 0.0, 0.0}}, memory);
}

void expectSame(const TipState& state, const TipState& expected) {
    const double size = expected.force.norm();
    EXPECT_NEAR((state.force - expected.force).norm(), 0.0, 1e-6 * size);  // maps hold floats
    EXPECT_NEAR(state.contact.contactRadius, expected.contact.contactRadius,
                1e-6 * expected.contact.contactRadius);
    EXPECT_TRUE(state.converged);
}

TEST(SampleMaterials, ATipMeetsTheMaterialOfItsPlace) {
    const HeightMap scan = test::flatMap();
    const Scene scene = buildScene(mappedDescription(), scan, nullptr, mapsOver(scan));
    expectSame(pressed(scene, 30e-9), pressed(uniformScene(scan, kHardModulus, 0.02, 0.1), 30e-9));
    expectSame(pressed(scene, 98e-9), pressed(uniformScene(scan, kSoftModulus, 0.08, 0.6), 98e-9));
}

TEST(SampleMaterials, TheNumbersStandForTheStiffestAndMostAdhesivePart) {
    const HeightMap scan = test::flatMap();
    const Scene scene = buildScene(mappedDescription(), scan, nullptr, mapsOver(scan));
    const SampleMaterial& material = scene.description.sample.material;
    EXPECT_EQ(material.elastic.youngsModulus, kHardModulus);
    EXPECT_NEAR(material.workOfAdhesion, 0.08, 1e-8);
    EXPECT_NEAR(material.friction.coefficient, 0.6, 1e-7);
    EXPECT_EQ(scene.belief.contact.pair().workOfAdhesion, material.workOfAdhesion);
}

TEST(SampleMaterials, TheSoftestPartLetsTheTipGoLast) {
    const HeightMap scan = test::flatMap();
    const Scene scene = buildScene(mappedDescription(), scan, nullptr, mapsOver(scan));
    const ContactModel softest = softestContact(scene.belief);
    EXPECT_EQ(softest.pair().workOfAdhesion, scene.belief.contact.pair().workOfAdhesion);
    EXPECT_LT(softest.pullOffApproach(0.07), scene.belief.contact.pullOffApproach(0.07));
}

TEST(SampleMaterials, StayWithAnotherTipAndModelAndGoWithAnotherMaterial) {
    const HeightMap scan = test::flatMap();
    Scene scene = buildScene(mappedDescription(), scan, nullptr, mapsOver(scan));
    SceneDescription sharper = scene.description;
    sharper.tip.radius = 10e-9;
    EXPECT_NE(withDescription(scene, sharper).truth.field, nullptr);
    ForceModelOptions frictionless = scene.model;
    frictionless.friction = false;
    setModel(scene, frictionless);
    ASSERT_NE(scene.belief.field, nullptr);
    EXPECT_EQ(scene.belief.frictionAt({30e-9, 64e-9, 0.0}).coefficient, 0.0);
    const Scene other = withMaterial(scene, test::plainScene().sample.material);
    EXPECT_EQ(other.belief.field, nullptr);
    EXPECT_EQ(other.truth.field, nullptr);
}

TEST(SampleMaterials, AreFlaggedWhereTheyChangeWithinTheContact) {
    const HeightMap scan = test::flatMap();
    const Scene scene = buildScene(mappedDescription(), scan, nullptr, mapsOver(scan));
    const auto varies = [&scene](double x) {
        return tipValidity(scene, scene.belief, scene.description.sample.material,
                           pressed(scene, x))
            .has(Validity::VariedMaterial);
    };
    EXPECT_FALSE(varies(30e-9));
    EXPECT_TRUE(varies(64e-9));
}

TEST(SampleMaterials, ThatWereNotReadAreRefused) {
    EXPECT_THROW((void)buildScene(mappedDescription(), test::flatMap()), Error);
}

TEST(SampleMaterials, AFilmHasOneModulus) {
    const HeightMap scan = test::flatMap();
    SceneDescription description = mappedDescription();
    description.sample.material.filmThickness = 100e-9;
    EXPECT_THROW((void)buildScene(description, scan, nullptr, mapsOver(scan)), Error);
}

}  // namespace
}  // namespace asperity
