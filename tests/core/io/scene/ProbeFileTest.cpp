#include "core/io/scene/ProbeFile.h"

#include "core/probe/CantileverModes.h"
#include "tests/support/Refusal.h"
#include "tests/support/ScratchFolder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <string>
#include <utility>

namespace asperity {
namespace {

class ProbeFile : public ::testing::Test {
protected:
    ProbeDescription read(const std::string& text) {
        return readProbe(scratch.write("probe.toml", text));
    }

    std::string refusal(const std::string& text) {
        return test::refusalOf([&] { (void)read(text); });
    }

    test::ScratchFolder scratch;
};

constexpr const char* kPlan = "length_m = 225e-6\nwidth_m = 28e-6\ntip_height_m = 14e-6\n";

TEST_F(ProbeFile, IsTheDefaultLeverWhereItSaysNothing) {
    const ProbeDescription probe = read("");
    EXPECT_NEAR(Cantilever(probe.lever).stiffness(), 14.0, 1e-12);
    EXPECT_EQ(probe.lever.qualityFactor, 100.0);
    EXPECT_EQ(probe.lever.density, 2330.0);
    EXPECT_EQ(probe.lever.setBack, 0.0);
    EXPECT_EQ(probe.detector, DetectorCalibration{});
}

TEST_F(ProbeFile, TakesThicknessFromStiffnessAtTheTip) {
    const CantileverGeometry lever =
        read(std::string(kPlan) + "stiffness_n_m = 2.8\nset_back_m = 10e-6\n").lever;
    EXPECT_NEAR(Cantilever(lever).stiffness(), 2.8, 1e-13);
    EXPECT_EQ(lever.youngsModulus, 169e9);
}

TEST_F(ProbeFile, TakesThicknessFromResonance) {
    const CantileverGeometry lever = read(std::string(kPlan) + "resonance_hz = 75e3\n").lever;
    EXPECT_NEAR(flexuralMode(lever, 1).frequency(), 75e3, 1e-8);
    EXPECT_EQ(lever.youngsModulus, 169e9);
}

TEST_F(ProbeFile, TakesThicknessAndModulusFromStiffnessAndResonance) {
    const CantileverGeometry lever =
        read(std::string(kPlan) + "stiffness_n_m = 2.8\nresonance_hz = 75e3\nset_back_m = 5e-6\n")
            .lever;
    EXPECT_NEAR(Cantilever(lever).stiffness(), 2.8, 1e-12);
    EXPECT_NEAR(flexuralMode(lever, 1).frequency(), 75e3, 1e-7);
}

TEST_F(ProbeFile, HoldsTheCalibrationOfALab) {
    const ProbeDescription probe = read(R"(
q_factor = 312
inv_ols_m_v = 55e-9
lateral_sensitivity_rad_v = -3e-4
cross_talk_vertical = 0.01
cross_talk_lateral = -0.03
)");
    EXPECT_EQ(probe.lever.qualityFactor, 312.0);
    EXPECT_EQ(probe.detector.invOls, 55e-9);
    EXPECT_EQ(probe.detector.torsionPerVolt, -3e-4);
    EXPECT_EQ(probe.detector.verticalCrossTalk, 0.01);
    EXPECT_EQ(probe.detector.lateralCrossTalk, -0.03);
}

TEST_F(ProbeFile, ComesBackTheSameFromItsOwnText) {
    const ProbeDescription probe =
        read(std::string(kPlan) + "stiffness_n_m = 2.8\nresonance_hz = 75e3\nset_back_m = "
                                  "5e-6\ninv_ols_m_v = 55e-9\nq_factor = 3\n");
    std::ostringstream text;
    text << probeTable(probe);
    const ProbeDescription again = read(text.str());
    EXPECT_EQ(again.lever, probe.lever);
    EXPECT_EQ(again.detector, probe.detector);
}

TEST_F(ProbeFile, RefusesContradictionsAndMistakesWithTheirKeys) {
    const std::pair<std::string, std::string> mistakes[] = {
        {"stiffness_n_m = 1.0\nthickness_m = 1e-6\n", "either stiffness_n_m or thickness_m"},
        {"resonance_hz = 1e5\nthickness_m = 1e-6\n", "either resonance_hz or thickness_m"},
        {"resonance_hz = 1e5\nstiffness_n_m = 1.0\nyoungs_modulus_pa = 169e9\n",
         "line 3, youngs_modulus_pa"},
        // A resonance in water: the lever would have to be as thick as it is heavy.
        {std::string(kPlan) + "stiffness_n_m = 2.8\nresonance_hz = 20e3\n", "density_kg_m3"},
        {"stiffness_n_m = 0.0\n", "line 1, stiffness_n_m"},
        {"resonance_hz = -1.0\n", "resonance_hz"},
        {"resonance_hz = nan\n", "resonance_hz"},
        {"length_m = 0\n", "length_m"},
        {"width_m = inf\n", "width_m"},
        {"density_kg_m3 = -2330\n", "density_kg_m3"},
        {"q_factor = 0\n", "q_factor"},
        {"set_back_m = 150e-6\n", "set_back_m"},
        {"set_back_m = -1e-6\n", "set_back_m"},
        {"set_back_m = nan\n", "set_back_m"},
        {"inv_ols_m_v = -1e-8\n", "line 1, inv_ols_m_v: must lie between 0 and 1"},
        {"lateral_sensitivity_rad_v = nan\n", "lateral_sensitivity_rad_v"},
        {"cross_talk_vertical = 1.0\n", "cross_talk_vertical"},
        {"cross_talk_lateral = \"none\"\n", "cross_talk_lateral"},
        {"poisson_ratio = 0.7\n", "poisson_ratio: must lie between 0 and 0.5"},
        {"mount_tilt_rad = 2\n", "mount_tilt_rad: must lie between"},
        {"inv_ols = 5e-8\n", "unknown key 'inv_ols'"},
    };
    for (const auto& [text, expected] : mistakes) {
        const std::string said = refusal(text);
        EXPECT_NE(said.find(expected), std::string::npos) << text << "said: " << said;
        EXPECT_NE(said.find("probe.toml"), std::string::npos) << said;
    }
}

}  // namespace
}  // namespace asperity
