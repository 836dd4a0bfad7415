#include "core/io/scene/ProbeFile.h"

#include "core/Error.h"
#include "core/contact/Within.h"
#include "core/io/TextValue.h"
#include "core/io/scene/SceneKeys.h"
#include "core/probe/CantileverModes.h"

namespace asperity {

namespace {

constexpr double kMinBeamModulus = 1e9;   // Young's modulus of soft plastics [Pa]
constexpr double kMaxBeamModulus = 2e12;  // twice that of diamond [Pa]

bool isOfProbeFile(const SceneField& field) {
    return field.group == SceneGroup::Probe && !field.ownForm &&
           field.key != std::string(kSignalNoise);
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
    const double stiffness =
        readNumber(section, sceneField(SceneGroup::Probe, "stiffness_n_m"), 1.0);
    const double resonance =
        readNumber(section, sceneField(SceneGroup::Probe, "resonance_hz"), 1.0);
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

}  // namespace

void readProbeKeys(TomlSection& section, SceneDescription& scene) {
    refuseContradictions(section);
    for (const SceneField& field : sceneFields()) {
        if (isOfProbeFile(field)) {
            readKey(section, field, scene);
        }
    }
    const CantileverGeometry& lever = scene.probe;
    if (!isWithin(lever.setBack, 0.0, lever.length) || lever.loadPoint() <= 0.0) {
        section.refuse("set_back_m", "zero or more, and less than length_m");
    }
    fitToMeasurement(section, scene.probe);
}

ProbeDescription readProbe(const std::filesystem::path& path) {
    const toml::table table = readToml(path);
    TomlSection root(table, path, "");
    SceneDescription scene = defaultScene();
    readProbeKeys(root, scene);
    root.refuseUnknownKeys();
    const ProbeDescription probe{scene.probe, scene.detector};
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
    SceneDescription scene;
    scene.probe = probe.lever;
    scene.detector = probe.detector;
    toml::table table;
    for (const SceneField& field : sceneFields()) {
        if (isOfProbeFile(field)) {
            insertKey(field, scene, table);
        }
    }
    return table;
}

}  // namespace asperity
