#include "core/io/scene/ProbeFile.h"

#include "core/Error.h"
#include "core/contact/Within.h"
#include "core/io/TextValue.h"
#include "core/probe/CantileverModes.h"
#include "core/scene/SceneDescription.h"

#include <limits>

namespace asperity {

namespace {

constexpr double kMinBeamModulus = 1e9;   // Young's modulus of soft plastics [Pa]
constexpr double kMaxBeamModulus = 2e12;  // twice that of diamond [Pa]

double positive(TomlSection& section, const std::string& key, double otherwise) {
    const double value = section.number(key, otherwise);
    if (!isWithin(value, std::numeric_limits<double>::min(), std::numeric_limits<double>::max())) {
        section.refuse(key, "a finite, positive number");
    }
    return value;
}

/// A known length and width leave thickness and modulus open: two of modulus, thickness, stiffness
/// and resonance settle them.
void refuseContradictions(const TomlSection& section) {
    const bool stiffness = section.has("stiffness_n_m");
    const bool resonance = section.has("resonance_hz");
    if (stiffness && section.has("thickness_m")) {
        section.refuse("stiffness_n_m", "either stiffness_n_m or thickness_m, not both");
    }
    if (resonance && section.has("thickness_m")) {
        section.refuse("resonance_hz", "either resonance_hz or thickness_m, not both");
    }
    if (stiffness && resonance && section.has("youngs_modulus_pa")) {
        section.refuse("youngs_modulus_pa",
                       "no youngs_modulus_pa beside stiffness_n_m and resonance_hz, from which "
                       "it follows");
    }
}

/// Thickness, and with both measured the modulus, from what a lab measures in place of them.
void fitToMeasurement(TomlSection& section, CantileverGeometry& lever) {
    const bool stiffnessKnown = section.has("stiffness_n_m");
    const bool resonanceKnown = section.has("resonance_hz");
    const double stiffness = positive(section, "stiffness_n_m", 1.0);
    const double resonance = positive(section, "resonance_hz", 1.0);
    if (stiffnessKnown && resonanceKnown) {
        lever = withStiffnessAndResonance(lever, stiffness, resonance);
    } else if (stiffnessKnown) {
        lever.thickness = thicknessForStiffness(lever, stiffness);
    } else if (resonanceKnown) {
        lever.thickness = thicknessForResonance(lever, resonance);
    }
    if (stiffnessKnown && resonanceKnown &&
        !isWithin(lever.youngsModulus, kMinBeamModulus, kMaxBeamModulus)) {
        section.refuse("resonance_hz",
                       "a resonance in air that fits stiffness_n_m, length_m, width_m and "
                       "density_kg_m3: together they make Young's modulus " +
                           exactText(lever.youngsModulus) + " Pa");
    }
}

CantileverGeometry readLever(TomlSection& section, const CantileverGeometry& otherwise) {
    refuseContradictions(section);
    CantileverGeometry lever = otherwise;
    lever.youngsModulus = positive(section, "youngs_modulus_pa", otherwise.youngsModulus);
    lever.poissonRatio = section.number("poisson_ratio", otherwise.poissonRatio);
    lever.density = positive(section, "density_kg_m3", otherwise.density);
    lever.length = positive(section, "length_m", otherwise.length);
    lever.width = positive(section, "width_m", otherwise.width);
    lever.thickness = positive(section, "thickness_m", otherwise.thickness);
    lever.tipHeight = positive(section, "tip_height_m", otherwise.tipHeight);
    lever.setBack = section.number("set_back_m", otherwise.setBack);
    if (!isWithin(lever.setBack, 0.0, lever.length) || lever.loadPoint() <= 0.0) {
        section.refuse("set_back_m", "zero or more, and less than length_m");
    }
    lever.mountTilt = section.number("mount_tilt_rad", otherwise.mountTilt);
    lever.azimuth = section.number("azimuth_rad", otherwise.azimuth);
    lever.qualityFactor = positive(section, "q_factor", otherwise.qualityFactor);
    fitToMeasurement(section, lever);
    return lever;
}

double crossTalk(TomlSection& section, const std::string& key, double otherwise) {
    const double value = section.number(key, otherwise);
    if (!isWithin(value, -0.9, 0.9)) {
        section.refuse(key,
                       "a number from -0.9 to 0.9, volts in this signal per volt of the other");
    }
    return value;
}

DetectorCalibration readDetector(TomlSection& section, const DetectorCalibration& otherwise) {
    DetectorCalibration detector = otherwise;
    if (section.has("inv_ols_m_v")) {
        detector.invOls = positive(section, "inv_ols_m_v", 0.0);
    }
    section.allow("inv_ols_m_v");
    if (section.has("lateral_sensitivity_rad_v")) {
        const double value = section.number("lateral_sensitivity_rad_v", 0.0);
        if (!isWithin(value, -1e6, 1e6) || value == 0.0) {
            section.refuse("lateral_sensitivity_rad_v", "a number other than zero, in rad/V");
        }
        detector.torsionPerVolt = value;
    }
    section.allow("lateral_sensitivity_rad_v");
    detector.verticalCrossTalk =
        crossTalk(section, "cross_talk_vertical", otherwise.verticalCrossTalk);
    detector.lateralCrossTalk =
        crossTalk(section, "cross_talk_lateral", otherwise.lateralCrossTalk);
    return detector;
}

}  // namespace

ProbeDescription readProbeKeys(TomlSection& section, const ProbeDescription& otherwise) {
    return {readLever(section, otherwise.lever), readDetector(section, otherwise.detector)};
}

ProbeDescription readProbe(const std::filesystem::path& path) {
    const toml::table table = readToml(path);
    TomlSection root(table, path, "");
    const ProbeDescription probe = readProbeKeys(root, {defaultScene().probe, {}});
    root.refuseUnknownKeys();
    try {
        (void)Cantilever(probe.lever);
    } catch (const Error& error) {
        throw InputError(path.string(), "", error.what());
    }
    return probe;
}

std::string probeText(const ProbeDescription& probe, const std::string& notes) {
    return commented(probeTable(probe), notes);
}

toml::table probeTable(const ProbeDescription& probe) {
    const CantileverGeometry& lever = probe.lever;
    toml::table table{{"youngs_modulus_pa", lever.youngsModulus},
                      {"poisson_ratio", lever.poissonRatio},
                      {"density_kg_m3", lever.density},
                      {"length_m", lever.length},
                      {"width_m", lever.width},
                      {"thickness_m", lever.thickness},
                      {"tip_height_m", lever.tipHeight},
                      {"set_back_m", lever.setBack},
                      {"mount_tilt_rad", lever.mountTilt},
                      {"azimuth_rad", lever.azimuth},
                      {"q_factor", lever.qualityFactor},
                      {"cross_talk_vertical", probe.detector.verticalCrossTalk},
                      {"cross_talk_lateral", probe.detector.lateralCrossTalk}};
    if (probe.detector.invOls) {
        table.insert("inv_ols_m_v", *probe.detector.invOls);
    }
    if (probe.detector.torsionPerVolt) {
        table.insert("lateral_sensitivity_rad_v", *probe.detector.torsionPerVolt);
    }
    return table;
}

}  // namespace asperity
