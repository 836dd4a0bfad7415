#include "core/io/scene/SceneFile.h"

#include "core/Error.h"
#include "core/PathText.h"
#include "core/io/scene/CropKeys.h"
#include "core/io/scene/HapticsKeys.h"
#include "core/io/scene/LevelingKeys.h"
#include "core/io/scene/MarkerKeys.h"
#include "core/io/scene/MaterialMapKeys.h"
#include "core/io/scene/NamedChoice.h"
#include "core/io/scene/ProbeFile.h"
#include "core/io/scene/TomlFile.h"
#include "core/io/scene/UncertaintyKeys.h"
#include "core/scene/ModelTerm.h"
#include "core/surface/fit/GaussianFilter.h"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string_view>
#include <utility>

namespace asperity {

namespace {

SampleMaterial readMaterial(TomlSection& section, const SampleMaterial& otherwise) {
    SampleMaterial material = otherwise;
    material.name = section.text("name", otherwise.name);
    material.elastic.youngsModulus =
        section.number("youngs_modulus_pa", otherwise.elastic.youngsModulus);
    material.elastic.poissonRatio = section.number("poisson_ratio", otherwise.elastic.poissonRatio);
    material.workOfAdhesion = section.number("work_of_adhesion_j_m2", otherwise.workOfAdhesion);
    material.friction.coefficient =
        section.number("friction_coefficient", otherwise.friction.coefficient);
    material.friction.shearStrength =
        section.number("shear_strength_pa", otherwise.friction.shearStrength);
    // Of another modulus, or of several, another hardness.
    const bool another = section.has("youngs_modulus_pa") || section.has("youngs_modulus_map") ||
                         section.has("material_mask");
    material.hardness = section.number("hardness_pa", another ? 0.0 : otherwise.hardness);
    material.yields = section.flag("yields", another || otherwise.yields);
    material.filmThickness = section.number("film_thickness_m", otherwise.filmThickness);
    return material;
}

/// The modulus that a material of this Poisson's ratio needs to be as stiff in a contact: the same
/// E / (1 - nu^2). A mask mixes moduli; the ratio is the sample's.
double asStiffWith(double poissonRatio, const SampleMaterial& given) {
    const double ratio = given.elastic.poissonRatio;
    return ratio == poissonRatio ? given.elastic.youngsModulus
                                 : given.elastic.youngsModulus *
                                       (1.0 - poissonRatio * poissonRatio) / (1.0 - ratio * ratio);
}

/// A material by the key `material` (a file), with single keys of the section over it.
SampleMaterial readMaterialOf(TomlSection& section, const SampleMaterial& otherwise) {
    const std::filesystem::path file = section.path("material");
    SampleMaterial material =
        readMaterial(section, file.empty() ? otherwise : readMaterialFile(file));
    material.maps = readMaterialSources(section, [&material](const std::filesystem::path& masked) {
        const SampleMaterial given = readMaterialFile(masked);
        return MaskedMaterial{.youngsModulus = asStiffWith(material.elastic.poissonRatio, given),
                              .workOfAdhesion = given.workOfAdhesion,
                              .frictionCoefficient = given.friction.coefficient};
    });
    return material;
}

/// By pixels or by length; kAutomatic leaves it to the program.
void readSmoothing(TomlSection& section, SampleDescription& sample) {
    if (section.has("smoothing_m")) {
        if (section.has("smoothing_px")) {
            section.refuse("smoothing_m", "one of smoothing_px and smoothing_m, not both");
        }
        sample.smoothingLength = section.number("smoothing_m", 0.0);
        if (!(sample.smoothingLength >= 0.0 && sample.smoothingLength <= 1.0)) {
            section.refuse("smoothing_m", "a length from 0 to 1 m");
        }
        sample.smoothingPixels = 0.0;
        return;
    }
    if (!section.has("smoothing_px")) {
        return;
    }
    const bool isText = section.isText("smoothing_px");
    if (isText && section.text("smoothing_px", "") == kAutomatic) {
        sample.smoothingPixels.reset();
        return;
    }
    const double pixels = isText ? -1.0 : section.number("smoothing_px", 0.0);
    if (!(pixels >= 0.0 && pixels <= kMaxSmoothing)) {
        section.refuse("smoothing_px", "a number from 0 to 100, or \"auto\"");
    }
    sample.smoothingPixels = pixels;
}

/// A shape; keys that are not its own stay unread, and are refused with the unknown ones.
ShapeDescription readShape(TomlSection& section) {
    ShapeDescription shape;
    shape.kind = choice(section, "shape", shape.kind);
    if (shape.kind == ShapeKind::Plane) {
        shape.slope = section.number("shape_slope_rad", shape.slope);
    } else {
        shape.radius = section.number("shape_radius_m", shape.radius);
    }
    shape.size = section.number("shape_size_m", shape.radius);
    return shape;
}

/// Both sides of the scan, or none.
void readScale(TomlSection& section, const GivenScale& otherwise, GivenScale& scale) {
    if (section.has("size_x_m") != section.has("size_y_m")) {
        section.refuse(section.has("size_x_m") ? "size_y_m" : "size_x_m",
                       "both sides of the scan, size_x_m and size_y_m");
    }
    const auto length = [&section](const char* key, double instead) {
        const double value = section.number(key, instead);
        if (section.has(key) && !(value > 0.0 && std::isfinite(value))) {
            section.refuse(key, "a length above 0");
        }
        return value;
    };
    scale.sizeX = length("size_x_m", otherwise.sizeX);
    scale.sizeY = length("size_y_m", otherwise.sizeY);
    scale.heightPerValue = length("z_scale_m", otherwise.heightPerValue);
}

void readMapKeys(TomlSection& section, const SampleDescription& otherwise,
                 SampleDescription& sample) {
    sample.file = section.path("file").string();
    if (sample.file.empty()) {
        section.refuse("file", "the path of a height map, or 'shape' in its place");
    }
    sample.channel = section.text("channel", otherwise.channel);
    readScale(section, otherwise.scale, sample.scale);
    sample.crop = readCrop(section);
    readLeveling(section, sample);
    readSmoothing(section, sample);
    sample.imagingTipRadius = section.number("imaging_tip_radius_m", otherwise.imagingTipRadius);
    sample.erode = section.flag("erode", otherwise.erode);
}

SampleDescription readSample(TomlSection section, const SampleDescription& otherwise) {
    SampleDescription sample = otherwise;
    if (!section.has("shape")) {
        readMapKeys(section, otherwise, sample);
    } else if (section.has("file")) {
        section.refuse("shape", "a shape or a height map ('file'), not both");
    } else {
        sample.shape = readShape(section);
    }
    sample.material = readMaterialOf(section, otherwise.material);
    section.refuseUnknownKeys();
    return sample;
}

TipDescription readTip(TomlSection section, const TipDescription& otherwise) {
    TipDescription tip;
    tip.radius = section.number("radius_m", otherwise.radius);
    tip.coneHalfAngle = section.number("cone_half_angle_rad", otherwise.coneHalfAngle);
    tip.elastic.youngsModulus =
        section.number("youngs_modulus_pa", otherwise.elastic.youngsModulus);
    tip.elastic.poissonRatio = section.number("poisson_ratio", otherwise.elastic.poissonRatio);
    section.refuseUnknownKeys();
    return tip;
}

void readProbeSection(TomlSection section, SceneDescription& scene) {
    const std::filesystem::path file = section.path("file");
    const ProbeDescription base =
        file.empty() ? ProbeDescription{scene.probe, scene.detector} : readProbe(file);
    const ProbeDescription probe = readProbeKeys(section, base);
    scene.probe = probe.lever;
    scene.detector = probe.detector;
    scene.signalSigma = section.number("signal_noise_rad", scene.signalSigma);
    // Of earlier files: the estimator had a number of its own.
    double& deviation = scene.uncertainty.surfaceNormal;
    deviation = section.number("normal_deviation_rad", deviation);
    section.refuseUnknownKeys();
}

TruthDescription readTruth(TomlSection section, const SceneDescription& scene) {
    TruthDescription truth;
    truth.material = readMaterialOf(section, scene.sample.material);
    truth.material.maps = trueSources(section, truth.material.maps, scene.sample.material.maps);
    truth.stiffness = section.number("stiffness_n_m", Cantilever(scene.probe).stiffness());
    truth.signalNoise = section.number("signal_noise_rad", scene.signalSigma);
    truth.noiseSeed = section.count("noise_seed", truth.noiseSeed);
    truth.temperature = section.number("temperature_k", truth.temperature);
    section.refuseUnknownKeys();
    return truth;
}

void readPhysics(TomlSection section, SceneDescription& scene) {
    scene.choices.law = choiceOrNone(section, "law", scene.choices.law);
    scene.cohesiveRange = section.number("cohesive_range_m", scene.cohesiveRange);
    Meniscus& meniscus = scene.meniscus;
    meniscus.surfaceTension = section.number("meniscus_tension_n_m", meniscus.surfaceTension);
    meniscus.contactAngle = section.number("meniscus_angle_rad", meniscus.contactAngle);
    meniscus.range = section.number("meniscus_range_m", meniscus.range);
    section.refuseUnknownKeys();
}

void readFidelity(TomlSection section, SceneDescription& scene) {
    scene.tolerance = section.number("tolerance", scene.tolerance);
    ModelChoices& model = scene.choices;
    model.solver = choice(section, "contact_solver", model.solver);
    model.decoupling = choice(section, "decoupling", model.decoupling);
    model.deformation = choiceOrNone(section, "deformation", model.deformation);
    model.closestPointSearch = choiceOrNone(section, "foot_search", model.closestPointSearch);
    for (const ModelTermTraits& term : kEnumTable<ModelTerm>) {
        if (term.choice != nullptr) {
            std::optional<bool>& value = model.*term.choice;
            value = choiceOrNone(section, term.key, value);
        }
    }
    // Recordings state each of these terms. One that does not state this one is older than it.
    const auto isStated = [&model](ModelTerm term) {
        return term == ModelTerm::BodyAttraction || (model.*traitsOf(term).choice).has_value();
    };
    if (!section.has(keyOf(ModelTerm::BodyAttraction)) &&
        std::ranges::all_of(kSwitchedTerms, isStated)) {
        model.bodyAttraction = false;
    }
    section.refuseUnknownKeys();
}

void readRest(const toml::table& table, const std::filesystem::path& path,
              SceneDescription& scene) {
    readPhysics(TomlSection(table, path, "physics"), scene);
    readFidelity(TomlSection(table, path, "fidelity"), scene);
    readHaptics(TomlSection(table, path, "haptics"), scene);
    TomlSection approach(table, path, "approach");
    scene.setpoint = approach.number("setpoint_n", scene.setpoint);
    approach.refuseUnknownKeys();
    TomlSection view(table, path, "view");
    scene.zoomHalfWidth = view.number("zoom_half_width_m", scene.zoomHalfWidth);
    view.refuseUnknownKeys();
}

void refuseUnknownSections(const toml::table& table, const std::filesystem::path& path) {
    TomlSection root(table, path, "");
    for (const char* name : {"sample", "tip", "probe", "truth", "physics", "fidelity",
                             "uncertainty", "haptics", "approach", "view", "window", kMarkers}) {
        root.allow(name);
    }
    root.refuseUnknownKeys();
}

/// Whether a file of another extension is a scene: a line of it opens the section [sample].
bool hasSampleSection(const std::filesystem::path& path) {
    constexpr std::streamsize kSearched = 1 << 16;
    if (!std::filesystem::is_regular_file(path)) {
        return false;
    }
    std::string start(kSearched, '\0');
    std::ifstream file(path, std::ios::binary);
    file.read(start.data(), kSearched);
    start.resize(static_cast<std::size_t>(file.gcount()));
    return start.starts_with("[sample]") || start.find("\n[sample]") != std::string::npos;
}

toml::table materialTable(const SampleMaterial& material) {
    return toml::table{{"name", material.name},
                       {"youngs_modulus_pa", material.elastic.youngsModulus},
                       {"poisson_ratio", material.elastic.poissonRatio},
                       {"work_of_adhesion_j_m2", material.workOfAdhesion},
                       {"friction_coefficient", material.friction.coefficient},
                       {"shear_strength_pa", material.friction.shearStrength},
                       {"hardness_pa", material.hardness},
                       {"yields", material.yields},
                       {"film_thickness_m", material.filmThickness}};
}

void insertShape(const ShapeDescription& shape, toml::table& table) {
    table.insert("shape", keyOf(shape.kind));
    if (shape.kind == ShapeKind::Plane) {
        table.insert("shape_slope_rad", shape.slope);
    } else {
        table.insert("shape_radius_m", shape.radius);
    }
    table.insert("shape_size_m", shape.size);
}

toml::table sampleTable(const SampleDescription& sample) {
    toml::table table = materialTable(sample.material);
    insertMaterialSources(sample.material.maps, table);
    if (sample.shape) {
        insertShape(*sample.shape, table);
        return table;
    }
    table.insert("file", pathText(sample.file));
    table.insert("channel", sample.channel);
    if (sample.scale.hasSize()) {
        table.insert("size_x_m", sample.scale.sizeX);
        table.insert("size_y_m", sample.scale.sizeY);
    }
    if (sample.scale.hasHeight()) {
        table.insert("z_scale_m", sample.scale.heightPerValue);
    }
    insertCrop(sample.crop, table);
    insertLeveling(sample, table);
    if (sample.smoothingLength != 0.0) {
        table.insert("smoothing_m", sample.smoothingLength);
    } else if (sample.smoothingPixels) {
        table.insert("smoothing_px", *sample.smoothingPixels);
    } else {
        table.insert("smoothing_px", kAutomatic);
    }
    table.insert("imaging_tip_radius_m", sample.imagingTipRadius);
    table.insert("erode", sample.erode);
    return table;
}

toml::table probeSectionTable(const SceneDescription& scene) {
    toml::table table = probeTable({scene.probe, scene.detector});
    table.insert("signal_noise_rad", scene.signalSigma);
    return table;
}

toml::table fidelityTable(const SceneDescription& scene) {
    const ModelChoices& model = scene.choices;
    toml::table table{{"tolerance", scene.tolerance},
                      {"contact_solver", keyOf(model.solver)},
                      {"decoupling", keyOf(model.decoupling)},
                      {"deformation", keyOf(model.deformation)},
                      {"foot_search", keyOf(model.closestPointSearch)}};
    for (const ModelTermTraits& term : kEnumTable<ModelTerm>) {
        if (term.choice != nullptr) {
            table.insert(term.key, keyOf(model.*term.choice));
        }
    }
    return table;
}

toml::table truthTable(const TruthDescription& truth) {
    toml::table table = materialTable(truth.material);
    insertMaterialSources(truth.material.maps, table);
    table.insert("stiffness_n_m", truth.stiffness);
    table.insert("signal_noise_rad", truth.signalNoise);
    table.insert("noise_seed", static_cast<std::int64_t>(truth.noiseSeed));
    table.insert("temperature_k", truth.temperature);
    return table;
}

/// @param scene what the file does not state
SceneDescription readSceneOver(SceneDescription scene, const std::filesystem::path& path) {
    const toml::table table = readToml(path);
    refuseUnknownSections(table, path);
    scene.sample = readSample(TomlSection(table, path, "sample"), scene.sample);
    scene.tip = readTip(TomlSection(table, path, "tip"), scene.tip);
    readUncertainty(TomlSection(table, path, "uncertainty"), scene.uncertainty);
    readProbeSection(TomlSection(table, path, "probe"), scene);
    try {
        scene.truth = readTruth(TomlSection(table, path, "truth"), scene);
        readRest(table, path, scene);
        scene.markers = readMarkers(table, path);
        checkScene(scene);
    } catch (const InputError&) {
        throw;
    } catch (const Error& error) {
        throw InputError(path.string(), "", error.what());
    }
    return scene;
}

}  // namespace

SceneDescription readScene(const std::filesystem::path& path) {
    return readSceneOver(defaultScene(), path);
}

SceneDescription readRecordedScene(const std::filesystem::path& path) {
    SceneDescription unstated = defaultScene();
    unstated.uncertainty.surfaceNormal = 0.0;
    return readSceneOver(std::move(unstated), path);
}

SceneDescription sceneFromInput(const std::filesystem::path& path) {
    if (path.extension() == ".toml" || hasSampleSection(path)) {
        return readScene(path);
    }
    SceneDescription scene = defaultScene();
    scene.sample.file = path.string();
    return scene;
}

std::string sceneText(const SceneDescription& scene) {
    toml::table table{
        {"sample", sampleTable(scene.sample)},
        {"tip", toml::table{{"radius_m", scene.tip.radius},
                            {"cone_half_angle_rad", scene.tip.coneHalfAngle},
                            {"youngs_modulus_pa", scene.tip.elastic.youngsModulus},
                            {"poisson_ratio", scene.tip.elastic.poissonRatio}}},
        {"probe", probeSectionTable(scene)},
        {"truth", truthTable(scene.truth)},
        {"physics", toml::table{{"law", keyOf(scene.choices.law)},
                                {"cohesive_range_m", scene.cohesiveRange},
                                {"meniscus_tension_n_m", scene.meniscus.surfaceTension},
                                {"meniscus_angle_rad", scene.meniscus.contactAngle},
                                {"meniscus_range_m", scene.meniscus.range}}},
        {"fidelity", fidelityTable(scene)},
        {"uncertainty", uncertaintyTable(scene.uncertainty)},
        {"haptics", hapticsTable(scene)},
        {"approach", toml::table{{"setpoint_n", scene.setpoint}}},
        {"view", toml::table{{"zoom_half_width_m", scene.zoomHalfWidth}}}};
    insertMarkers(scene.markers, table);
    std::ostringstream text;
    text << table << '\n';
    return text.str();
}

std::string materialText(const SampleMaterial& material, const std::string& notes) {
    return commented(materialTable(material), notes);
}

SampleMaterial readMaterialFile(const std::filesystem::path& path) {
    const toml::table table = readToml(path);
    TomlSection root(table, path, "");
    SampleMaterial material = readMaterial(root, {});
    root.refuseUnknownKeys();
    return material;
}

}  // namespace asperity
