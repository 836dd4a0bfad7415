#include "core/io/scene/DeviceFiles.h"
#include "tests/support/Places.h"
#include "tests/support/Refusal.h"
#include "tests/support/ScratchFolder.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

const std::filesystem::path kShipped = test::dataFolder() / "devices/woodenhaptics_2015.toml";

class WoodenHapticsFile : public ::testing::Test {
protected:
    /// Why the shipped file is refused with one text of it replaced.
    std::string refusalWith(const std::string& text, const std::string& replacement) {
        std::string content = test::contentOf(kShipped);
        const std::size_t offset = content.find(text);
        EXPECT_NE(offset, std::string::npos) << text;
        content.replace(offset, text.size(), replacement);
        const std::filesystem::path file = scratch.write("device.toml", content);
        return test::refusalOf([&] { (void)readWoodenHaptics(file); });
    }

    test::ScratchFolder scratch;
};

TEST_F(WoodenHapticsFile, OfTheDeviceOf2015IsAsItsMakerSays) {
    const WoodenHapticsDescription device = readWoodenHaptics(kShipped);
    EXPECT_EQ(device.joints[0].length, 0.080);
    EXPECT_EQ(device.joints[1].length, 0.205);
    EXPECT_EQ(device.joints[2].length, 0.245);
    EXPECT_DOUBLE_EQ(device.joints[0].reduction(), 1.0 / 16.0);
    EXPECT_DOUBLE_EQ(device.joints[1].reduction(), 1.0 / 12.0);
    EXPECT_DOUBLE_EQ(device.joints[2].reduction(), 1.0 / 12.0);
    EXPECT_EQ(device.joints[2].restCounts, 6000);
    EXPECT_EQ(device.origin, Vector3(0.22, 0.0, 0.08));
    EXPECT_EQ(device.countsPerTurn, 2000.0);
    EXPECT_EQ(device.motorConstant, 0.0259);
    EXPECT_EQ(device.maxCurrent, 2.0);
}

TEST_F(WoodenHapticsFile, SaysWhatTheDeviceRenders) {
    const DeviceSpecification specification = readWoodenHaptics(kShipped).specification;
    EXPECT_EQ(specification.maxForce, 5.0);
    EXPECT_EQ(specification.maxStiffness, 1000.0);
    EXPECT_EQ(specification.maxDamping, 8.0);
    EXPECT_EQ(specification.effectiveMass, 0.0) << "not known";
    EXPECT_EQ(specification.workspaceRadius, 0.1);
    EXPECT_TRUE(specification.streams);
}

TEST_F(WoodenHapticsFile, IsRefusedWhereItSaysWhatNobodyAskedFor) {
    EXPECT_NE(refusalWith("counts_per_turn", "cpr = 1\ncounts_per_turn").find("unknown key 'cpr'"),
              std::string::npos);
    EXPECT_NE(
        refusalWith("sign = 1", "sign = 1\ncolor = 2").find("unknown key 'color' in [joint_a]"),
        std::string::npos);
}

TEST_F(WoodenHapticsFile, IsRefusedWithoutWhatDrivesTheDevice) {
    for (const std::string key :
         {"counts_per_turn", "motor_constant_nm_a", "max_current_a", "max_force_n", "origin_y_m",
          "length_m", "capstan_diameter_m", "body_diameter_m", "sign", "rest_counts"}) {
        EXPECT_NE(refusalWith(key + " =", "#").find(key + ": expected"), std::string::npos) << key;
    }
    EXPECT_NE(refusalWith("[joint_b]", "[joint_x]").find("[joint_b] length_m: expected"),
              std::string::npos);
}

TEST_F(WoodenHapticsFile, IsRefusedWithNumbersThatNoDeviceHas) {
    const std::string length = "a number from 1e-6 to 1e6";
    EXPECT_NE(refusalWith("length_m = 0.080", "length_m = 0").find(length), std::string::npos);
    EXPECT_NE(refusalWith("length_m = 0.080", "length_m = nan").find(length), std::string::npos);
    EXPECT_NE(refusalWith("sign = 1", "sign = 0.5").find("1 or -1"), std::string::npos);
    EXPECT_NE(refusalWith("rest_counts = 0", "rest_counts = 0.5").find("a whole number"),
              std::string::npos);
    EXPECT_NE(refusalWith("rest_counts = 6000", "rest_counts = 40000").find("a whole number"),
              std::string::npos);
    EXPECT_NE(refusalWith("max_current_a = 2.0", "max_current_a = 40").find("32.767"),
              std::string::npos);
    EXPECT_NE(refusalWith("origin_x_m = 0.22", "origin_x_m = inf").find("a finite number"),
              std::string::npos);
}

}  // namespace
}  // namespace asperity
