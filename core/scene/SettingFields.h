#pragma once

#include "core/contact/Within.h"
#include "core/scene/Settings.h"

#include <limits>
#include <string_view>

namespace asperity {

/// What a number may be, both ends included.
struct Limits {
    double low = std::numeric_limits<double>::lowest();
    double high = std::numeric_limits<double>::max();  ///< infinity: it may be that, too
    const char* words = "be a finite number";          ///< after "must"

    [[nodiscard]] bool hold(double value) const noexcept {
        return value == high || isWithin(value, low, high);
    }
};

inline constexpr Limits kAboveZero{.low = std::numeric_limits<double>::denorm_min(),
                                   .words = "be a positive number"};
inline constexpr Limits kZeroOrMore{.low = 0.0, .words = "be zero or a positive number"};
inline constexpr Limits kNotNegative{.low = 0.0, .words = "not be negative"};

/// How the bar of the window shows a knob.
struct KnobWords {
    int place = 0;          ///< from the left; 0: it is not in the bar
    const char* name = "";  ///< of the widget
    const char* caption = "";
    const char* toolTip = "";
    double low = 0.0;  ///< that can be set there, > 0: its steps go by factors
    double high = 0.0;
};

/// Traits of one field of Settings.
struct SettingField {
    const char* column;  ///< in tick_input.csv; ends in its unit
    const char* key =
        column;  ///< in [haptics] of scene files; null: it is of a run, not of a scene
    Limits limits;
    KnobWords knob;
    bool later = true;  ///< recordings from before it say nothing of it: it has its default then
};

template <class Guide, class Visitor>
void listGuide(Guide& guide, const Visitor& field) {
    constexpr Limits kGain{0.0, 1e4, "lie between 0 and 1e4"};
    constexpr Limits kReach{kAboveZero.low, std::numeric_limits<double>::infinity(), "be above 0"};
    field({.column = "guide"}, guide.kind);
    field({.column = "guide_x_m"}, guide.point.x());
    field({.column = "guide_y_m"}, guide.point.y());
    field({.column = "guide_z_m"}, guide.point.z());
    field({.column = "guide_axis_x"}, guide.axis.x());
    field({.column = "guide_axis_y"}, guide.axis.y());
    field({.column = "guide_axis_z"}, guide.axis.z());
    field({.column = "guide_stiffness_n_m", .limits = kGain}, guide.stiffness);
    field({.column = "guide_damping_n_s_m", .limits = kGain}, guide.damping);
    field({.column = "guide_force_limit_n", .limits = {0.0, 50.0, "lie between 0 and 50"}},
          guide.forceLimit);
    field({.column = "guide_capture_m", .limits = kReach}, guide.captureDistance);
}

/// What is of a device, not of a scene.
template <class Knobs, class Visitor>
void listDevice(Knobs& settings, const Visitor& field) {
    auto& workspace = settings.workspace;
    field({.column = "hand_turn_x_rad", .key = nullptr}, settings.deviceTurn.x());
    field({.column = "hand_turn_y_rad", .key = nullptr}, settings.deviceTurn.y());
    field({.column = "hand_turn_z_rad", .key = nullptr}, settings.deviceTurn.z());
    field({.column = "workspace_x_m", .key = nullptr}, workspace.center.x());
    field({.column = "workspace_y_m", .key = nullptr}, workspace.center.y());
    field({.column = "workspace_z_m", .key = nullptr}, workspace.center.z());
    field({"workspace_radius_m", nullptr, kNotNegative}, workspace.radius);
    field({"workspace_free_share", nullptr, kNotNegative}, workspace.freeShare);
    field({"edge_stiffness_n_m", nullptr, kNotNegative}, workspace.stiffness);
    field({"edge_force_limit_n", nullptr, kNotNegative}, workspace.forceLimit);
}

template <class Knobs, class Visitor>
void listCoupling(Knobs& settings, const Visitor& field) {
    constexpr Limits kDamping{0.0, 1e6, "lie between 0 and 1e6"};
    field({.column = "coupling_stiffness_n_m",
           .limits = {0.0, 1e6, "lie between 0 (no coupling) and 1e6"}},
          settings.coupling.stiffness);
    field({.column = "coupling_damping_n_s_m", .limits = kDamping}, settings.coupling.damping);
    field({.column = "proxy_damping_n_s_m", .limits = kDamping}, settings.coupling.proxyDamping);
}

template <class Governor, class Visitor>
void listGovernor(Governor& governor, const Visitor& field) {
    field({.column = "max_force_n", .limits = {1e-3, 50.0, "lie between 1e-3 and 50"}},
          governor.maxForce);
    field({.column = "engage_s", .limits = {0.5, 2.0, "lie between 0.5 and 2"}},
          governor.engageTime);
    field({.column = "max_hand_speed_m_s", .limits = {0.01, 10.0, "lie between 0.01 and 10"}},
          governor.maxDeviceSpeed);
    field({.column = "dead_man_button"}, governor.deadManButton);
}

/// The one list of the knobs: scene files, tick_input.csv, checks and the window are made from it.
/// Calls `field(SettingField, value)` for each field, in the order of the columns of
/// tick_input.csv.
template <class Knobs, class Visitor>
void listSettings(Knobs& settings, const Visitor& field) {
    field({.column = "position_gain",
           .limits = kAboveZero,
           .knob = {2, "positionGain", "Position gain", "Base displacement per device displacement",
                    1e-12, 1e3},
           .later = false},
          settings.positionGain);
    field({.column = "force_gain",
           .limits = kZeroOrMore,
           .knob = {1, "forceGain", "Force gain", "Force on the device per force on the tip", 1e-3,
                    1e12},
           .later = false},
          settings.forceGain);
    field({.column = "correction_hz", .limits = kZeroOrMore, .later = false},
          settings.correctionBandwidth);
    field({.column = "tip_control", .key = "position_control", .later = false},
          settings.positionControl);
    field({.column = "forces_on", .key = nullptr, .later = false}, settings.forcesOn);
    field({.column = "rearms", .key = nullptr, .later = false}, settings.rearms);
    listCoupling(settings, field);
    listGovernor(settings.governor, field);
    field({.column = "clutched", .key = nullptr}, settings.clutched);
    field({.column = "clutch_button"}, settings.clutchButton);
    listDevice(settings, field);
    listGuide(settings.guide, field);
}

/// Turns one knob. @param column one of the list; else nothing happens
void setSetting(Settings& settings, std::string_view column, double value);

/// Refuses knobs that no scene may have. @throw Error naming the key of the first one
void checkSettings(const Settings& settings);

}  // namespace asperity
