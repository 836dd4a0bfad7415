#include "core/scene/SceneFieldChange.h"

#include "core/Error.h"
#include "core/probe/CantileverModes.h"
#include "core/scene/ModelTerm.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace asperity {

namespace {

constexpr double kRounding = 1e-9;  ///< between a stiffness and the thickness made from it

bool isNear(double a, double b) { return std::abs(a - b) <= kRounding * std::abs(a); }

bool isKey(const SceneField& field, std::string_view key) { return field.key == key; }

/// The beam as it is to be, with what was measured of it as before or as given.
CantileverGeometry calibrated(const CantileverGeometry& before, const CantileverGeometry& beam,
                              const SceneField& field, LeverCalibration calibration) {
    const bool setsStiffness = isKey(field, "stiffness_n_m");
    const bool setsResonance = isKey(field, "resonance_hz");
    const auto stiffness = [&] { return Cantilever(setsStiffness ? beam : before).stiffness(); };
    const auto resonance = [&] {
        return flexuralMode(setsResonance ? beam : before, 1).frequency();
    };
    if (isKey(field, "thickness_m")) {
        return beam;
    }
    CantileverGeometry fitted = beam;
    switch (calibration) {
    case LeverCalibration::Thickness:
        break;
    case LeverCalibration::Stiffness:
        if (!setsResonance) {
            fitted.thickness = thicknessForStiffness(beam, stiffness());
        }
        break;
    case LeverCalibration::Resonance:
        if (!setsStiffness) {
            fitted.thickness = thicknessForResonance(beam, resonance());
        }
        break;
    case LeverCalibration::StiffnessAndResonance:
        fitted = withStiffnessAndResonance(beam, stiffness(), resonance());
        break;
    }
    return fitted;
}

/// Returns whether the quantity of a material's field is not the same everywhere.
bool isMapped(const SceneField& field, const MaterialSources& maps) {
    const bool masked = maps.mask.has_value();
    return (isKey(field, "youngs_modulus_pa") && (masked || maps.youngsModulus)) ||
           (isKey(field, "work_of_adhesion_j_m2") && (masked || maps.workOfAdhesion)) ||
           (isKey(field, "friction_coefficient") && (masked || maps.friction));
}

/// The numbers are no longer those that the source gave.
void nameEdited(SampleMaterial& material) {
    material.source.clear();
    if (!material.name.ends_with(kEditedSuffix)) {
        material.name += kEditedSuffix;
    }
}

}  // namespace

void carryTruth(const SceneDescription& before, SceneDescription& scene) {
    if (before.truth.material == before.sample.material) {
        scene.truth.material = scene.sample.material;
    }
    if (before.probe != scene.probe &&
        isNear(before.truth.stiffness, Cantilever(before.probe).stiffness())) {
        scene.truth.stiffness = Cantilever(scene.probe).stiffness();
    }
    if (before.truth.signalNoise == before.signalSigma) {
        scene.truth.signalNoise = scene.signalSigma;
    }
}

SceneDescription withValue(const SceneDescription& scene, const SceneField& field,
                           const SceneValue& value, LeverCalibration calibration) {
    SceneDescription next = scene;
    field.set(next, value);
    if (field.group == SceneGroup::Truth) {
        return next;
    }
    if (field.group == SceneGroup::Probe && next.probe != scene.probe) {
        next.probeSource.clear();
        next.probe = calibrated(scene.probe, next.probe, field, calibration);
    }
    if (field.group == SceneGroup::Material && !isKey(field, "name") && !isKey(field, "source") &&
        next != scene) {
        nameEdited(next.sample.material);
    }
    carryTruth(scene, next);
    return next;
}

SceneDescription defaultsOf(const SceneDescription& scene) {
    SceneDescription defaults = defaultScene();
    defaults.sample.file = scene.sample.file;
    defaults.sample.channel = scene.sample.channel;
    if (scene.sample.shape) {
        ShapeDescription shape{.kind = scene.sample.shape->kind};
        if (shape.kind != ShapeKind::Plane) {
            shape.size = scene.sample.shape->radius;
        }
        defaults.sample.shape = shape;
    }
    defaults.truth.material = scene.sample.material;
    defaults.truth.stiffness = Cantilever(scene.probe).stiffness();
    defaults.truth.signalNoise = scene.signalSigma;
    return defaults;
}

bool isSame(const SceneField& field, const SceneDescription& a, const SceneDescription& b) {
    const SceneValue one = field.get(a);
    const SceneValue other = field.get(b);
    const auto* const number = std::get_if<double>(&one);
    return number != nullptr ? isNear(*number, std::get<double>(other)) : one == other;
}

std::string whyNotOfSample(const SceneField& field, const SceneDescription& scene) {
    const std::optional<ShapeDescription>& shape = scene.sample.shape;
    if (field.group == SceneGroup::Sample && shape) {
        return "The sample is an exact shape, no scan";
    }
    if (field.group != SceneGroup::Shape || isKey(field, "shape")) {
        return {};
    }
    if (!shape) {
        return "The sample is a scan, no shape";
    }
    const bool isPlane = shape->kind == ShapeKind::Plane;
    if (isKey(field, "shape_slope_rad") != isPlane && !isKey(field, "shape_size_m")) {
        return isPlane ? "A plane has no radius" : "Of a plane only";
    }
    return {};
}

std::string whyIdle(const SceneField& field, const SceneDescription& scene) {
    if (std::string why = whyNotOfSample(field, scene); !why.empty()) {
        return why;
    }
    if (field.group == SceneGroup::Material || field.group == SceneGroup::Truth) {
        const bool isTruth = field.group == SceneGroup::Truth;
        const MaterialSources& maps = (isTruth ? scene.truth.material : scene.sample.material).maps;
        if (isMapped(field, maps)) {
            return "Has a map: the largest value in it";
        }
        if (maps.mask && std::string_view(field.key).ends_with("_map")) {
            return "A mask has it, by material_mask of the scene file";
        }
    }
    if (isKey(field, "erode") && scene.sample.imagingTipRadius == 0.0) {
        return "Needs the radius of the imaging tip";
    }
    const bool isLaws = std::ranges::any_of(kEnumTable<ModelTerm>, [&](const auto& term) {
        return isKey(field, term.key) && isOfLaw(term.value);
    });
    if (field.group == SceneGroup::Fidelity && isLaws && scene.choices.law) {
        return "Set by the contact law";
    }
    return {};
}

}  // namespace asperity
