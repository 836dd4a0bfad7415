#include "core/scene/SceneDescription.h"

#include "core/Error.h"
#include "core/Units.h"
#include "core/contact/ContactStatus.h"
#include "core/contact/Within.h"
#include "core/scene/BelievedModel.h"
#include "core/scene/SettingFields.h"
#include "core/scene/TermChecks.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace asperity {

namespace {

void require(bool holds, const std::string& sentence) {
    if (!holds) {
        throw Error(sentence);
    }
}

void check(const Elastic& elastic, const std::string& where) {
    require(std::isfinite(elastic.youngsModulus) && elastic.youngsModulus > 0.0,
            where + ": youngs_modulus_pa must be a positive number of pascals");
    require(elastic.poissonRatio >= 0.0 && elastic.poissonRatio <= 0.5,
            where + ": poisson_ratio must lie between 0 and 0.5");
}

void check(const SampleMaterial& material, const std::string& where) {
    check(material.elastic, where);
    require(std::isfinite(material.workOfAdhesion) && material.workOfAdhesion >= 0.0,
            where + ": work_of_adhesion_j_m2 must be zero or a positive number of J/m^2");
    require(material.friction.coefficient >= 0.0 && material.friction.coefficient <= 10.0,
            where + ": friction_coefficient must lie between 0 and 10");
    require(std::isfinite(material.friction.shearStrength) &&
                material.friction.shearStrength >= 0.0,
            where + ": shear_strength_pa must be zero or a positive number of pascals");
    require(std::isfinite(material.hardness) && material.hardness >= 0.0,
            where + ": hardness_pa must be zero or a positive number of pascals");
    require(std::isfinite(material.filmThickness) && material.filmThickness >= 0.0,
            where + ": film_thickness_m must be zero or a positive number of meters");
    require(material.filmThickness == 0.0 || !(material.maps.youngsModulus || material.maps.mask),
            where + ": film_thickness_m must be 0 where the modulus has a map: the law of a film "
                    "holds for one modulus");
}

void check(const Meniscus& meniscus) {
    require(isWithin(meniscus.surfaceTension, 0.0, 10.0),
            "[physics]: meniscus_tension_n_m must lie between 0 and 10");
    require(isWithin(meniscus.contactAngle, 0.0, std::numbers::pi / 2.0),
            "[physics]: meniscus_angle_rad must lie between 0 and a right angle");
    require(meniscus.range == 0.0 || isWithin(meniscus.range, 1e-12, 1e-6),
            "[physics]: meniscus_range_m must be 0 or lie between 1e-12 and 1e-6");
    require((meniscus.surfaceTension > 0.0) == (meniscus.range > 0.0),
            "[physics]: a meniscus needs both meniscus_tension_n_m and meniscus_range_m");
}

void checkLeveling(const SampleDescription& sample) {
    const bool needsPoints =
        std::ranges::find(sample.leveling, LevelingStep::ThreePoint) != sample.leveling.end();
    require(!needsPoints || sample.levelPoints, "[sample]: level three_point needs level_points_m "
                                                "(or --level-points), three places on the scan");
    const std::string refusal = sample.levelPoints ? refusalOf(*sample.levelPoints) : "";
    require(refusal.empty(), "[sample]: level_points_m: " + refusal);
}

void check(const std::vector<Marker>& markers) {
    std::set<std::string> names;
    for (const Marker& marker : markers) {
        require(!marker.name.empty(), "[[marker]]: each marker needs a name");
        require(names.insert(marker.name).second,
                "[[marker]]: two markers have the name '" + marker.name + "'");
        require(std::isfinite(marker.x) && std::isfinite(marker.y),
                "[[marker]]: x_m and y_m of '" + marker.name +
                    "' must be finite numbers of meters");
    }
}

void check(const SampleDescription& sample) {
    checkLeveling(sample);
    require(sample.imagingTipRadius == 0.0 || isWithin(sample.imagingTipRadius, 1e-12, 1.0),
            "[sample]: imaging_tip_radius_m must be 0 (not known) or lie between 1e-12 and 1");
    require(!sample.erode || sample.imagingTipRadius > 0.0,
            "[sample]: erode needs imaging_tip_radius_m, the radius of the tip that recorded the "
            "scan: another radius would make up a surface");
}

void check(const Uncertainty& uncertainty) {
    for (const UncertaintyRow& row : kEnumTable<UncertaintyInput>) {
        if (row.deviation != nullptr) {
            require(isWithin(uncertainty.*row.deviation, 0.0, row.max),
                    std::string("[uncertainty]: ") + row.key + " must " + row.limits);
        }
    }
}

/// A law of a paraboloid would leave the cone out without a word; its name stands for that shape
/// in every file, so that it is not read as another law's.
void checkLawHasCone(const SceneDescription& scene) {
    const LawChoice choice = usualLaw(scene);
    const bool isApproximation = choice.reason != LawReason::AskedFor && !isFilm(choice.law);
    if (!leavesOutCone(choice.law) || isApproximation) {
        return;
    }
    const std::optional<ContactLaw> exact = lawLike(choice.law, true, hasTail(choice.law));
    throw Error(std::string("[tip]: cone_half_angle_rad must be 0 under the law ") +
                keyOf(choice.law) + ", which takes the tip for a paraboloid; " +
                (exact ? std::string("[physics] law ") + keyOf(*exact) + " has the cone"
                       : "no law of its kind has a cone"));
}

void check(const TipDescription& tip, const SceneDescription& scene) {
    check(tip.elastic, "[tip]");
    require(std::isfinite(tip.radius) && tip.radius > 0.0,
            "[tip]: radius_m must be a positive number of meters");
    require(checkCone(tip.coneHalfAngle) == ContactStatus::Solved,
            "[tip]: cone_half_angle_rad must be 0 (no cone) or lie between 0.01 and 1.55");
    if (tip.shape().hasCone()) {
        checkLawHasCone(scene);
    }
}

/// The window must show the upper side alone, and not where it is steeper than a picture shows.
double widestWindow(const ShapeDescription& shape) {
    constexpr double kOfASphere = 1.25;    // radii: its corners lie at 0.88 of the radius
    constexpr double kOfACylinder = 1.75;  // radii: its sides lie at 0.88 of the radius
    return shape.radius * (shape.kind == ShapeKind::Sphere ? kOfASphere : kOfACylinder);
}

}  // namespace

void checkShape(const ShapeDescription& shape) {
    constexpr double kMaxSlope = 1.4835298641951802;  // 85 degrees [rad]
    require(isWithin(shape.size, 1e-9, 1e-3),
            "[sample]: shape_size_m must lie between 1e-9 and 1e-3");
    if (shape.kind == ShapeKind::Plane) {
        require(isWithin(shape.slope, -kMaxSlope, kMaxSlope),
                "[sample]: shape_slope_rad must lie between -1.4835 and 1.4835 (85 degrees)");
        return;
    }
    require(isWithin(shape.radius, 1e-9, 1e-3),
            "[sample]: shape_radius_m must lie between 1e-9 and 1e-3");
    require(shape.size <= widestWindow(shape),
            "[sample]: shape_size_m must be at most 1.25 radii of a sphere or 1.75 of a cylinder");
}

SceneDescription defaultScene() {
    SceneDescription scene;
    // The 14 N/m silicon lever of docs/theory.md 5.5.
    scene.probe = {.youngsModulus = 169.0_GPa,
                   .poissonRatio = 0.27,
                   .length = 150.0_um,
                   .width = 30.0_um,
                   .thickness = 0.0,
                   .tipHeight = 12.0_um,
                   .mountTilt = 0.0,
                   .azimuth = 0.0};
    constexpr double kStiffness = 14.0;  // [N/m]
    scene.probe.thickness = thicknessForStiffness(scene.probe, kStiffness);
    scene.sample.material.hardness = 0.3_GPa;  // typical of glassy polystyrene under a sharp tip
    scene.truth.material = scene.sample.material;
    scene.truth.stiffness = kStiffness;
    return scene;
}

SceneDescription withMaterial(SceneDescription scene, const SampleMaterial& material) {
    if (scene.truth.material == scene.sample.material) {
        scene.truth.material = material;
    }
    scene.sample.material = material;
    return scene;
}

ContactPair contactPair(const SceneDescription& scene, const SampleMaterial& material) {
    return {.tipRadius = scene.tip.radius,
            .reducedModulus = reducedModulus(material.elastic, scene.tip.elastic),
            .workOfAdhesion = material.workOfAdhesion};
}

ContactOptions contactOptions(const SceneDescription& scene, const SampleMaterial& material) {
    return {.cohesiveStress = material.workOfAdhesion / scene.cohesiveRange,
            .filmThickness = material.filmThickness,
            .film = {.poissonRatio = material.elastic.poissonRatio,
                     .share = sampleShare(material.elastic, scene.tip.elastic)},
            .coneHalfAngle = scene.tip.coneHalfAngle,
            .meniscus = scene.meniscus,
            .solver = scene.choices.solver};
}

void checkScene(const SceneDescription& scene) {
    if (scene.sample.shape) {
        checkShape(*scene.sample.shape);
    }
    check(scene.sample.material, "[sample]");
    check(scene.truth.material, "[truth]");
    check(scene.tip, scene);
    check(scene.sample);
    require(isWithin(scene.cohesiveRange, 1e-12, 1e-6),
            "[physics]: cohesive_range_m must lie between 1e-12 and 1e-6");
    check(scene.meniscus);
    check(scene.markers);
    require(scene.signalSigma > 0.0 && std::isfinite(scene.signalSigma),
            "[probe]: signal_noise_rad must be a positive number of radians");
    require(scene.truth.signalNoise >= 0.0 && std::isfinite(scene.truth.signalNoise),
            "[truth]: signal_noise_rad must be zero or a positive number of radians");
    require(scene.truth.stiffness > 0.0 && std::isfinite(scene.truth.stiffness),
            "[truth]: stiffness_n_m must be a positive number of N/m");
    require(scene.truth.temperature >= 0.0 && std::isfinite(scene.truth.temperature),
            "[truth]: temperature_k must be zero or a positive number of kelvin");
    require(isWithin(scene.tolerance, 0.0, 1.0), "[fidelity]: tolerance must lie between 0 and 1");
    checkTerms(scene);
    check(scene.uncertainty);
    require(scene.tickRate >= 100.0 && scene.tickRate <= 20000.0,
            "[haptics]: rate_hz must lie between 100 and 20000");
    checkSettings(scene.settings);
    require(isSetpoint(scene.setpoint), "[approach]: setpoint_n must lie between 1e-12 and 1e-3");
    require(scene.zoomHalfWidth >= 0.0 && std::isfinite(scene.zoomHalfWidth),
            "[view]: zoom_half_width_m must be zero or a positive number of meters");
}

}  // namespace asperity
