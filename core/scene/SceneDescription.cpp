#include "core/scene/SceneDescription.h"

#include "core/Error.h"
#include "core/FormattedText.h"
#include "core/Units.h"
#include "core/contact/ContactState.h"
#include "core/scene/BelievedModel.h"
#include "core/scene/ModelTerm.h"
#include "core/scene/SceneFields.h"
#include "core/scene/SettingFields.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace asperity {

namespace {

void require(bool holds, const std::string& sentence) {
    if (!holds) {
        throw Error(sentence);
    }
}

/// The number of each key within its limits; of one group, or of all.
void checkNumbers(const SceneDescription& scene, std::optional<SceneGroup> group = {}) {
    for (const SceneField& field : sceneFields()) {
        if (group && field.group != *group) {
            continue;
        }
        const SceneValue value = field.get(scene);
        if (const auto* const number = std::get_if<double>(&value)) {
            require(field.limits.hold(*number), std::string("[") + keyOf(field.group) + "]: " +
                                                    field.key + " must " + field.limits.words);
        }
    }
}

void check(const SampleMaterial& material, const std::string& where) {
    require(material.filmThickness == 0.0 || !(material.maps.youngsModulus || material.maps.mask),
            where + ": film_thickness_m must be 0 where the modulus has a map: the law of a film "
                    "holds for one modulus");
}

/// Only contacts of JKR have an edge that can be held.
void checkRetractWork(const SceneDescription& scene, const SampleMaterial& material,
                      const std::string& where) {
    if (material.retractWork == 0.0) {
        return;
    }
    const std::string key = where + ": retract_work_of_adhesion_j_m2 ";
    require(material.retractWork >= material.workOfAdhesion,
            key + "must be 0 or at least work_of_adhesion_j_m2: a contact that opened more easily "
                  "than it closed would give energy");
    require(!scene.choices.law || isJkr(*scene.choices.law),
            key + "needs [physics] law jkr, jkr_sphere or auto, whose contacts have an edge");
    require(!scene.meniscus.present(), key + "does not go with a meniscus");
}

/// The values of a term come together.
void checkTime(const SampleMaterial& material, const std::string& where) {
    require((material.relaxingModulus > 0.0) == (material.relaxationTime > 0.0),
            where + ": a sample that relaxes needs both relaxing_modulus_pa and relaxation_time_s");
    require((material.drag > 0.0) == (material.dragOffset > 0.0),
            where + ": drag needs both drag_n_s and drag_offset_m");
    require(!(material.relaxingModulus > 0.0) || material.workOfAdhesion < kMinAdhesion,
            where +
                ": a sample with relaxing_modulus_pa must have work_of_adhesion_j_m2 = 0: how a "
                "contact relaxes is known without adhesion only");
}

void checkLeveling(const SampleDescription& sample) {
    const bool needsPoints =
        std::ranges::find(sample.leveling, LevelingStep::ThreePoint) != sample.leveling.end();
    require(!needsPoints || sample.levelPoints, "[sample]: level three_point needs level_points_m "
                                                "(or --level-points), three points on the scan");
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
    require(!sample.erode || sample.imagingTipRadius > 0.0,
            "[sample]: erode needs imaging_tip_radius_m, the radius of the tip that recorded the "
            "scan: another radius would make up a surface");
}

/// A law of a paraboloid would leave the cone out without a word; its name means that shape
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

/// The window must show the upper side alone, and not where it is steeper than a picture shows.
double widestWindow(const ShapeDescription& shape) {
    constexpr double kOfASphere = 1.25;    // radii: its corners lie at 0.88 of the radius
    constexpr double kOfACylinder = 1.75;  // radii: its sides lie at 0.88 of the radius
    return shape.radius * (shape.kind == ShapeKind::Sphere ? kOfASphere : kOfACylinder);
}

[[noreturn]] void refuse(ModelTerm term, const std::string& reason) {
    throw Error(std::string("[fidelity]: ") + keyOf(term) + " cannot be on: " + reason);
}

void checkOn(const SceneDescription& scene, ModelTerm term) {
    if (!isPossible(term, scene)) {
        refuse(term,
               term == ModelTerm::FilmBase ? "the sample's film_thickness_m is 0"
               : term == ModelTerm::RetractWork
                   ? "the sample's retract_work_of_adhesion_j_m2 is not above that on approach"
               : term == ModelTerm::Relaxation ? "the sample's relaxing_modulus_pa is 0"
               : term == ModelTerm::Drag       ? "the sample's drag_n_s is 0"
               : scene.sample.shape && term == ModelTerm::BodyAttraction
                   ? "the sample is a shape, which has nothing beside the contact"
                   : "the sample's work_of_adhesion_j_m2 is 0");
    }
    for (const ModelTerm other : kModelTerms) {
        if (exclude(term, other) && choiceOf(other, scene.choices) == true) {
            refuse(term, std::string(keyOf(other)) + " is on, and no contact law has both");
        }
    }
    const bool isOfTail = term == ModelTerm::BodyAttraction;
    if ((isOfTail || term == ModelTerm::VanDerWaalsTail) &&
        choiceOf(ModelTerm::Adhesion, scene.choices) == false) {
        refuse(term, "adhesion is off");
    }
    if (isOfTail && choiceOf(ModelTerm::VanDerWaalsTail, scene.choices) == false) {
        refuse(term, "van_der_waals_tail is off, of which it is a part");
    }
}

}  // namespace

void checkShape(const ShapeDescription& shape) {
    SceneDescription scene;
    scene.sample.shape = shape;
    checkNumbers(scene, SceneGroup::Shape);
    require(shape.kind == ShapeKind::Plane || shape.size <= widestWindow(shape),
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
            .adhesionRatio =
                material.hasTwoWorks() ? material.retractWork / material.workOfAdhesion : 1.0,
            .meniscus = scene.meniscus,
            .solver = scene.choices.solver};
}

void checkScene(const SceneDescription& scene) {
    checkNumbers(scene);
    if (scene.sample.shape) {
        checkShape(*scene.sample.shape);
    }
    check(scene.sample.material, "[sample]");
    check(scene.truth.material, "[truth]");
    checkRetractWork(scene, scene.sample.material, "[sample]");
    checkRetractWork(scene, scene.truth.material, "[truth]");
    checkTime(scene.sample.material, "[sample]");
    checkTime(scene.truth.material, "[truth]");
    check(scene.sample);
    if (scene.tip.shape().hasCone()) {
        checkLawHasCone(scene);
    }
    require((scene.meniscus.surfaceTension > 0.0) == (scene.meniscus.range > 0.0),
            "[physics]: a meniscus needs both meniscus_tension_n_m and meniscus_range_m");
    check(scene.markers);
    checkTerms(scene);
    require(isWithin(scene.tickRate, kMinTickRate, kMaxTickRate),
            formatted("[haptics]: rate_hz must lie between %g and %g", kMinTickRate, kMaxTickRate));
    checkSettings(scene.settings);
}

void checkTerms(const SceneDescription& scene) {
    for (const ModelTerm term : kModelTerms) {
        const std::optional<bool> on = choiceOf(term, scene.choices);
        if (on && isOfLaw(term) && scene.choices.law) {
            throw Error(std::string("[fidelity]: ") + keyOf(term) +
                        " is the matter of [physics] law, which is " + keyOf(*scene.choices.law) +
                        "; leave out one of them");
        }
        if (on == true && term == ModelTerm::SampleCurvature && scene.choices.law &&
            isSphere(*scene.choices.law)) {
            refuse(term, std::string("[physics] law is ") + keyOf(*scene.choices.law) +
                             ", which takes the sample as flat");
        }
        if (on == true) {
            checkOn(scene, term);
        }
    }
}

}  // namespace asperity
