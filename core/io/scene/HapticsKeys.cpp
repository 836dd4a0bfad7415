#include "core/io/scene/HapticsKeys.h"

#include "core/io/scene/NamedChoice.h"

#include <cmath>
#include <limits>

namespace asperity {

namespace {

constexpr const char* kDeadManKey = "dead_man_button";
constexpr const char* kClutchKey = "clutch_button";

/// Here and not with the other ranges: a description holds whole numbers only.
int readButton(TomlSection& section, const char* key, int otherwise) {
    const double button = section.number(key, otherwise);
    if (!(button >= kNoButton && button <= kLastButton) || button != std::floor(button)) {
        section.refuse(key, "a whole number from 0 to 31, or -1 for none");
    }
    return static_cast<int>(button);
}

GovernorLimits readGovernor(TomlSection& section, const GovernorLimits& otherwise) {
    return {.maxForce = section.number("max_force_n", otherwise.maxForce),
            .engageTime = section.number("engage_s", otherwise.engageTime),
            .maxHandSpeed = section.number("max_hand_speed_m_s", otherwise.maxHandSpeed),
            .deadManButton = readButton(section, kDeadManKey, otherwise.deadManButton)};
}

/// A direction of any length; one of unit length keeps its bits.
Vector3 readAxis(TomlSection& section, const Vector3& otherwise) {
    const Vector3 axis(section.number("guide_axis_x", otherwise.x()),
                       section.number("guide_axis_y", otherwise.y()),
                       section.number("guide_axis_z", otherwise.z()));
    const double length = axis.stableNorm();
    if (!(length > 0.0 && std::isfinite(length))) {
        section.refuse("guide_axis_z", "with guide_axis_x and guide_axis_y a direction, not 0");
    }
    const bool isUnit = std::abs(length - 1.0) <= 4.0 * std::numeric_limits<double>::epsilon();
    return isUnit ? axis : Vector3(axis / length);
}

VirtualFixture readGuide(TomlSection& section, const VirtualFixture& otherwise) {
    return {.kind = choice(section, "guide", otherwise.kind),
            .point = {section.number("guide_x_m", otherwise.point.x()),
                      section.number("guide_y_m", otherwise.point.y()),
                      section.number("guide_z_m", otherwise.point.z())},
            .axis = readAxis(section, otherwise.axis),
            .stiffness = section.number("guide_stiffness_n_m", otherwise.stiffness),
            .damping = section.number("guide_damping_n_s_m", otherwise.damping),
            .forceLimit = section.number("guide_force_limit_n", otherwise.forceLimit),
            .captureDistance = section.number("guide_capture_m", otherwise.captureDistance)};
}

void insertGuide(toml::table& table, const VirtualFixture& guide) {
    table.insert("guide", keyOf(guide.kind));
    table.insert("guide_x_m", guide.point.x());
    table.insert("guide_y_m", guide.point.y());
    table.insert("guide_z_m", guide.point.z());
    table.insert("guide_axis_x", guide.axis.x());
    table.insert("guide_axis_y", guide.axis.y());
    table.insert("guide_axis_z", guide.axis.z());
    table.insert("guide_stiffness_n_m", guide.stiffness);
    table.insert("guide_damping_n_s_m", guide.damping);
    table.insert("guide_force_limit_n", guide.forceLimit);
    table.insert("guide_capture_m", guide.captureDistance);
}

}  // namespace

void readHaptics(TomlSection section, SceneDescription& scene) {
    scene.tickRate = section.number("rate_hz", scene.tickRate);
    scene.positionGain = section.number("position_gain", scene.positionGain);
    scene.forceGain = section.number("force_gain", scene.forceGain);
    scene.correctionBandwidth = section.number("correction_hz", scene.correctionBandwidth);
    scene.positionControl = choice(section, "position_control", scene.positionControl);
    CouplingGains& coupling = scene.coupling;
    coupling.stiffness = section.number("coupling_stiffness_n_m", coupling.stiffness);
    coupling.damping = section.number("coupling_damping_n_s_m", coupling.damping);
    coupling.proxyDamping = section.number("proxy_damping_n_s_m", coupling.proxyDamping);
    scene.governor = readGovernor(section, scene.governor);
    scene.clutchButton = readButton(section, kClutchKey, scene.clutchButton);
    scene.guide = readGuide(section, scene.guide);
    section.refuseUnknownKeys();
}

toml::table hapticsTable(const SceneDescription& scene) {
    toml::table table{{"rate_hz", scene.tickRate},
                      {"position_gain", scene.positionGain},
                      {"force_gain", scene.forceGain},
                      {"correction_hz", scene.correctionBandwidth},
                      {"position_control", keyOf(scene.positionControl)},
                      {"coupling_stiffness_n_m", scene.coupling.stiffness},
                      {"coupling_damping_n_s_m", scene.coupling.damping},
                      {"proxy_damping_n_s_m", scene.coupling.proxyDamping},
                      {"max_force_n", scene.governor.maxForce},
                      {"engage_s", scene.governor.engageTime},
                      {"max_hand_speed_m_s", scene.governor.maxHandSpeed},
                      {kDeadManKey, scene.governor.deadManButton},
                      {kClutchKey, scene.clutchButton}};
    insertGuide(table, scene.guide);
    return table;
}

}  // namespace asperity
