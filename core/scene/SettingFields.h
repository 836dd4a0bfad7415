#pragma once

#include "core/EnumTable.h"
#include "core/contact/Within.h"
#include "core/scene/Settings.h"

#include <cstdint>
#include <limits>
#include <string_view>

namespace asperity {

/// Range of a number, both ends included.
struct Limits {
    double low = std::numeric_limits<double>::lowest();
    double high = std::numeric_limits<double>::max();  ///< infinity: it may be that, too
    const char* words = "be a finite number";          ///< after "must"
    bool orZero = false;                               ///< 0 is allowed as well

    [[nodiscard]] bool hold(double value) const noexcept {
        return value == high || isWithin(value, low, high) || (orZero && value == 0.0);
    }
};

inline constexpr Limits kAboveZero{.low = std::numeric_limits<double>::denorm_min(),
                                   .words = "be a positive number"};
inline constexpr Limits kZeroOrMore{.low = 0.0, .words = "be zero or a positive number"};
inline constexpr Limits kNotNegative{.low = 0.0, .words = "not be negative"};

/// Topic of a knob.
enum class SettingGroup : std::uint8_t {
    Hidden,  ///< no page shows it: it is of a run, or of a device
    Gains,
    Coupling,
    Governor,
    Clutch,
    Guide,
};

template <>
inline constexpr auto kEnumTable<SettingGroup> =
    std::to_array<NamedRow<SettingGroup>>({{SettingGroup::Hidden, ""},
                                           {SettingGroup::Gains, "Gains"},
                                           {SettingGroup::Coupling, "Coupling"},
                                           {SettingGroup::Governor, "Governor"},
                                           {SettingGroup::Clutch, "Clutch and tip control"},
                                           {SettingGroup::Guide, "Guide"}});

/// Words for a knob in the window.
struct SettingWords {
    SettingGroup group = SettingGroup::Hidden;
    const char* caption = "";
    const char* toolTip = "";
    const char* unit = "";  ///< in which it is shown
    double scale = 1.0;     ///< that unit [SI]
};

/// Properties of a knob that is also in the bar of the window.
struct KnobWords {
    int slot = 0;           ///< from the left; 0: it is not in the bar
    const char* name = "";  ///< of the widget
    double low = 0.0;       ///< that can be set there, > 0: its steps go by factors
    double high = 0.0;
};

/// Traits of one field of Settings.
struct SettingField {
    const char* column;  ///< in tick_input.csv; ends in its unit
    const char* key =
        column;  ///< in [haptics] of scene files; null: it is of a run, not of a scene
    Limits limits;
    SettingWords words;
    KnobWords knob;
    bool later = true;  ///< recordings from before it say nothing of it: it has its default then
};

template <class Guide, class Visitor>
void listGuide(Guide& guide, const Visitor& field) {
    constexpr Limits kGain{0.0, 1e4, "lie between 0 and 1e4"};
    constexpr Limits kReach{kAboveZero.low, std::numeric_limits<double>::infinity(), "be above 0"};
    constexpr SettingGroup kGroup = SettingGroup::Guide;
    const auto coordinate = [](const char* caption) {
        return SettingWords{kGroup, caption, "A point of the guide, world frame", "nm", 1e-9};
    };
    const auto axis = [](const char* caption) {
        return SettingWords{kGroup, caption, "Normal of a plane, direction of a line"};
    };
    field({.column = "guide", .words = {kGroup, "Guide", "Helps to hold a plane, line or point"}},
          guide.kind);
    field({.column = "guide_x_m", .words = coordinate("x")}, guide.point.x());
    field({.column = "guide_y_m", .words = coordinate("y")}, guide.point.y());
    field({.column = "guide_z_m", .words = coordinate("z")}, guide.point.z());
    field({.column = "guide_axis_x", .words = axis("Axis, x")}, guide.axis.x());
    field({.column = "guide_axis_y", .words = axis("Axis, y")}, guide.axis.y());
    field({.column = "guide_axis_z", .words = axis("Axis, z")}, guide.axis.z());
    field({.column = "guide_stiffness_n_m",
           .limits = kGain,
           .words = {kGroup, "Stiffness", "Its pull per device displacement", "N/m"}},
          guide.stiffness);
    field({.column = "guide_damping_n_s_m",
           .limits = kGain,
           .words = {kGroup, "Damping", "Its damping of the device", "N s/m"}},
          guide.damping);
    field({.column = "guide_force_limit_n",
           .limits = {0.0, 50.0, "lie between 0 and 50"},
           .words = {kGroup, "Force limit", "Which its force approaches smoothly", "N"}},
          guide.forceLimit);
    field({.column = "guide_capture_m",
           .limits = kReach,
           .words = {kGroup, "Capture distance", "Of the tip, beyond which it does not act", "nm",
                     1e-9}},
          guide.captureDistance);
}

/// Lists what belongs to a device, not to a scene.
template <class Knobs, class Visitor>
void listDevice(Knobs& settings, const Visitor& field) {
    auto& workspace = settings.workspace;
    field({.column = "device_turn_x_rad", .key = nullptr}, settings.deviceTurn.x());
    field({.column = "device_turn_y_rad", .key = nullptr}, settings.deviceTurn.y());
    field({.column = "device_turn_z_rad", .key = nullptr}, settings.deviceTurn.z());
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
    constexpr SettingGroup kGroup = SettingGroup::Coupling;
    field({.column = "coupling_stiffness_n_m",
           .limits = {0.0, 1e6, "lie between 0 (no coupling) and 1e6"},
           .words = {kGroup, "Stiffness", "Of the spring between device and tip; 0: no coupling",
                     "N/m"}},
          settings.coupling.stiffness);
    field({.column = "coupling_damping_n_s_m",
           .limits = kDamping,
           .words = {kGroup, "Damping", "Of the device against the proxy", "N s/m"}},
          settings.coupling.damping);
    field({.column = "proxy_damping_n_s_m",
           .limits = kDamping,
           .words = {kGroup, "Proxy damping", "Of the proxy against the ground: drag in free air",
                     "N s/m"}},
          settings.coupling.proxyDamping);
}

template <class Governor, class Visitor>
void listGovernor(Governor& governor, const Visitor& field) {
    constexpr SettingGroup kGroup = SettingGroup::Governor;
    field({.column = "max_force_n",
           .limits = {1e-3, 50.0, "lie between 1e-3 and 50"},
           .words = {kGroup, "Largest force", "On the operator; a weaker device has its own limit",
                     "N"}},
          governor.maxForce);
    field({.column = "engage_s",
           .limits = {0.5, 2.0, "lie between 0.5 and 2"},
           .words = {kGroup, "Ramp", "Time in which the force comes on", "s"}},
          governor.engageTime);
    field(
        {.column = "max_device_speed_m_s",
         .limits = {0.01, 10.0, "lie between 0.01 and 10"},
         .words = {kGroup, "Largest speed", "Of the device; above it the force trips off", "m/s"}},
        governor.maxDeviceSpeed);
    field({.column = "dead_man_button",
           .words = {kGroup, "Dead-man switch", "Button that must be held for a force, from 0"}},
          governor.deadManButton);
}

/// The one list of the knobs: scene files, tick_input.csv, checks and the window are made from it.
/// Calls `field(SettingField, value)` for each field, in the order of the columns of
/// tick_input.csv.
template <class Knobs, class Visitor>
void listSettings(Knobs& settings, const Visitor& field) {
    field({.column = "position_gain",
           .limits = kAboveZero,
           .words = {SettingGroup::Gains, "Position gain",
                     "Base displacement per device displacement"},
           .knob = {2, "positionGain", 1e-12, 1e3},
           .later = false},
          settings.positionGain);
    field({.column = "force_gain",
           .limits = kZeroOrMore,
           .words = {SettingGroup::Gains, "Force gain", "Force on the device per force on the tip"},
           .knob = {1, "forceGain", 1e-3, 1e12},
           .later = false},
          settings.forceGain);
    field({.column = "correction_hz",
           .limits = kZeroOrMore,
           .words = {SettingGroup::Gains, "Correction bandwidth",
                     "Of the slow correction of the force from the estimate", "Hz"},
           .later = false},
          settings.correctionBandwidth);
    field({.column = "tip_control",
           .key = "position_control",
           .words = {SettingGroup::Clutch, "The device moves",
                     "The base of the lever, or the tip: the base then compensates the deflection"},
           .later = false},
          settings.positionControl);
    field({.column = "forces_on", .key = nullptr, .later = false}, settings.forcesOn);
    field({.column = "rearms", .key = nullptr, .later = false}, settings.rearms);
    listCoupling(settings, field);
    listGovernor(settings.governor, field);
    field({.column = "clutched",
           .key = nullptr,
           .words = {SettingGroup::Clutch, "Clutch", "The device moves while the tip stays"}},
          settings.clutched);
    field({.column = "clutch_button",
           .words = {SettingGroup::Clutch, "Clutch button",
                     "Button that disconnects the device from the tip while held, from 0"}},
          settings.clutchButton);
    field({.column = "trial_button",
           .words = {SettingGroup::Clutch, "Trial button",
                     "Button that begins and ends a trial of a study, from 0"}},
          settings.trialButton);
    listDevice(settings, field);
    listGuide(settings.guide, field);
}

/// Turns one knob. @param column one of the list; else nothing happens
void setSetting(Settings& settings, std::string_view column, double value);

/// The knobs that a scene says, the others as they are by default: those of a run or a device.
[[nodiscard]] Settings ofScene(Settings settings);

/// Refuses a button of the device that shall do two things. @throw Error naming its key
void checkButtons(const Settings& settings);

/// Refuses knobs that no scene may have. @throw Error naming the key of the first one
void checkSettings(const Settings& settings);

}  // namespace asperity
