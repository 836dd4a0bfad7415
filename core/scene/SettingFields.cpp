#include "core/scene/SettingFields.h"

#include "core/Error.h"

#include <string>
#include <type_traits>

namespace asperity {

namespace {

void require(bool holds, const std::string& key, const std::string& words) {
    if (!holds) {
        throw Error("[haptics]: " + key + " " + words);
    }
}

/// Checks conditions on several fields together.
void checkTogether(const Settings& settings) {
    constexpr double kMaxLength = 1.0;  // [m]
    const VirtualFixture& guide = settings.guide;
    require(!settings.coupling.couples() || settings.coupling.proxyDamping > 0.0, "a coupling",
            "needs proxy_damping_n_s_m above 0: its proxy has no mass");
    require(guide.point.cwiseAbs().maxCoeff() <= kMaxLength, "guide_x_m, guide_y_m and guide_z_m",
            "must lie between -1 and 1");
    require(isWithin(guide.axis.norm(), 1.0 - 1e-9, 1.0 + 1e-9),
            "guide_axis_x, guide_axis_y and guide_axis_z", "must give a direction");
}

}  // namespace

void checkButtons(const Settings& settings) {
    const int button = settings.trialButton;
    require(button == kNoButton || button != settings.governor.deadManButton, "trial_button",
            "must be another one than dead_man_button");
    require(button == kNoButton || button != settings.clutchButton, "trial_button",
            "must be another one than clutch_button");
}

void setSetting(Settings& settings, std::string_view column, double value) {
    listSettings(settings, [&](const SettingField& field, auto& knob) {
        if (field.column == column) {
            knob = static_cast<std::decay_t<decltype(knob)>>(value);
        }
    });
}

Settings ofScene(Settings settings) {
    Settings scene;
    listSettings(settings, [&scene](const SettingField& field, const auto& value) {
        listSettings(scene, [&](const SettingField& other, auto& kept) {
            if constexpr (std::is_same_v<std::decay_t<decltype(kept)>,
                                         std::decay_t<decltype(value)>>) {
                if (field.key != nullptr && field.column == other.column) {
                    kept = value;
                }
            }
        });
    });
    return scene;
}

void checkSettings(const Settings& settings) {
    listSettings(settings, [](const SettingField& field, const auto& value) {
        if (field.key != nullptr) {
            require(field.limits.hold(static_cast<double>(value)), field.key,
                    std::string("must ") + field.limits.words);
        }
    });
    checkButtons(settings);
    checkTogether(settings);
}

}  // namespace asperity
