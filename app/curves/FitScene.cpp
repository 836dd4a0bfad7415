#include "app/curves/FitScene.h"

#include "core/Error.h"
#include "core/PrintableText.h"
#include "core/TemporaryFile.h"
#include "core/Version.h"
#include "core/io/scene/ProbeFile.h"
#include "core/io/scene/SceneFile.h"
#include "core/io/scene/TomlFile.h"
#include "core/scene/ModelChoices.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace asperity {

namespace {

/// E* of the fit is that of the sample alone.
constexpr double kRigidTip = 1e30;  // [Pa]

double numberOf(const FittedCurve& curve, const char* key, double otherwise) {
    const IdentifiedValue* const value = curve.found.find(key);
    return value != nullptr ? value->value : otherwise;
}

/// Relative deviation of a value by noise and calibration; none: the curve does not say it.
std::optional<double> shareOf(const FittedCurve& curve, const char* key) {
    const IdentifiedValue* const value = curve.found.find(key);
    if (value == nullptr || value->value == 0.0) {
        return std::nullopt;
    }
    const double share = std::hypot(value->std, value->stdCalibration) / std::abs(value->value);
    return share > 0.0 ? std::optional(std::min(share, 1.0)) : std::nullopt;
}

std::string sourceText(const FittedCurve& curve) {
    return printable("asperity fit, curve " + std::to_string(curve.index) + " of " +
                     std::filesystem::path(curve.file).filename().string() + ": " +
                     nameOf(curve.found.verdict) + ", " + curve.found.model);
}

SampleMaterial materialOf(const FittedCurve& curve) {
    const double modulus = numberOf(curve, "youngs_modulus_pa", 0.0);
    const double work = numberOf(curve, "work_of_adhesion_j_m2", 0.0);
    const bool hasTwoWorks = curve.found.find("work_of_adhesion_approach_j_m2") != nullptr;
    return {.name = printable(std::filesystem::path(curve.file).stem().string()),
            .source = sourceText(curve),
            .elastic = {.youngsModulus = numberOf(curve, "long_term_modulus_pa", modulus),
                        .poissonRatio = numberOf(curve, "poisson_ratio", 0.5)},
            .workOfAdhesion = numberOf(curve, "work_of_adhesion_approach_j_m2", work),
            .retractWork = hasTwoWorks ? work : 0.0,
            .relaxingModulus = numberOf(curve, "relaxing_modulus_pa", 0.0),
            .relaxationTime = numberOf(curve, "relaxation_time_s", 0.0),
            .drag = numberOf(curve, "drag_n_s", 0.0),
            .dragOffset = numberOf(curve, "drag_offset_m", 0.0),
            .friction = {.coefficient = 0.0, .shearStrength = 0.0},
            .filmThickness = numberOf(curve, "film_thickness_m", 0.0)};
}

SceneDescription sceneOf(const FittedCurve& curve) {
    SceneDescription scene = withMaterial(defaultScene(), materialOf(curve));
    scene.tip = {.radius = curve.found.tip->radius,
                 .elastic = {.youngsModulus = kRigidTip, .poissonRatio = 0.0}};
    if (curve.found.tip->kind == TipKind::ConeSphere) {
        scene.tip.coneHalfAngle = curve.found.tip->angle;
    }
    const double stiffness = numberOf(curve, "stiffness_n_m", 0.0);
    scene.probe.thickness = thicknessForStiffness(scene.probe, stiffness);
    scene.probeSource = scene.sample.material.source;
    scene.truth.stiffness = stiffness;
    scene.cohesiveRange = numberOf(curve, "cohesive_range_m", scene.cohesiveRange);
    scene.choices.law = curve.found.law;
    const std::vector<double>& force = curve.found.approach.corrected;
    const double largest = force.empty() ? 0.0 : *std::ranges::max_element(force);
    scene.setpoint = std::clamp(largest, kMinSetpoint, kMaxSetpoint);
    return scene;
}

/// The deviations of the fit, in place of the usual ones.
toml::table uncertaintyTable(const FittedCurve& curve) {
    struct Row {
        const char* parameter;
        UncertaintyInput input;
    };
    constexpr std::array<Row, 6> kRows{{{"stiffness_n_m", UncertaintyInput::Stiffness},
                                        {"tip_radius_m", UncertaintyInput::TipRadius},
                                        {"youngs_modulus_pa", UncertaintyInput::Modulus},
                                        {"long_term_modulus_pa", UncertaintyInput::Modulus},
                                        {"work_of_adhesion_j_m2", UncertaintyInput::WorkOfAdhesion},
                                        {"cohesive_range_m", UncertaintyInput::CohesiveRange}}};
    toml::table table;
    for (const Row& row : kRows) {
        if (const auto share = shareOf(curve, row.parameter)) {
            table.insert(keyOf(row.input), *share);
        }
    }
    return table;
}

std::string sceneText(const FittedCurve& curve, const SceneDescription& scene) {
    toml::table tip{{"radius_m", scene.tip.radius},
                    {"youngs_modulus_pa", scene.tip.elastic.youngsModulus}};
    if (scene.tip.coneHalfAngle > 0.0) {
        tip.insert("cone_half_angle_rad", scene.tip.coneHalfAngle);
    }
    toml::table physics{{"law", keyOf(*curve.found.law)}};
    if (curve.found.find("cohesive_range_m") != nullptr) {
        physics.insert("cohesive_range_m", scene.cohesiveRange);
    }
    const toml::table table{{"sample", toml::table{{"shape", "plane"},
                                                   {"shape_size_m", 20.0 * scene.tip.radius},
                                                   {"material", "material.toml"}}},
                            {"tip", tip},
                            {"probe", toml::table{{"file", "probe.toml"}}},
                            {"physics", physics},
                            {"approach", toml::table{{"setpoint_n", scene.setpoint}}},
                            {"uncertainty", uncertaintyTable(curve)}};
    return commented(table, std::string("Written by Asperity ") + kVersion + ", " +
                                sourceText(curve) + ".\nA flat sample under a tip that the fit " +
                                "takes as rigid; see docs/measured.md.");
}

void write(const std::filesystem::path& file, const std::string& text) {
    OutputFile output(file);
    output.stream() << text;
    output.commit();
}

}  // namespace

std::string refusalOfScene(const FittedCurve& curve) {
    const CurveIdentification& found = curve.found;
    if (!curve.error.empty() || found.verdict == FitVerdict::Refused) {
        return "the curve was refused";
    }
    if (!found.tip) {
        return "no tip is named, and a scene needs one";
    }
    if (!hasRadius(found.tip->kind)) {
        return std::string(
                   "the tip of a scene is a sphere, with or without a cone, and that of the "
                   "fit is a ") +
               nameOf(found.tip->kind);
    }
    if (!found.law) {
        return "no scene has its model, " + found.model;
    }
    const SceneDescription scene = sceneOf(curve);
    try {
        checkScene(scene);
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

void writeFitScene(const std::filesystem::path& folder, const FittedCurve& curve) {
    if (const std::string refusal = refusalOfScene(curve); !refusal.empty()) {
        throw Error("no scene can be made of the fit: " + refusal);
    }
    const SceneDescription scene = sceneOf(curve);
    write(folder / "material.toml",
          materialText(scene.sample.material, "Sample that a measured curve was fitted with. "
                                              "Friction was not measured: none."));
    write(folder / "probe.toml",
          probeText({scene.probe, scene.detector, scene.probeSource},
                    "Lever of a measured curve: its stiffness, with the plan of the default "
                    "lever,\nwhich the curve does not say."));
    write(folder / "scene.toml", sceneText(curve, scene));
}

}  // namespace asperity
