#include "core/io/scene/ProbeFile.h"

#include "core/Error.h"
#include "core/Version.h"
#include "core/contact/Within.h"
#include "core/io/TextValue.h"
#include "core/io/scene/SceneKeys.h"
#include "core/io/tables/CaseTable.h"
#include "core/probe/CantileverModes.h"
#include "core/probe/ForceDecoupling.h"

#include <array>
#include <limits>
#include <string>
#include <vector>

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

/// Slopes of the lever in each row, from radians or from volts.
struct MeasuredSlopes {
    std::vector<LeverSignals> signals;
    std::vector<LeverSignals> sigma;
};

MeasuredSlopes slopesInRadians(const CsvTable& table) {
    const std::vector<double> bending = table.numbers("alpha_rad");
    const std::vector<double> torsion = table.numbers("theta_rad");
    const std::vector<double> sigmaBending = table.numbers("sigma_alpha_rad");
    const std::vector<double> sigmaTorsion = table.numbers("sigma_theta_rad");
    MeasuredSlopes slopes;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        slopes.signals.push_back({bending[row], torsion[row]});
        slopes.sigma.push_back({sigmaBending[row], sigmaTorsion[row]});
    }
    return slopes;
}

MeasuredSlopes slopesInVolts(const CsvTable& table, const VoltsToSignals& conversion) {
    const std::vector<double> vertical = table.numbers("vertical_v");
    const std::vector<double> lateral = table.numbers("lateral_v");
    const std::vector<double> sigmaVertical = table.numbers("sigma_vertical_v");
    const std::vector<double> sigmaLateral = table.numbers("sigma_lateral_v");
    MeasuredSlopes slopes;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        slopes.signals.push_back(conversion.signals({vertical[row], lateral[row]}));
        // A negative deviation must not become a positive one on the way.
        const bool negative = sigmaVertical[row] < 0.0 || sigmaLateral[row] < 0.0;
        slopes.sigma.push_back(negative
                                   ? LeverSignals{-1.0, -1.0}
                                   : conversion.sigma({sigmaVertical[row], sigmaLateral[row]}));
    }
    return slopes;
}

MeasuredSlopes slopesOf(const CsvTable& table, const Cantilever& lever,
                        const DetectorCalibration& detector) {
    if (!table.has("vertical_v")) {
        return slopesInRadians(table);
    }
    if (table.has("alpha_rad") || table.has("theta_rad")) {
        throw InputError(table.file(), "header",
                         "expected either alpha_rad and theta_rad or vertical_v and lateral_v");
    }
    try {
        return slopesInVolts(table, VoltsToSignals(lever, detector));
    } catch (const InputError&) {
        throw;
    } catch (const Error& error) {
        throw InputError(table.file(), "header", error.what());
    }
}

std::vector<Vector3> vectors(const CsvTable& table, const std::array<const char*, 3>& columns) {
    const std::vector<double> x = table.numbers(columns[0]);
    const std::vector<double> y = table.numbers(columns[1]);
    const std::vector<double> z = table.numbers(columns[2]);
    std::vector<Vector3> all;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        all.emplace_back(x[row], y[row], z[row]);
    }
    return all;
}

std::vector<DecouplingInput> inputsOf(const CsvTable& table, const MeasuredSlopes& slopes) {
    const std::vector<Vector3> normal = vectors(table, {"nx", "ny", "nz"});
    const std::vector<Vector3> velocity = vectors(table, {"vx", "vy", "vz"});
    const std::vector<double> friction = table.numbers("friction_coefficient");
    const std::vector<double> strength = table.numbers("shear_strength_pa");
    const std::vector<double> area = table.numbers("contact_area_m2");
    const std::vector<double> model = table.numbers("normal_force_model_n");
    const std::vector<double> sigma = table.numbers("normal_force_sigma_n");
    const std::vector<double> deviation = table.has("normal_deviation_rad")
                                              ? table.numbers("normal_deviation_rad")
                                              : std::vector<double>(table.rows(), 0.0);
    std::vector<DecouplingInput> inputs;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        inputs.push_back({.signals = slopes.signals[row],
                          .sigma = slopes.sigma[row],
                          .normal = normal[row],
                          .normalDeviation = deviation[row],
                          .velocity = velocity[row],
                          .frictionCoefficient = friction[row],
                          .shearStrength = strength[row],
                          .contactArea = area[row],
                          .normalForceModel = model[row],
                          .normalForceSigma = sigma[row]});
    }
    return inputs;
}

void addEstimate(CsvWriter& csv, const ForceEstimate& estimate) {
    const Vector3& f = estimate.force;
    const Matrix3& c = estimate.covariance;
    const bool valid = estimate.kind != DecouplingCase::InvalidInput;
    for (const double value : {f.x(), f.y(), f.z(), c(0, 0), c(1, 1), c(2, 2), c(0, 1), c(0, 2),
                               c(1, 2), estimate.condition}) {
        csv.add(valid ? value : std::numeric_limits<double>::quiet_NaN());
    }
    csv.add(caseText(estimate));
}

std::vector<std::string> commentsFor(const std::string& probe, const std::string& cases,
                                     const Cantilever& lever) {
    return {std::string("Asperity ") + kVersion + " decouple: signals to forces on the tip",
            "probe " + probe + ", stiffness " + exactText(lever.stiffness()) +
                " N/m at the tip; cases " + cases,
            "SI units as each column's name ends; all vectors and the covariance c.._n2 are in the "
            "lab frame; condition: of normal force and friction to signals, without unit",
            "case: regular, near_singular, no_sliding or invalid_input, then what is not plausible "
            "of the force: pushes_along, excess_friction, contradicts_model"};
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
    const ProbeDescription probe{scene.probe, scene.detector, scene.probeSource};
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
    scene.probeSource = probe.source;
    toml::table table;
    for (const SceneField& field : sceneFields()) {
        if (isOfProbeFile(field)) {
            insertKey(field, scene, table);
        }
    }
    return table;
}

void writeForceEstimates(const std::filesystem::path& probe, const std::filesystem::path& cases,
                         std::ostream& out, Progress* progress) {
    const ProbeDescription description = readProbe(probe);
    const Cantilever lever(description.lever);
    const CsvTable table = readCsv(cases);
    const std::vector<DecouplingInput> inputs =
        inputsOf(table, slopesOf(table, lever, description.detector));
    writeCases(
        out, table,
        {.comments = commentsFor(probe.string(), cases.string(), lever),
         .columns = {"fx_n", "fy_n", "fz_n", "cxx_n2", "cyy_n2", "czz_n2", "cxy_n2", "cxz_n2",
                     "cyz_n2", "condition", "case"},
         .add = [&](CsvWriter& csv,
                    std::size_t row) { addEstimate(csv, estimateForce(lever, inputs[row])); }},
        progress);
}

}  // namespace asperity
