#include "core/io/scene/SceneFile.h"
#include "core/io/scene/SceneKeys.h"
#include "tests/support/Refusal.h"
#include "tests/support/ScratchFolder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace asperity {
namespace {

using testing::HasSubstr;

const std::string kModulus = "youngs_modulus_map = { file = \"maps.gwy\", channel = \"E\" }\n";
const std::string kMask =
    "material_mask = { file = \"mask.gsf\", zero = \"hard.toml\", one = { youngs_modulus_pa = 2e6, "
    "work_of_adhesion_j_m2 = 0.02, friction_coefficient = 0.8 } }\n";

class MaterialMapKeys : public testing::Test {
protected:
    SceneDescription read(const std::string& sample, const std::string& rest = "") {
        (void)scratch.write("hard.toml", "youngs_modulus_pa = 7e10\nwork_of_adhesion_j_m2 = 0.1\n"
                                         "friction_coefficient = 0.2\n");
        return readScene(
            scratch.write("scene.toml", "[sample]\nfile = \"map.gsf\"\n" + sample + rest));
    }
    std::string refusal(const std::string& sample, const std::string& rest = "") {
        return test::refusalOf([&] { (void)read(sample, rest); });
    }
    SceneDescription readBack(const SceneDescription& scene) {
        return readScene(scratch.write("back.toml", sceneText(scene)));
    }

    test::ScratchFolder scratch;
};

TEST_F(MaterialMapKeys, NameFilesBesideTheSceneAndHoldForTheTruth) {
    const SceneDescription scene = read(kModulus);
    ASSERT_TRUE(scene.sample.material.maps.youngsModulus);
    EXPECT_EQ(scene.sample.material.maps.youngsModulus->file, scratch.file("maps.gwy").string());
    EXPECT_EQ(scene.sample.material.maps.youngsModulus->channel, "E");
    EXPECT_EQ(scene.truth.material, scene.sample.material);
    EXPECT_EQ(readBack(scene), scene);
}

TEST_F(MaterialMapKeys, AMaskHasMaterialsFromFilesOrInNumbers) {
    const SceneDescription scene = read(kMask);
    ASSERT_TRUE(scene.sample.material.maps.mask);
    const MaterialMask& mask = *scene.sample.material.maps.mask;
    EXPECT_EQ(mask.zero, (MaskedMaterial{7e10, 0.1, 0.2}));
    EXPECT_EQ(mask.one, (MaskedMaterial{2e6, 0.02, 0.8}));
    EXPECT_EQ(readBack(scene), scene);
}

TEST_F(MaterialMapKeys, TheTruthIsTheSameEverywhereInWhatItSaysInANumber) {
    const std::string both =
        kModulus + "friction_map = { file = \"maps.gwy\", channel = \"mu\" }\n";
    const SceneDescription scene = read(both, "[truth]\nyoungs_modulus_pa = 3e9\n");
    EXPECT_FALSE(scene.truth.material.maps.youngsModulus);
    EXPECT_TRUE(scene.truth.material.maps.friction);
    EXPECT_EQ(readBack(scene), scene);
    const SceneDescription uniform =
        read(kMask, "[truth]\nyoungs_modulus_pa = 1e9\nwork_of_adhesion_j_m2 = 0.05\n"
                    "friction_coefficient = 0\n");
    EXPECT_FALSE(uniform.truth.material.maps.any());
    EXPECT_EQ(readBack(uniform), uniform);
    const SceneDescription varied =
        read("", "[truth]\nwork_of_adhesion_map = { file = \"maps.gwy\" }\n");
    EXPECT_FALSE(varied.sample.material.maps.any());
    EXPECT_TRUE(varied.truth.material.maps.workOfAdhesion);
    EXPECT_EQ(readBack(varied), varied);
}

TEST_F(MaterialMapKeys, AMaskedMaterialIsAsStiffAsItsFileSays) {
    (void)scratch.write("other.toml", "youngs_modulus_pa = 7e10\npoisson_ratio = 0.2\n");
    const SceneDescription scene =
        read("poisson_ratio = 0.5\nmaterial_mask = { file = \"mask.gsf\", zero = \"other.toml\", "
             "one = \"hard.toml\" }\n");
    const MaskedMaterial& zero = scene.sample.material.maps.mask->zero;
    EXPECT_NEAR(zero.youngsModulus / (1.0 - 0.25), 7e10 / (1.0 - 0.04), 1.0);
}

/// The yield of polystyrene says nothing of the particles on it.
TEST_F(MaterialMapKeys, SeveralMaterialsHaveNoHardnessUnlessItIsSaid) {
    EXPECT_EQ(read(kMask).sample.material.hardness, 0.0);
    EXPECT_EQ(read(kModulus).sample.material.hardness, 0.0);
    EXPECT_EQ(read(kModulus + "hardness_pa = 1e9\n").sample.material.hardness, 1e9);
}

TEST_F(MaterialMapKeys, RefuseMistakes) {
    EXPECT_THAT(refusal(kMask, "[truth]\nfriction_coefficient = 0\n"),
                HasSubstr("a mask of its own"));
    EXPECT_THAT(refusal(kModulus + kMask), HasSubstr("not both"));
    EXPECT_THAT(refusal("youngs_modulus_map = \"maps.gwy\"\n"), HasSubstr("a table in braces"));
    EXPECT_THAT(refusal("youngs_modulus_map = { channel = \"E\" }\n"),
                HasSubstr("the path of a file with the map"));
    EXPECT_THAT(refusal("youngs_modulus_map = { file = \"a\", unit = \"Pa\" }\n"),
                HasSubstr("unknown key 'unit' in [sample.youngs_modulus_map]"));
    EXPECT_THAT(refusal("material_mask = { file = \"a\", zero = \"hard.toml\" }\n"),
                HasSubstr("[sample.material_mask] one: expected a material file"));
    EXPECT_THAT(refusal("material_mask = { file = \"a\", zero = \"hard.toml\", one = { "
                        "youngs_modulus_pa = 0, work_of_adhesion_j_m2 = 0, friction_coefficient = "
                        "0 } }\n"),
                HasSubstr("[sample.material_mask.one] youngs_modulus_pa: must lie between"));
    EXPECT_THAT(refusal(kModulus + "film_thickness_m = 1e-7\n"), HasSubstr("must be 0 where"));
}

}  // namespace
}  // namespace asperity
