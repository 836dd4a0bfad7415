#include "core/words/SceneWords.h"

#include <gtest/gtest.h>

#include <string>

namespace asperity {
namespace {

std::string said(const std::string& name, const SceneValue& value) {
    for (const SceneField& field : sceneFields()) {
        if (nameOf(field) == name) {
            SceneDescription scene = defaultScene();
            field.set(scene, value);
            return changeText(field, scene);
        }
    }
    return "no such key";
}

TEST(FieldWords, NameAChangeAsAMenuShowsIt) {
    EXPECT_EQ(said("tip.radius_m", 2e-8), "Tip radius: 20 nm");
    EXPECT_EQ(said("tip.youngs_modulus_pa", 169e9), "Tip Young's modulus: 169 GPa");
    EXPECT_EQ(said("sample.level", std::string("plane,quadratic")), "Leveling: plane, quadratic");
    EXPECT_EQ(said("sample.erode", true), "Remove the imaging tip: on");
    EXPECT_EQ(said("sample.work_of_adhesion_j_m2", 0.05), "Work of adhesion: 50 mJ/m²");
    EXPECT_EQ(said("probe.inv_ols_m_v", 62e-9), "Lever InvOLS: 62 nm/V");
    EXPECT_EQ(said("probe.mount_tilt_rad", 0.20943951023931953), "Lever mount tilt: 12°");
    EXPECT_EQ(said("probe.q_factor", 190.0), "Lever Q factor: 190");
    EXPECT_EQ(said("truth.stiffness_n_m", 12.0), "True stiffness: 12 N/m");
    EXPECT_EQ(said("physics.law", std::string("jkr")), "Contact law: JKR");
    EXPECT_EQ(said("physics.law", std::string("auto")), "Contact law: automatic");
    EXPECT_EQ(said("sample.shape", std::string("sphere")), "Shape: sphere");
    EXPECT_EQ(said("fidelity.friction", std::string("off")), "Friction: off");
}

}  // namespace
}  // namespace asperity
