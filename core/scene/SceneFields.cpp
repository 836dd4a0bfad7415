#include "core/scene/SceneFields.h"

#include "core/contact/ContactState.h"
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
constexpr Limits kBeamLength{1e-9, 1.0, "lie between 1e-9 and 1"};
constexpr Limits kPressure{0.0, 1e15, "lie between 0 and 1e15"};

/// Makes a field of a material one that files and panels name only where it, or that of [sample],
/// is not as in a new material.
template <auto Member, class Access>
void stateWhere(std::vector<SceneField>& fields, std::string_view key, Access /*access*/) {
    const auto field = std::ranges::find(fields, key, &SceneField::key);
    field->isStated = [](const SceneDescription& scene) {
        const SampleMaterial usual;
        return Access{}(scene).*Member != usual.*Member ||
               scene.sample.material.*Member != usual.*Member;
    };
}

/// @param access of a SampleMaterial in a scene
template <class Access>
std::vector<SceneField> timeFields(SceneGroup group, Access /*access*/) {
    return {
        at(
            group, "relaxing_modulus_pa",
            {"Relaxing modulus",
             "That Young's modulus has more at once than after a long time; 0: it does not relax",
             "kPa", kKilo},
            {0.1, 1e30, "be 0 or lie between 0.1 and 1e30", true},
            [](auto& scene) -> auto& { return Access{}(scene).relaxingModulus; }),
        at(
            group, "relaxation_time_s",
            {"Relaxation time", "Of the relaxing modulus", "ms", kMilli},
            {1e-9, 1e9, "be 0 or lie between 1e-9 and 1e9", true},
            [](auto& scene) -> auto& { return Access{}(scene).relaxationTime; }),
        at(
            group, "drag_n_s",
            {"Drag", "C of the force C × speed / (gap + offset) of a liquid; 0: none", "pN s",
             1e-12},
            {1e-30, 1.0, "be 0 or lie between 1e-30 and 1", true},
            [](auto& scene) -> auto& { return Access{}(scene).drag; }),
        at(
            group, "drag_offset_m",
            {"Drag offset", "Gap that the liquid keeps in contact", "nm", kNano},
            {1e-12, 1.0, "be 0 or lie between 1e-12 and 1", true},
            [](auto& scene) -> auto& { return Access{}(scene).dragOffset; }),
    };
}

/// The truth's are those of [sample] where it states none.
template <class Access>
void stateWhatIsSet(std::vector<SceneField>& fields, Access access) {
    stateWhere<&SampleMaterial::source>(fields, "source", access);
    stateWhere<&SampleMaterial::retractWork>(fields, "retract_work_of_adhesion_j_m2", access);
    stateWhere<&SampleMaterial::relaxingModulus>(fields, "relaxing_modulus_pa", access);
    stateWhere<&SampleMaterial::relaxationTime>(fields, "relaxation_time_s", access);
    stateWhere<&SampleMaterial::drag>(fields, "drag_n_s", access);
    stateWhere<&SampleMaterial::dragOffset>(fields, "drag_offset_m", access);
}

/// @param access of a SampleMaterial in a scene
template <class Access>
std::vector<SceneField> materialFields(SceneGroup group, Access access) {
    std::vector<SceneField> fields{
        at(
            group, "name", {"Name", "Of the material, as lists and curves show it"}, {},
            [](auto& scene) -> auto& { return Access{}(scene).name; }),
        at(
            group, "source", {"Source", "Where the numbers of the material come from"}, {},
            [](auto& scene) -> auto& { return Access{}(scene).source; }),
        at(
            group, "youngs_modulus_pa", {"Young's modulus", "Of the sample", "GPa", kGiga},
            kModulus, [](auto& scene) -> auto& { return Access{}(scene).elastic.youngsModulus; }),
        at(
            group, "poisson_ratio", {"Poisson's ratio", "Of the sample, 0 to 0.5"}, kPoisson,
            [](auto& scene) -> auto& { return Access{}(scene).elastic.poissonRatio; }),
        at(
            group, "work_of_adhesion_j_m2",
            {"Work of adhesion", "Of tip and sample; 0: no adhesion", "mJ/m²", kMilli},
            {0.0, 1e3, "lie between 0 and 1e3"},
            [](auto& scene) -> auto& { return Access{}(scene).workOfAdhesion; }),
        at(
            group, "retract_work_of_adhesion_j_m2",
            {"Work on retract",
             "Of adhesion, while a contact shrinks, under a law of JKR; 0: the same", "mJ/m²",
             kMilli},
            {0.0, 1e3, "lie between 0 and 1e3"},
            [](auto& scene) -> auto& { return Access{}(scene).retractWork; }),
        at(
            group, "friction_coefficient",
            {"Friction coefficient", "µ in friction = µ × normal force + τ × contact area"},
            {0.0, 10.0, "lie between 0 and 10"},
            [](auto& scene) -> auto& { return Access{}(scene).friction.coefficient; }),
        at(
            group, "shear_strength_pa",
            {"Shear strength", "τ in friction = µ × normal force + τ × contact area", "MPa", 1e6},
            kPressure, [](auto& scene) -> auto& { return Access{}(scene).friction.shearStrength; }),
        at(
            group, "hardness_pa",
            {"Hardness",
             "Mean pressure under a plastic indent of the sample; 0: not known, a twentieth of a "
             "modulus of 1 GPa or more",
             "GPa", kGiga},
            kPressure, [](auto& scene) -> auto& { return Access{}(scene).hardness; }),
        at(
            group, "yields",
            {"Yields", "Off: an elastomer or a gel, which breaks before it yields"}, {},
            [](auto& scene) -> auto& { return Access{}(scene).yields; }),
        at(
            group, "film_thickness_m",
            {"Film thickness", "Of a film on a rigid base; 0: a half-space", "nm", kNano},
            {1e-12, 1.0, "be 0 or lie between 1e-12 and 1", true},
            [](auto& scene) -> auto& { return Access{}(scene).filmThickness; }),
    };
    std::ranges::move(timeFields(group, access), std::back_inserter(fields));
    stateWhatIsSet(fields, access);
    std::ranges::move(materialMapFields(group, access), std::back_inserter(fields));
    return fields;
}

std::vector<SceneField> tipFields() {
    constexpr SceneGroup kGroup = SceneGroup::Tip;
    return {
        at<&SceneDescription::tip, &TipDescription::radius>(
            kGroup, "radius_m", {"Radius", "Of the sphere that ends the tip", "nm", kNano},
            {1e-12, 1.0, "lie between 1e-12 and 1"}),
        at<&SceneDescription::tip, &TipDescription::coneHalfAngle>(
            kGroup, "cone_half_angle_rad",
            {"Cone half angle", "Between axis and cone that the sphere goes on as; 0: no cone", "°",
             kDegree},
            {kMinConeHalfAngle, kMaxConeHalfAngle, "be 0 or lie between 0.01 and 1.55", true}),
        at<&SceneDescription::tip, &TipDescription::elastic, &Elastic::youngsModulus>(
            kGroup, "youngs_modulus_pa", {"Young's modulus", "Of the tip", "GPa", kGiga}, kModulus),
        at<&SceneDescription::tip, &TipDescription::elastic, &Elastic::poissonRatio>(
            kGroup, "poisson_ratio", {"Poisson's ratio", "Of the tip, 0 to 0.5"}, kPoisson),
    };
}

/// Of an instrument that plays a curve.
std::vector<SceneField> curveFields() {
    constexpr SceneGroup kGroup = SceneGroup::Truth;
    std::vector<SceneField> fields{
        at<&SceneDescription::truth, &TruthDescription::curve>(
            kGroup, "curve",
            {"Recorded curve", "Measured force curve that the instrument plays; empty: simulated"},
            {}),
        at<&SceneDescription::truth, &TruthDescription::curveStiffness>(
            kGroup, "curve_stiffness_n_m",
            {"Lever of the curve",
             "Stiffness, where the file of the curve does not say it; 0: it does", "N/m"},
            {1e-9, 1e9, "be 0 or lie between 1e-9 and 1e9", true})};
    fields.front().input = SceneInput::File;
    for (SceneField& field : fields) {
        field.isStated = [](const SceneDescription& scene) { return !scene.truth.curve.empty(); };
    }
    return fields;
}

std::vector<SceneField> truthFields() {
    constexpr SceneGroup kGroup = SceneGroup::Truth;
    std::vector<SceneField> fields = materialFields(
        kGroup, [](auto& scene) -> auto& { return scene.truth.material; });
    std::ranges::move(
        std::vector<SceneField>{
            at<&SceneDescription::truth, &TruthDescription::stiffness>(
                kGroup, "stiffness_n_m",
                {"Stiffness", "Of the true lever, at the tip along its normal", "N/m"}, kStiffness),
            at<&SceneDescription::truth, &TruthDescription::signalNoise>(
                kGroup, "signal_noise_rad",
                {"Signal noise", "Standard deviation of the detector's white noise in each signal",
                 "µrad", kMicro},
                {0.0, 1.0, "lie between 0 and 1"}),
            at<&SceneDescription::truth, &TruthDescription::noiseSeed>(
                kGroup, "noise_seed", {"Noise seed", "Another seed, other random numbers"},
                {0.0, 9e15, "be a whole number from 0 to 9e15"}),
            at<&SceneDescription::truth, &TruthDescription::temperature>(
                kGroup, "temperature_k",
                {"Temperature", "Of the lever; 0: no thermal noise, 296 in a warm room", "K"},
                {0.0, 1e5, "lie between 0 and 1e5"})},
        std::back_inserter(fields));
    std::ranges::move(curveFields(), std::back_inserter(fields));
    return fields;
}

std::vector<SceneField> physicsFields() {
    constexpr SceneGroup kGroup = SceneGroup::Physics;
    return {
        at<&SceneDescription::choices, &ModelChoices::law>(
            kGroup, "law", {"Contact law", "Automatic: as materials and tip require"}, {}),
        at<&SceneDescription::cohesiveRange>(
            kGroup, "cohesive_range_m",
            {"Cohesive range", "h0 of the Maugis-Dugdale laws: their stress is w / h0", "nm",
             kNano},
            {1e-12, 1e-6, "lie between 1e-12 and 1e-6"}),
        at<&SceneDescription::meniscus, &Meniscus::surfaceTension>(
            kGroup, "meniscus_tension_n_m",
            {"Meniscus tension", "Surface tension of a water bridge, 72 mN/m for water; 0: none",
             "mN/m", kMilli},
            {0.0, 10.0, "lie between 0 and 10"}),
        at<&SceneDescription::meniscus, &Meniscus::contactAngle>(
            kGroup, "meniscus_angle_rad",
            {"Meniscus angle", "Contact angle of the water bridge", "°", kDegree},
            {0.0, kQuarterTurn, "lie between 0 and a right angle"}),
        at<&SceneDescription::meniscus, &Meniscus::range>(
            kGroup, "meniscus_range_m",
            {"Meniscus range", "Gap at which the bridge breaks, 1 to 3 nm", "nm", kNano},
            {1e-12, 1e-6, "be 0 or lie between 1e-12 and 1e-6", true}),
    };
}

template <auto Member>
SceneField term(const char* key, const char* caption) {
    constexpr const char* kTerm = "Whether the model has it; automatic: where it matters";
    return at<&SceneDescription::choices, Member>(SceneGroup::Fidelity, key, {caption, kTerm}, {});
}

/// The terms are those of kModelTerms.
std::vector<SceneField> fidelityFields() {
    constexpr SceneGroup kGroup = SceneGroup::Fidelity;
    return {
        at<&SceneDescription::tolerance>(
            kGroup, "tolerance",
            {"Tolerance", "Share by which terms left out may change forces and displacements", "%",
             0.01},
            {0.0, 1.0, "lie between 0 and 1"}),
        at<&SceneDescription::choices, &ModelChoices::deformation>(
            kGroup, "deformation", {"Deformation", "How the drawn surface is deformed"}, {}),
        at<&SceneDescription::choices, &ModelChoices::closestPointSearch>(
            kGroup, "closest_point_search",
            {"Closest points", "How contact points are searched for"}, {}),
        term<&ModelChoices::adhesion>("adhesion", "Adhesion"),
        term<&ModelChoices::vanDerWaalsTail>("van_der_waals_tail", "Van der Waals tail"),
        term<&ModelChoices::sphereCorrection>("sphere_correction", "Sphere correction"),
        term<&ModelChoices::filmBase>("film_base", "Film's base"),
        term<&ModelChoices::curvature>("curvature", "Sample curvature"),
        term<&ModelChoices::bodyAttraction>("body_attraction", "Body attraction"),
        term<&ModelChoices::retractWork>("retract_work", "Work on retract"),
        term<&ModelChoices::relaxation>("relaxation", "Relaxation"),
        term<&ModelChoices::drag>("drag", "Drag"),
        term<&ModelChoices::friction>("friction", "Friction"),
        term<&ModelChoices::torsion>("torsion", "Lever torsion"),
        term<&ModelChoices::mountTilt>("mount_tilt", "Mount tilt"),
        at<&SceneDescription::choices, &ModelChoices::solver>(
            kGroup, "contact_solver",
            {"Contact solver",
             "Of the Maugis-Dugdale laws: from scratch, from the last state, or by "
             "table"},
            {}),
        at<&SceneDescription::choices, &ModelChoices::decoupling>(
            kGroup, "decoupling", {"Decoupling", "How the lever's signals become a force"}, {}),
    };
}

std::vector<SceneField> endFields() {
    return {
        at<&SceneDescription::setpoint>(
            SceneGroup::Approach, "setpoint_n",
            {"Setpoint", "Force along z at which Engage and an approach stop", "nN", kNano},
            {kMinSetpoint, kMaxSetpoint, "lie between 1e-12 and 1e-3"}),
        at<&SceneDescription::zoomHalfWidth>(
            SceneGroup::View, "zoom_half_width_m",
            {"Half width", "Half the width of the large view; 0: chosen from the contact", "nm",
             kNano},
            {0.0, 1.0, "lie between 0 and 1"}),
    };
}

/// Returns how a beam's stiffness and resonance follow from it; a file states them instead.
SceneField withAccess(SceneField field, SceneValue (*get)(const SceneDescription&),
                      void (*set)(SceneDescription&, const SceneValue&)) {
    field.get = get;
    field.set = set;
    field.ownForm = true;
    return field;
}

template <auto Member>
SceneField lever(const char* key, const SceneWords& words, const Limits& limits) {
    return at<&SceneDescription::probe, Member>(SceneGroup::Probe, key, words, limits);
}

std::vector<SceneField> beamFields() {
    return {
        lever<&CantileverGeometry::length>(
            "length_m", {"Length", "Of the beam, clamp to free end", "µm", kMicro}, kBeamLength),
        lever<&CantileverGeometry::width>("width_m", {"Width", "Of the beam", "µm", kMicro},
                                          kBeamLength),
        lever<&CantileverGeometry::setBack>(
            "set_back_m", {"Set-back", "Free end to tip, along the beam", "µm", kMicro},
            {0.0, 1.0, "be 0 or more, and less than the length"}),
        withAccess(
            lever<&CantileverGeometry::thickness>(
                "stiffness_n_m",
                {"Stiffness", "At the tip, along the lever's normal; the thickness follows", "N/m"},
                kStiffness),
            [](const SceneDescription& scene) -> SceneValue {
                return Cantilever(scene.probe).stiffness();
            },
            [](SceneDescription& scene, const SceneValue& value) {
                scene.probe.thickness = thicknessForStiffness(scene.probe, std::get<double>(value));
            }),
        withAccess(
            lever<&CantileverGeometry::thickness>(
                "resonance_hz",
                {"Resonance", "Fundamental one, in air; the thickness follows", "kHz", kKilo},
                {1e-3, 1e12, "lie between 1e-3 and 1e12"}),
            [](const SceneDescription& scene) -> SceneValue {
                return flexuralMode(scene.probe, 1).frequency();
            },
            [](SceneDescription& scene, const SceneValue& value) {
                scene.probe.thickness = thicknessForResonance(scene.probe, std::get<double>(value));
            }),
        lever<&CantileverGeometry::thickness>(
            "thickness_m",
            {"Thickness", "Of the beam; stiffness and resonance follow", "µm", kMicro},
            kBeamLength),
        lever<&CantileverGeometry::youngsModulus>("youngs_modulus_pa",
                                                  {"Young's modulus", "Of the beam", "GPa", kGiga},
                                                  {1.0, 1e15, "lie between 1 and 1e15"}),
        lever<&CantileverGeometry::poissonRatio>(
            "poisson_ratio", {"Poisson's ratio", "Of the beam, 0 to 0.5"}, kPoisson),
        lever<&CantileverGeometry::density>("density_kg_m3", {"Density", "Of the beam", "kg/m³"},
                                            {1e-3, 1e6, "lie between 1e-3 and 1e6"}),
        lever<&CantileverGeometry::qualityFactor>("q_factor",
                                                  {"Q factor", "Of the fundamental resonance"},
                                                  {1e-6, 1e12, "lie between 1e-6 and 1e12"}),
        lever<&CantileverGeometry::tipHeight>(
            "tip_height_m", {"Tip height", "Beam axis to apex", "µm", kMicro}, kBeamLength),
        lever<&CantileverGeometry::mountTilt>(
            "mount_tilt_rad", {"Mount tilt", "Of the lever, free end down", "°", kDegree},
            {-kQuarterTurn, kQuarterTurn, "lie between minus and plus a right angle"}),
        lever<&CantileverGeometry::azimuth>(
            "azimuth_rad",
            {"Azimuth", "Of the beam in the image; 0: it points along +x", "°", kDegree},
            {-1e3, 1e3, "lie between -1e3 and 1e3"}),
    };
}

std::vector<SceneField> detectorFields() {
    constexpr SceneGroup kGroup = SceneGroup::Probe;
    constexpr Limits kCrossTalk{-0.9, 0.9, "lie between -0.9 and 0.9"};
    std::vector<SceneField> fields{
        at<&SceneDescription::detector, &DetectorCalibration::invOls>(
            kGroup, "inv_ols_m_v",
            {"InvOLS", "Deflection per volt of the vertical signal, from a hard wall; 0: not known",
             "nm/V", kNano},
            {0.0, 1.0, "lie between 0 and 1"}),
        at<&SceneDescription::detector, &DetectorCalibration::torsionPerVolt>(
            kGroup, "lateral_sensitivity_rad_v",
            {"Lateral sensitivity",
             "Torsion per volt of the lateral signal; negative where the lever is wired so; 0: not "
             "known",
             "mrad/V", kMilli},
            {-1e6, 1e6, "lie between -1e6 and 1e6"}),
        at<&SceneDescription::detector, &DetectorCalibration::verticalCrossTalk>(
            kGroup, "cross_talk_vertical",
            {"Cross-talk, vertical", "Volts in the vertical signal per volt of the lateral one"},
            kCrossTalk),
        at<&SceneDescription::detector, &DetectorCalibration::lateralCrossTalk>(
            kGroup, "cross_talk_lateral",
            {"Cross-talk, lateral", "Volts in the lateral signal per volt of the vertical one"},
            kCrossTalk),
        at<&SceneDescription::signalSigma>(
            kGroup, "signal_noise_rad",
            {"Signal noise", "Of each lever signal, as the estimator assumes it", "µrad", kMicro},
            kNoise),
        at<&SceneDescription::probeSource>(
            kGroup, "source", {"Source", "Where the numbers of the lever come from"}, {}),
    };
    fields.back().isStated = [](const SceneDescription& scene) {
        return !scene.probeSource.empty();
    };
    return fields;
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
