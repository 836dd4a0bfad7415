#include "core/io/scene/DeviceFiles.h"

#include "core/contact/Within.h"
#include "core/io/scene/TomlFile.h"

#include <array>
#include <cmath>
#include <limits>

namespace asperity {

namespace {

constexpr double kMaxFigure = 1e6;      // no value of a desktop device is larger in SI units
constexpr double kMinFigure = 1e-6;     // nor smaller
constexpr double kMaxCurrent = 32.767;  // that a report can say [A]
constexpr std::array kJoints = {"joint_a", "joint_b", "joint_c"};

/// A number without which the device cannot be driven.
double required(TomlSection& section, const std::string& key, double smallest, double largest,
                const std::string& expected) {
    const double value = section.number(key, std::numeric_limits<double>::quiet_NaN());
    if (!isWithin(value, smallest, largest)) {
        section.refuse(key, expected);
    }
    return value;
}

double positive(TomlSection& section, const std::string& key) {
    return required(section, key, kMinFigure, kMaxFigure, "a number from 1e-6 to 1e6");
}

/// Reads a value that the maker may not give: 0 then.
double positiveIfKnown(TomlSection& section, const std::string& key) {
    return section.has(key) ? positive(section, key) : 0.0;
}

double whole(TomlSection& section, const std::string& key) {
    constexpr double kLow = std::numeric_limits<std::int16_t>::min();
    constexpr double kHigh = std::numeric_limits<std::int16_t>::max();
    const std::string expected = "a whole number from -32768 to 32767";
    const double value = required(section, key, kLow, kHigh, expected);
    if (value != std::round(value)) {
        section.refuse(key, expected);
    }
    return value;
}

double sign(TomlSection& section) {
    const double value = required(section, "sign", -1.0, 1.0, "1 or -1");
    if (std::abs(value) != 1.0) {
        section.refuse("sign", "1 or -1");
    }
    return value;
}

WoodenHapticsJoint readJoint(TomlSection section) {
    const WoodenHapticsJoint joint = {.length = positive(section, "length_m"),
                                      .capstanDiameter = positive(section, "capstan_diameter_m"),
                                      .bodyDiameter = positive(section, "body_diameter_m"),
                                      .sign = sign(section),
                                      .restCounts =
                                          static_cast<std::int16_t>(whole(section, "rest_counts"))};
    section.refuseUnknownKeys();
    return joint;
}

double originAlong(TomlSection& section, const std::string& key) {
    return required(section, key, -kMaxFigure, kMaxFigure, "a finite number");
}

DeviceSpecification readSpecification(TomlSection& section) {
    return {.maxForce = positive(section, "max_force_n"),
            .maxStiffness = positiveIfKnown(section, "max_stiffness_n_m"),
            .maxDamping = positiveIfKnown(section, "max_damping_n_s_m"),
            .effectiveMass = positiveIfKnown(section, "effective_mass_kg"),
            .workspaceRadius = positiveIfKnown(section, "workspace_radius_m"),
            .streams = true,
            .calibrates = true};
}

}  // namespace

WoodenHapticsDescription readWoodenHaptics(const std::filesystem::path& path) {
    const toml::table table = readToml(path);
    TomlSection root(table, path, "");
    WoodenHapticsDescription device;
    for (std::size_t i = 0; i < kJoints.size(); ++i) {
        root.allow(kJoints[i]);
        device.joints[i] = readJoint(TomlSection(table, path, kJoints[i]));
    }
    device.origin = {originAlong(root, "origin_x_m"), originAlong(root, "origin_y_m"),
                     originAlong(root, "origin_z_m")};
    device.countsPerTurn = positive(root, "counts_per_turn");
    device.motorConstant = positive(root, "motor_constant_nm_a");
    device.maxCurrent = required(root, "max_current_a", kMinFigure, kMaxCurrent,
                                 "a number up to 32.767, the maximum of a report");
    device.specification = readSpecification(root);
    root.refuseUnknownKeys();
    return device;
}

}  // namespace asperity
