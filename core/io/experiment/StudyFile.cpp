#include "core/io/experiment/StudyFile.h"

#include "core/Error.h"
#include "core/PathText.h"
#include "core/TemporaryFile.h"
#include "core/experiment/StudyChecks.h"
#include "core/io/scene/NamedChoice.h"
#include "core/io/scene/ProbeFile.h"
#include "core/io/scene/SceneFile.h"
#include "core/io/scene/SceneSaving.h"
#include "core/io/scene/TomlFile.h"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

namespace asperity {

namespace {

constexpr const char* kMaterials = "material";
constexpr const char* kLevers = "lever";
constexpr const char* kTasks = "task";

/// Calls `read` with each table of a list [[name]].
template <class Read>
void forEachTable(const toml::table& root, const std::filesystem::path& path, const char* name,
                  const Read& read) {
    const toml::node* const node = root.get(name);
    if (node == nullptr) {
        return;
    }
    const toml::array* const list = node->as_array();
    if (list == nullptr || !(list->empty() || list->is_array_of_tables())) {
        throw InputError(path.string(), "line " + std::to_string(node->source().begin.line),
                         std::string("'") + name + "' must be a list of tables, each written [[" +
                             name + "]]");
    }
    for (const toml::node& one : *list) {
        TomlSection section(*one.as_table(), path, "");
        read(section);
        section.refuseUnknownKeys();
    }
}

std::filesystem::path requiredFile(TomlSection& section, const char* what) {
    std::filesystem::path file = section.path("file");
    if (file.empty()) {
        section.refuse("file", std::string("the path of a ") + what);
    }
    return file;
}

std::vector<std::size_t> materialsOf(TomlSection& section,
                                     const std::vector<SampleMaterial>& materials) {
    std::vector<std::size_t> numbers;
    const auto names = section.texts("materials");
    for (std::size_t i = 0; i < materials.size(); ++i) {
        if (!names || std::ranges::count(*names, materials[i].name) > 0) {
            numbers.push_back(i);
        }
    }
    const auto isKnown = [&](const std::string& name) {
        return std::ranges::count(materials, name, &SampleMaterial::name) > 0;
    };
    if (names && !std::ranges::all_of(*names, isKnown)) {
        section.refuse("materials", "names of this study's materials");
    }
    return numbers;
}

StudyTask readTask(TomlSection& section, const std::vector<SampleMaterial>& materials) {
    StudyTask task;
    if (!section.has("task")) {
        section.refuse("task", "one of " + keyList<TaskKind>());
    }
    task.kind = choice(section, "task", task.kind);
    task.nearest = section.number("nearest_m", 0.0);
    task.farthest = section.number("farthest_m", task.nearest);
    task.materials = materialsOf(section, materials);
    return task;
}

void readLists(const toml::table& root, const std::filesystem::path& path, Study& study) {
    forEachTable(root, path, kMaterials, [&](TomlSection& section) {
        study.materials.push_back(readMaterialFile(requiredFile(section, "material file")));
        const std::string& name = study.materials.back().name;
        if (std::ranges::count(study.materials, name, &SampleMaterial::name) > 1) {
            section.refuse("file", "a material of another name than " + name);
        }
    });
    forEachTable(root, path, kLevers, [&](TomlSection& section) {
        const std::filesystem::path file = requiredFile(section, "probe file");
        study.levers.push_back(
            {.name = section.text("name", pathText(file.stem())), .probe = readProbe(file)});
    });
    forEachTable(root, path, kTasks, [&](TomlSection& section) {
        study.tasks.push_back(readTask(section, study.materials));
    });
}

void readScale(TomlSection section, DeviceScale& scale) {
    scale.positionGain = section.number("position_gain", scale.positionGain);
    scale.forceGain = section.number("force_gain", scale.forceGain);
    section.refuseUnknownKeys();
}

void readAids(TomlSection section, StudyAids& aids) {
    aids.coupling = section.flag("coupling", aids.coupling);
    aids.forces = section.flag("forces", aids.forces);
    aids.deformation = section.flag("deformation", aids.deformation);
    aids.guide = choice(section, "guide", aids.guide);
    section.refuseUnknownKeys();
}

void readRoot(TomlSection root, Study& study) {
    study.name = root.text("name", study.name);
    const std::filesystem::path scene = root.path("scene");
    if (scene.empty()) {
        root.refuse("scene", "the path of a scene");
    }
    study.scene = readScene(scene);
    study.targets = root.places("targets_m");
    study.startHeight = root.number("start_height_m", study.startHeight);
    study.repeats = static_cast<int>(
        std::min<std::uint64_t>(root.count("repeats", static_cast<std::uint64_t>(study.repeats)),
                                std::numeric_limits<int>::max()));
    study.training = root.number("training_s", study.training);
    study.timeLimit = root.number("time_limit_s", study.timeLimit);
    for (const char* name : {kMaterials, kLevers, kTasks, "scale", "aids"}) {
        root.allow(name);
    }
    root.refuseUnknownKeys();
}

// By number: a name may be none for a file.
std::string materialFile(std::size_t index) {
    return "material_" + std::to_string(index + 1) + ".toml";
}

std::string leverFile(std::size_t index) { return "lever_" + std::to_string(index + 1) + ".toml"; }

toml::table taskTable(const Study& study, const StudyTask& task) {
    toml::array materials;
    for (const std::size_t material : task.materials) {
        materials.push_back(study.materials.at(material).name);
    }
    return toml::table{{"task", keyOf(task.kind)},
                       {"nearest_m", task.nearest},
                       {"farthest_m", task.farthest},
                       {"materials", std::move(materials)}};
}

toml::table studyTable(const Study& study) {
    toml::array targets;
    for (const Vector2& target : study.targets) {
        targets.push_back(toml::array{target.x(), target.y()});
    }
    toml::array materials;
    for (std::size_t i = 0; i < study.materials.size(); ++i) {
        materials.push_back(toml::table{{"file", materialFile(i)}});
    }
    toml::array levers;
    for (std::size_t i = 0; i < study.levers.size(); ++i) {
        levers.push_back(toml::table{{"file", leverFile(i)}, {"name", study.levers[i].name}});
    }
    toml::array tasks;
    for (const StudyTask& task : study.tasks) {
        tasks.push_back(taskTable(study, task));
    }
    return toml::table{{"name", study.name},
                       {"scene", "scene.toml"},
                       {"targets_m", std::move(targets)},
                       {"start_height_m", study.startHeight},
                       {"repeats", study.repeats},
                       {"training_s", study.training},
                       {"time_limit_s", study.timeLimit},
                       {"scale", toml::table{{"position_gain", study.scale.positionGain},
                                             {"force_gain", study.scale.forceGain}}},
                       {"aids", toml::table{{"coupling", study.aids.coupling},
                                            {"forces", study.aids.forces},
                                            {"deformation", study.aids.deformation},
                                            {"guide", keyOf(study.aids.guide)}}},
                       {kMaterials, std::move(materials)},
                       {kLevers, std::move(levers)},
                       {kTasks, std::move(tasks)}};
}

void writeText(const std::filesystem::path& path, const std::string& text) {
    OutputFile file(path);
    file.stream() << text;
    file.commit();
}

}  // namespace

Study readStudy(const std::filesystem::path& path) {
    const toml::table root = readToml(path);
    Study study;
    study.name = pathText(path.stem());
    readRoot(TomlSection(root, path, ""), study);
    readLists(root, path, study);
    readScale(TomlSection(root, path, "scale"), study.scale);
    readAids(TomlSection(root, path, "aids"), study.aids);
    try {
        checkStudy(study);
    } catch (const StudyRefused& refused) {
        throw InputError(path.string(), refused.key, "expected " + refused.reason);
    }
    return study;
}

void writeStudy(const Study& study, const std::filesystem::path& folder) {
    saveScene(study.scene, folder / "scene.toml");
    for (std::size_t i = 0; i < study.materials.size(); ++i) {
        writeText(folder / materialFile(i), materialText(study.materials[i], ""));
    }
    for (std::size_t i = 0; i < study.levers.size(); ++i) {
        writeText(folder / leverFile(i), probeText(study.levers[i].probe, ""));
    }
    writeText(folder / "study.toml", commented(studyTable(study), ""));
}

}  // namespace asperity
