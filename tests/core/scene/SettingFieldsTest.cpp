#include "core/scene/SettingFields.h"

#include "core/Error.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>
#include <string>

namespace asperity {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

std::string refusalOf(const Settings& settings) {
    try {
        checkSettings(settings);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(SettingFields, EachHasNamesOfItsOwn) {
    std::set<std::string> columns;
    std::set<std::string> keys;
    int fields = 0;
    int ofScene = 0;
    const Settings any;
    listSettings(any, [&](const SettingField& field, const auto& /*value*/) {
        ++fields;
        columns.insert(field.column);
        if (field.key != nullptr) {
            ++ofScene;
            keys.insert(field.key);
        }
    });
    EXPECT_EQ(static_cast<int>(columns.size()), fields);
    EXPECT_EQ(static_cast<int>(keys.size()), ofScene);
}

TEST(SettingFields, TurnsTheOneOfAColumn) {
    Settings settings;
    setSetting(settings, "tip_control", 1.0);
    setSetting(settings, "max_force_n", 2.5);
    EXPECT_EQ(settings.positionControl, PositionControl::Tip);
    EXPECT_EQ(settings.governor.maxForce, 2.5);
    const Settings before = settings;
    setSetting(settings, "none", 1.0);
    EXPECT_EQ(settings, before);
}

TEST(SettingFields, RefusesWhatIsOutOfRangeByItsKey) {
    EXPECT_EQ(refusalOf({}), "");
    EXPECT_EQ(refusalOf({.positionGain = 0.0}),
              "[haptics]: position_gain must be a positive number");
    EXPECT_EQ(refusalOf({.forceGain = kInfinite}),
              "[haptics]: force_gain must be zero or a positive number");
    EXPECT_EQ(refusalOf({.coupling = {.stiffness = 300.0}}),
              "[haptics]: a coupling needs proxy_damping_n_s_m above 0: its proxy has no mass");
    EXPECT_EQ(refusalOf({.governor = {.maxForce = 51.0}}),
              "[haptics]: max_force_n must lie between 1e-3 and 50");
    EXPECT_EQ(refusalOf({.guide = {.point = {0.0, 2.0, 0.0}}}),
              "[haptics]: guide_x_m, guide_y_m and guide_z_m must lie between -1 and 1");
    EXPECT_EQ(refusalOf({.guide = {.axis = {0.0, 0.0, 2.0}}}),
              "[haptics]: guide_axis_x, guide_axis_y and guide_axis_z must give a direction");
    EXPECT_EQ(refusalOf({.guide = {.captureDistance = 0.0}}),
              "[haptics]: guide_capture_m must be above 0");
    EXPECT_EQ(refusalOf({.guide = {.captureDistance = kInfinite}}), "");
}

}  // namespace
}  // namespace asperity
