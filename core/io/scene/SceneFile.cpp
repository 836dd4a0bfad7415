#include "core/io/scene/SceneFile.h"

#include "core/Error.h"
#include "core/TemporaryFile.h"
#include "core/io/scene/ProbeFile.h"
#include "core/io/scene/SceneKeys.h"
#include "core/io/scene/TomlFile.h"
#include "core/scene/ModelTerm.h"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string_view>
#include <utility>

namespace asperity {

namespace {

/// Returns the material that the keys of a group are about.
SampleMaterial& materialOf(SceneDescription& scene, SceneGroup group) {
    return group == SceneGroup::Truth ? scene.truth.material : scene.sample.material;
}

/// Over what the scene has. Of another modulus, or of several, another hardness.
void readMaterialKeys(TomlSection& section, SceneGroup group, SceneDescription& scene) {
    if (section.has("youngs_modulus_pa") || section.has("youngs_modulus_map") ||
        section.has("material_mask")) {
        materialOf(scene, group).hardness = 0.0;
        materialOf(scene, group).yields = true;
    }
    readKeys(section, group, scene);
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
void readMaterialOf(TomlSection& section, SceneGroup group, SceneDescription& scene) {
    SampleMaterial& material = materialOf(scene, group);
    const std::filesystem::path file = section.path("material");
    if (!file.empty()) {
        material = readMaterialFile(file);
    }
    readMaterialKeys(section, group, scene);
    material.maps = readMaterialSources(section, [&material](const std::filesystem::path& masked) {
        const SampleMaterial given = readMaterialFile(masked);
        return MaskedMaterial{.youngsModulus = asStiffWith(material.elastic.poissonRatio, given),
                              .workOfAdhesion = given.workOfAdhesion,
                              .frictionCoefficient = given.friction.coefficient};
    });
}

void readSample(TomlSection section, SceneDescription& scene) {
    readSampleKeys(section, scene);
    readMaterialOf(section, SceneGroup::Material, scene);
    section.refuseUnknownKeys();
}

void readGroup(TomlSection section, SceneGroup group, SceneDescription& scene) {
    readKeys(section, group, scene);
    section.refuseUnknownKeys();
}

void readProbeSection(TomlSection section, SceneDescription& scene) {
    const std::filesystem::path file = section.path("file");
    if (!file.empty()) {
        const ProbeDescription probe = readProbe(file);
        scene.probe = probe.lever;
        scene.detector = probe.detector;
        scene.probeSource = probe.source;
    }
    readProbeKeys(section, scene);
    readKey(section, sceneField(SceneGroup::Probe, kSignalNoise), scene);
    // In earlier files the estimator had a number of its own.
    double& deviation = scene.uncertainty.surfaceNormal;
    deviation = section.number("normal_deviation_rad", deviation);
    section.refuseUnknownKeys();
}

void readTruth(TomlSection section, SceneDescription& scene) {
    scene.truth = {.material = scene.sample.material,
                   .stiffness = Cantilever(scene.probe).stiffness(),
                   .signalNoise = scene.signalSigma};
    readMaterialOf(section, SceneGroup::Truth, scene);
    MaterialSources& maps = scene.truth.material.maps;
    maps = trueSources(section, maps, scene.sample.material.maps);
    section.refuseUnknownKeys();
}

/// Recordings state each of the terms. One that does not state this one is older than it.
void readFidelity(const TomlSection& section, SceneDescription& scene) {
    readGroup(section, SceneGroup::Fidelity, scene);
    ModelChoices& model = scene.choices;
    const auto isStated = [&model](ModelTerm term) {
        const bool isYounger = std::ranges::find(kMaterialTerms, term) != kMaterialTerms.end();
        return term == ModelTerm::BodyAttraction || isYounger ||
               (model.*traitsOf(term).choice).has_value();
    };
    if (!section.has(keyOf(ModelTerm::BodyAttraction)) &&
        std::ranges::all_of(kSwitchedTerms, isStated)) {
        model.bodyAttraction = false;
    }
}

constexpr const char* kHaptics = "haptics";
constexpr const char* kWindow = "window";  ///< of session files, which the window reads

void refuseUnknownSections(const toml::table& table, const std::filesystem::path& path) {
    TomlSection root(table, path, "");
    for (const auto& group : kEnumTable<SceneGroup>) {
        root.allow(group.key);
    }
    for (const char* name : {kHaptics, kWindow, kMarkers}) {
        root.allow(name);
    }
    root.refuseUnknownKeys();
}

/// Returns whether a file of another extension is a scene: a line of it opens the section [sample].
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

/// @param scene what the file does not state
SceneDescription readSceneOver(SceneDescription scene, const std::filesystem::path& path) {
    const toml::table table = readToml(path);
    refuseUnknownSections(table, path);
    const auto section = [&](SceneGroup group) { return TomlSection(table, path, keyOf(group)); };
    readSample(section(SceneGroup::Sample), scene);
    readGroup(section(SceneGroup::Tip), SceneGroup::Tip, scene);
    readGroup(section(SceneGroup::Uncertainty), SceneGroup::Uncertainty, scene);
    readProbeSection(section(SceneGroup::Probe), scene);
    try {
        readTruth(section(SceneGroup::Truth), scene);
        readFidelity(section(SceneGroup::Fidelity), scene);
        for (const SceneGroup group :
             {SceneGroup::Physics, SceneGroup::Approach, SceneGroup::View}) {
            readGroup(section(group), group, scene);
        }
        readHaptics(TomlSection(table, path, kHaptics), scene);
        scene.markers = readMarkers(table, path);
        checkScene(scene);
    } catch (const InputError&) {
        throw;
    } catch (const Error& error) {
        throw InputError(path.string(), "", error.what());
    }
    return scene;
}

/// Returns whether a path from one to the other need not pass the root of the file system.
bool haveFolderInCommon(const std::filesystem::path& a, const std::filesystem::path& b) {
    const auto first = [](const std::filesystem::path& path) {
        const std::filesystem::path below = path.relative_path();
        return below.empty() ? std::filesystem::path() : *below.begin();
    };
    return a.root_path() == b.root_path() && first(a) == first(b) && !first(a).empty();
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

bool isScene(const std::filesystem::path& path) {
    return path.extension() == ".toml" || hasSampleSection(path);
}

SceneDescription sceneFromInput(const std::filesystem::path& path,
                                const std::optional<SceneDescription>& like) {
    if (isScene(path)) {
        return readScene(path);
    }
    SceneDescription scene = like.value_or(defaultScene());
    SampleDescription sample;
    sample.file = path.string();
    // Maps, curve, markers and guide are of the scan before.
    if (scene.sample.material.maps.any() || scene.truth.material.maps.any()) {
        scene.sample.material = defaultScene().sample.material;
        scene.truth.material = defaultScene().truth.material;
    }
    sample.material = scene.sample.material;
    scene.sample = std::move(sample);
    scene.settings.guide.kind = FixtureKind::None;
    scene.zoomHalfWidth = 0.0;
    scene.truth.curve.clear();
    scene.markers.clear();
    return scene;
}

std::string sceneText(const SceneDescription& scene) {
    toml::table table;
    for (const auto& group : kEnumTable<SceneGroup>) {
        toml::table& section =
            table.insert(group.key, toml::table{}).first->second.ref<toml::table>();
        if (group.value != SceneGroup::Sample && group.value != SceneGroup::Shape) {
            insertKeys(group.value, scene, section);
        }
    }
    toml::table& sample = table["sample"].ref<toml::table>();
    insertSampleKeys(scene, sample);
    insertMaterialSources(scene.sample.material.maps, sample);
    insertMaterialSources(scene.truth.material.maps, table["truth"].ref<toml::table>());
    table.insert(kHaptics, hapticsTable(scene));
    insertMarkers(scene.markers, table);
    std::ostringstream text;
    text << table << '\n';
    return text.str();
}

std::string materialText(const SampleMaterial& material, const std::string& notes) {
    SceneDescription scene;
    scene.sample.material = material;
    toml::table table;
    insertKeys(SceneGroup::Material, scene, table);
    return commented(table, notes);
}

SampleMaterial readMaterialFile(const std::filesystem::path& path) {
    const toml::table table = readToml(path);
    TomlSection root(table, path, "");
    SceneDescription scene;
    readMaterialKeys(root, SceneGroup::Material, scene);
    root.refuseUnknownKeys();
    return scene.sample.material;
}

void saveScene(const SceneDescription& scene, const std::filesystem::path& file,
               const std::string& window) {
    const std::filesystem::path folder = std::filesystem::absolute(file).parent_path();
    SceneDescription saved = withoutHashes(scene);
    forEachFile(saved, [&folder](std::string& name) {
        const std::filesystem::path read = name;
        if (read.is_absolute() && haveFolderInCommon(read.parent_path(), folder)) {
            name = read.lexically_relative(folder.lexically_normal()).string();
        }
    });
    OutputFile output(file);
    output.stream() << sceneText(saved) << window;
    output.commitToDisk();
}

}  // namespace asperity
