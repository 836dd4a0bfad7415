#include "core/scene/SceneFields.h"

#include "core/contact/ContactStatus.h"
#include "core/probe/CantileverModes.h"
#include "core/scene/MaterialMapFields.h"
#include "core/scene/SampleFields.h"
#include "core/scene/SceneFieldOf.h"
#include "core/scene/UncertaintyFields.h"

#include <cmath>
#include <iterator>
#include <numbers>

namespace asperity {

namespace {

using scene_field::at;
using scene_field::kDegree;
using scene_field::kMicro;
using scene_field::kNano;

constexpr double kMilli = 1e-3;
constexpr double kKilo = 1e3;
constexpr double kGiga = 1e9;

constexpr double kQuarterTurn = std::numbers::pi / 2.0;  ///< [rad]

// As far as the contact laws go. A rigid tip is 1e30 Pa.
constexpr Limits kModulus{0.1, 1e30, "lie between 0.1 and 1e30"};
constexpr Limits kPoisson{0.0, 0.5, "lie between 0 and 0.5"};
constexpr Limits kNoise{1e-15, 1.0, "lie between 1e-15 and 1"};
constexpr Limits kStiffness{1e-9, 1e9, "lie between 1e-9 and 1e9"};
constexpr Limits kPressure{0.0, 1e15, "lie between 0 and 1e15"};

/// @param place of a SampleMaterial in a scene
template <class Place>
std::vector<SceneField> materialFields(SceneGroup group, Place place) {
    std::vector<SceneField> fields{
        at(
            group, "name", {"Name", "Of the material, as lists and curves show it"}, {},
            [](auto& scene) -> auto& { return Place{}(scene).name; }),
        at(
            group, "youngs_modulus_pa", {"Young's modulus", "Of the sample", "GPa", kGiga},
            kModulus, [](auto& scene) -> auto& { return Place{}(scene).elastic.youngsModulus; }),
        at(
            group, "poisson_ratio", {"Poisson's ratio", "Of the sample, 0 to 0.5"}, kPoisson,
            [](auto& scene) -> auto& { return Place{}(scene).elastic.poissonRatio; }),
        at(
            group, "work_of_adhesion_j_m2",
            {"Work of adhesion", "Of tip and sample; 0: no adhesion", "mJ/m²", kMilli},
            {0.0, 1e3, "lie between 0 and 1e3"},
            [](auto& scene) -> auto& { return Place{}(scene).workOfAdhesion; }),
        at(
            group, "friction_coefficient",
            {"Friction coefficient", "µ in friction = µ × normal force + τ × contact area"},
            {0.0, 10.0, "lie between 0 and 10"},
            [](auto& scene) -> auto& { return Place{}(scene).friction.coefficient; }),
        at(
            group, "shear_strength_pa",
            {"Shear strength", "τ in friction = µ × normal force + τ × contact area", "MPa", 1e6},
            kPressure, [](auto& scene) -> auto& { return Place{}(scene).friction.shearStrength; }),
        at(
            group, "hardness_pa",
            {"Hardness",
             "Mean pressure under a plastic indent of the sample; 0: not known, a twentieth of a "
             "modulus of 1 GPa or more",
             "GPa", kGiga},
            kPressure, [](auto& scene) -> auto& { return Place{}(scene).hardness; }),
        at(
            group, "yields",
            {"Yields", "Off: an elastomer or a gel, which breaks before it yields"}, {},
            [](auto& scene) -> auto& { return Place{}(scene).yields; }),
        at(
            group, "film_thickness_m",
            {"Film thickness", "Of a film on a rigid base; 0: a half-space", "nm", kNano},
            {1e-12, 1.0, "be 0 or lie between 1e-12 and 1", true},
            [](auto& scene) -> auto& { return Place{}(scene).filmThickness; }),
    };
    std::ranges::move(materialMapFields(group, place), std::back_inserter(fields));
    return fields;
}

std::vector<SceneField> tipFields() {
    constexpr SceneGroup kGroup = SceneGroup::Tip;
    return {
        at(
            kGroup, "radius_m", {"Radius", "Of the sphere that ends the tip", "nm", kNano},
            {1e-12, 1.0, "lie between 1e-12 and 1"},
            [](auto& scene) -> auto& { return scene.tip.radius; }),
        at(
            kGroup, "cone_half_angle_rad",
            {"Cone half angle", "Between axis and cone that the sphere goes on as; 0: no cone", "°",
             kDegree},
            {kMinConeHalfAngle, kMaxConeHalfAngle, "be 0 or lie between 0.01 and 1.55", true},
            [](auto& scene) -> auto& { return scene.tip.coneHalfAngle; }),
        at(
            kGroup, "youngs_modulus_pa", {"Young's modulus", "Of the tip", "GPa", kGiga}, kModulus,
            [](auto& scene) -> auto& { return scene.tip.elastic.youngsModulus; }),
        at(
            kGroup, "poisson_ratio", {"Poisson's ratio", "Of the tip, 0 to 0.5"}, kPoisson,
            [](auto& scene) -> auto& { return scene.tip.elastic.poissonRatio; }),
    };
}

std::vector<SceneField> truthFields() {
    constexpr SceneGroup kGroup = SceneGroup::Truth;
    std::vector<SceneField> fields = materialFields(
        kGroup, [](auto& scene) -> auto& { return scene.truth.material; });
    std::ranges::move(
        std::vector<SceneField>{
            at(
                kGroup, "stiffness_n_m",
                {"Stiffness", "Of the true lever, at the tip along its normal", "N/m"}, kStiffness,
                [](auto& scene) -> auto& { return scene.truth.stiffness; }),
            at(
                kGroup, "signal_noise_rad",
                {"Signal noise", "Standard deviation of the detector's white noise in each signal",
                 "µrad", kMicro},
                {0.0, 1.0, "lie between 0 and 1"},
                [](auto& scene) -> auto& { return scene.truth.signalNoise; }),
            at(
                kGroup, "noise_seed", {"Noise seed", "Another seed, other random numbers"},
                {0.0, 9e15, "be a whole number from 0 to 9e15"},
                [](auto& scene) -> auto& { return scene.truth.noiseSeed; }),
            at(
                kGroup, "temperature_k",
                {"Temperature", "Of the lever; 0: no thermal noise, 296 in a warm room", "K"},
                {0.0, 1e5, "lie between 0 and 1e5"},
                [](auto& scene) -> auto& { return scene.truth.temperature; })},
        std::back_inserter(fields));
    return fields;
}

std::vector<SceneField> physicsFields() {
    constexpr SceneGroup kGroup = SceneGroup::Physics;
    return {
        at(
            kGroup, "law", {"Contact law", "Automatic: as materials and tip require"}, {},
            [](auto& scene) -> auto& { return scene.choices.law; }),
        at(
            kGroup, "cohesive_range_m",
            {"Cohesive range", "h0 of the Maugis-Dugdale laws: their stress is w / h0", "nm",
             kNano},
            {1e-12, 1e-6, "lie between 1e-12 and 1e-6"},
            [](auto& scene) -> auto& { return scene.cohesiveRange; }),
        at(
            kGroup, "meniscus_tension_n_m",
            {"Meniscus tension", "Surface tension of a water bridge, 72 mN/m for water; 0: none",
             "mN/m", kMilli},
            {0.0, 10.0, "lie between 0 and 10"},
            [](auto& scene) -> auto& { return scene.meniscus.surfaceTension; }),
        at(
            kGroup, "meniscus_angle_rad",
            {"Meniscus angle", "Contact angle of the water bridge", "°", kDegree},
            {0.0, kQuarterTurn, "lie between 0 and a right angle"},
            [](auto& scene) -> auto& { return scene.meniscus.contactAngle; }),
        at(
            kGroup, "meniscus_range_m",
            {"Meniscus range", "Gap at which the bridge breaks, 1 to 3 nm", "nm", kNano},
            {1e-12, 1e-6, "be 0 or lie between 1e-12 and 1e-6", true},
            [](auto& scene) -> auto& { return scene.meniscus.range; }),
    };
}

/// The terms are those of kModelTerms.
std::vector<SceneField> fidelityFields() {
    constexpr SceneGroup kGroup = SceneGroup::Fidelity;
    constexpr const char* kTerm = "Whether the model has it; automatic: where it matters";
    const auto term = [](const char* key, const char* caption, auto place) {
        return at(kGroup, key, {caption, kTerm}, {}, place);
    };
    return {
        at(
            kGroup, "tolerance",
            {"Tolerance", "Share by which terms left out may change forces and displacements", "%",
             0.01},
            {0.0, 1.0, "lie between 0 and 1"},
            [](auto& scene) -> auto& { return scene.tolerance; }),
        at(
            kGroup, "deformation", {"Deformation", "How the drawn surface is deformed"}, {},
            [](auto& scene) -> auto& { return scene.choices.deformation; }),
        at(
            kGroup, "foot_search", {"Closest points", "How contact points are searched for"}, {},
            [](auto& scene) -> auto& { return scene.choices.closestPointSearch; }),
        term(
            "adhesion", "Adhesion", [](auto& scene) -> auto& { return scene.choices.adhesion; }),
        term(
            "van_der_waals_tail", "Van der Waals tail",
            [](auto& scene) -> auto& { return scene.choices.vanDerWaalsTail; }),
        term(
            "sphere_correction", "Sphere correction",
            [](auto& scene) -> auto& { return scene.choices.sphereCorrection; }),
        term(
            "film_base", "Film's base",
            [](auto& scene) -> auto& { return scene.choices.filmBase; }),
        term(
            "curvature", "Sample curvature",
            [](auto& scene) -> auto& { return scene.choices.curvature; }),
        term(
            "body_attraction", "Body attraction",
            [](auto& scene) -> auto& { return scene.choices.bodyAttraction; }),
        term(
            "friction", "Friction", [](auto& scene) -> auto& { return scene.choices.friction; }),
        term(
            "torsion", "Lever torsion", [](auto& scene) -> auto& { return scene.choices.torsion; }),
        term(
            "mount_tilt", "Mount tilt",
            [](auto& scene) -> auto& { return scene.choices.mountTilt; }),
        at(
            kGroup, "contact_solver",
            {"Contact solver",
             "Of the Maugis-Dugdale laws: from scratch, from the last state, or by "
             "table"},
            {}, [](auto& scene) -> auto& { return scene.choices.solver; }),
        at(
            kGroup, "decoupling", {"Decoupling", "How the lever's signals become a force"}, {},
            [](auto& scene) -> auto& { return scene.choices.decoupling; }),
    };
}

std::vector<SceneField> endFields() {
    return {
        at(
            SceneGroup::Approach, "setpoint_n",
            {"Setpoint", "Force along z at which Engage and an approach stop", "nN", kNano},
            {kMinSetpoint, kMaxSetpoint, "lie between 1e-12 and 1e-3"},
            [](auto& scene) -> auto& { return scene.setpoint; }),
        at(
            SceneGroup::View, "zoom_half_width_m",
            {"Half width", "Half the width of the large view; 0: chosen from the contact", "nm",
             kNano},
            {0.0, 1.0, "lie between 0 and 1"},
            [](auto& scene) -> auto& { return scene.zoomHalfWidth; }),
    };
}

/// How stiffness and resonance of a beam come from what it says; a file states them in its place.
SceneField withAccess(SceneField field, SceneValue (*get)(const SceneDescription&),
                      void (*set)(SceneDescription&, const SceneValue&)) {
    field.get = get;
    field.set = set;
    field.ownForm = true;
    return field;
}

std::vector<SceneField> beamFields() {
    constexpr SceneGroup kGroup = SceneGroup::Probe;
    constexpr Limits kLength{1e-9, 1.0, "lie between 1e-9 and 1"};
    const auto lever = [](const char* key, const SceneWords& words, const Limits& limits,
                          auto place) { return at(kGroup, key, words, limits, place); };
    return {
        lever(
            "length_m", {"Length", "Of the beam, clamp to free end", "µm", kMicro}, kLength,
            [](auto& scene) -> auto& { return scene.probe.length; }),
        lever(
            "width_m", {"Width", "Of the beam", "µm", kMicro}, kLength,
            [](auto& scene) -> auto& { return scene.probe.width; }),
        lever(
            "set_back_m", {"Set-back", "Free end to tip, along the beam", "µm", kMicro},
            {0.0, 1.0, "be 0 or more, and less than the length"},
            [](auto& scene) -> auto& { return scene.probe.setBack; }),
        withAccess(
            lever(
                "stiffness_n_m",
                {"Stiffness", "At the tip, along the lever's normal; the thickness follows", "N/m"},
                kStiffness, [](auto& scene) -> auto& { return scene.probe.thickness; }),
            [](const SceneDescription& scene) -> SceneValue {
                return Cantilever(scene.probe).stiffness();
            },
            [](SceneDescription& scene, const SceneValue& value) {
                scene.probe.thickness = thicknessForStiffness(scene.probe, std::get<double>(value));
            }),
        withAccess(
            lever(
                "resonance_hz",
                {"Resonance", "Fundamental one, in air; the thickness follows", "kHz", kKilo},
                {1e-3, 1e12, "lie between 1e-3 and 1e12"},
                [](auto& scene) -> auto& { return scene.probe.thickness; }),
            [](const SceneDescription& scene) -> SceneValue {
                return flexuralMode(scene.probe, 1).frequency();
            },
            [](SceneDescription& scene, const SceneValue& value) {
                scene.probe.thickness = thicknessForResonance(scene.probe, std::get<double>(value));
            }),
        lever(
            "thickness_m",
            {"Thickness", "Of the beam; stiffness and resonance follow", "µm", kMicro}, kLength,
            [](auto& scene) -> auto& { return scene.probe.thickness; }),
        lever(
            "youngs_modulus_pa", {"Young's modulus", "Of the beam", "GPa", kGiga},
            {1.0, 1e15, "lie between 1 and 1e15"},
            [](auto& scene) -> auto& { return scene.probe.youngsModulus; }),
        lever(
            "poisson_ratio", {"Poisson's ratio", "Of the beam, 0 to 0.5"}, kPoisson,
            [](auto& scene) -> auto& { return scene.probe.poissonRatio; }),
        lever(
            "density_kg_m3", {"Density", "Of the beam", "kg/m³"},
            {1e-3, 1e6, "lie between 1e-3 and 1e6"},
            [](auto& scene) -> auto& { return scene.probe.density; }),
        lever(
            "q_factor", {"Q factor", "Of the fundamental resonance"},
            {1e-6, 1e12, "lie between 1e-6 and 1e12"},
            [](auto& scene) -> auto& { return scene.probe.qualityFactor; }),
        lever(
            "tip_height_m", {"Tip height", "Beam axis to apex", "µm", kMicro}, kLength,
            [](auto& scene) -> auto& { return scene.probe.tipHeight; }),
        lever(
            "mount_tilt_rad", {"Mount tilt", "Of the lever, free end down", "°", kDegree},
            {-kQuarterTurn, kQuarterTurn, "lie between minus and plus a right angle"},
            [](auto& scene) -> auto& { return scene.probe.mountTilt; }),
        lever(
            "azimuth_rad",
            {"Azimuth", "Of the beam in the image; 0: it points along +x", "°", kDegree},
            {-1e3, 1e3, "lie between -1e3 and 1e3"},
            [](auto& scene) -> auto& { return scene.probe.azimuth; }),
    };
}

std::vector<SceneField> detectorFields() {
    constexpr SceneGroup kGroup = SceneGroup::Probe;
    constexpr Limits kCrossTalk{-0.9, 0.9, "lie between -0.9 and 0.9"};
    return {
        at(
            kGroup, "inv_ols_m_v",
            {"InvOLS", "Deflection per volt of the vertical signal, from a hard wall; 0: not known",
             "nm/V", kNano},
            {0.0, 1.0, "lie between 0 and 1"},
            [](auto& scene) -> auto& { return scene.detector.invOls; }),
        at(
            kGroup, "lateral_sensitivity_rad_v",
            {"Lateral sensitivity",
             "Torsion per volt of the lateral signal; negative where the lever is wired so; 0: not "
             "known",
             "mrad/V", kMilli},
            {-1e6, 1e6, "lie between -1e6 and 1e6"},
            [](auto& scene) -> auto& { return scene.detector.torsionPerVolt; }),
        at(
            kGroup, "cross_talk_vertical",
            {"Cross-talk, vertical", "Volts in the vertical signal per volt of the lateral one"},
            kCrossTalk, [](auto& scene) -> auto& { return scene.detector.verticalCrossTalk; }),
        at(
            kGroup, "cross_talk_lateral",
            {"Cross-talk, lateral", "Volts in the lateral signal per volt of the vertical one"},
            kCrossTalk, [](auto& scene) -> auto& { return scene.detector.lateralCrossTalk; }),
        at(
            kGroup, "signal_noise_rad",
            {"Signal noise", "Of each lever signal, as the estimator assumes it", "µrad", kMicro},
            kNoise, [](auto& scene) -> auto& { return scene.signalSigma; }),
    };
}

std::vector<SceneField> allFields() {
    std::vector<SceneField> all;
    for (std::vector<SceneField> part :
         {sampleFields(), shapeFields(),
          materialFields(
              SceneGroup::Material, [](auto& scene) -> auto& { return scene.sample.material; }),
          tipFields(), beamFields(), detectorFields(), truthFields(), physicsFields(),
          fidelityFields(), uncertaintyFields(), endFields()}) {
        std::ranges::move(part, std::back_inserter(all));
    }
    return all;
}

}  // namespace

const std::vector<SceneField>& sceneFields() {
    static const std::vector<SceneField> fields = allFields();
    return fields;
}

const SceneField& sceneField(SceneGroup group, std::string_view key) {
    const auto isIt = [&](const SceneField& field) {
        return field.group == group && field.key == key;
    };
    return *std::ranges::find_if(sceneFields(), isIt);
}

double fromUnit(double number, double unit) noexcept {
    constexpr double kRounding = 1e-9;  // of units that are powers of ten
    const double parts = std::round(1.0 / unit);
    const bool isPart = unit < 1.0 && std::abs(parts * unit - 1.0) < kRounding;
    return isPart ? number / parts : number * unit;
}

std::string nameOf(const SceneField& field) {
    return std::string(keyOf(field.group)) + "." + field.key;
}

}  // namespace asperity
