#include "core/io/experiment/StudyFile.h"

#include "core/Error.h"
#include "core/PrintableText.h"
#include "core/TemporaryFile.h"
#include "core/io/scene/ProbeFile.h"
#include "core/io/scene/SceneFile.h"
#include "core/io/scene/TomlFile.h"
#include "core/io/tables/CsvTable.h"
#include "core/io/tables/CsvWriter.h"

#include <algorithm>
#include <charconv>
#include <cmath>
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
    study.targets = root.positions("targets_m");
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

const std::vector<std::string> kTrialColumns{"trial",
                                             "attempt",
                                             "participant",
                                             "task",
                                             "material",
                                             "lever",
                                             "repeat",
                                             "device",
                                             "error_m",
                                             "error_percent",
                                             "time_s",
                                             "largest_force_n",
                                             "handle_motion_m",
                                             "fault",
                                             "timed_out",
                                             "struck_out",
                                             "seed",
                                             "target",
                                             "height_m",
                                             "start_x_m",
                                             "start_y_m",
                                             "start_z_m",
                                             "target_x_m",
                                             "target_y_m",
                                             "target_z_m",
                                             "position_gain",
                                             "force_gain",
                                             "coupling_stiffness_n_m",
                                             "coupling_damping_n_s_m",
                                             "proxy_damping_n_s_m"};

const std::vector<std::string> kMomentColumns{
    "time_s",           "tip_x_m",        "tip_y_m",    "tip_z_m",          "shown_x_m",
    "shown_y_m",        "shown_z_m",      "device_x_m", "device_y_m",       "device_z_m",
    "force_x_n",        "force_y_n",      "force_z_n",  "device_force_x_n", "device_force_y_n",
    "device_force_z_n", "largest_force_n"};

void add(CsvWriter& table, const Vector3& vector) {
    table.add(vector.x()).add(vector.y()).add(vector.z());
}

void addTrial(CsvWriter& table, const Study& study, const TrialRecord& trial) {
    const PlannedTrial& plan = trial.plan;
    table.add(std::to_string(plan.number))
        .add(std::to_string(plan.attempt))
        .add(std::to_string(plan.participant))
        .add(keyOf(study.tasks.at(plan.task).kind))
        .add(study.materials.at(plan.material).name)
        .add(study.levers.at(plan.lever).name)
        .add(std::to_string(plan.repeat))
        .add(trial.device)
        .add(trial.error)
        .add(trial.errorPercent)
        .add(trial.time)
        .add(trial.largestForce)
        .add(trial.handleMotion)
        .add(keyOf(trial.fault))
        .add(trial.timedOut ? "yes" : "no")
        .add(trial.struckOut)
        .add(std::to_string(plan.seed))
        .add(std::to_string(plan.target + 1))
        .add(plan.height);
    add(table, trial.start);
    add(table, trial.target);
    table.add(trial.scale.positionGain)
        .add(trial.scale.forceGain)
        .add(trial.coupling.stiffness)
        .add(trial.coupling.damping)
        .add(trial.coupling.proxyDamping);
    table.endRow();
}

/// One row, cell by cell.
class TrialRow {
public:
    TrialRow(const CsvTable& table, std::size_t row, const Study& study)
        : table_(table), row_(row), study_(study) {}

    [[nodiscard]] TrialRecord read() const {
        TrialRecord trial;
        trial.plan = readPlan();
        trial.device = text("device");
        trial.start = vector("start");
        trial.target = vector("target");
        trial.error = number("error_m");
        trial.errorPercent = number("error_percent");
        trial.time = number("time_s");
        trial.largestForce = number("largest_force_n");
        trial.handleMotion = number("handle_motion_m");
        trial.timedOut = text("timed_out") == "yes";
        trial.fault = required(fromKey<Fault>(text("fault")), "fault");
        trial.struckOut = text("struck_out");
        trial.scale = {.positionGain = number("position_gain"), .forceGain = number("force_gain")};
        trial.coupling = {.stiffness = number("coupling_stiffness_n_m"),
                          .damping = number("coupling_damping_n_s_m"),
                          .proxyDamping = number("proxy_damping_n_s_m")};
        return trial;
    }

private:
    [[nodiscard]] PlannedTrial readPlan() const {
        PlannedTrial plan;
        plan.number = static_cast<int>(whole("trial"));
        plan.attempt = static_cast<int>(whole("attempt"));
        plan.participant = static_cast<int>(whole("participant"));
        plan.material = indexOf(study_.materials, &SampleMaterial::name, "material");
        plan.lever = indexOf(study_.levers, &StudyLever::name, "lever");
        plan.task = taskOf(plan.material);
        plan.repeat = static_cast<int>(whole("repeat"));
        plan.seed = whole("seed");
        plan.target = static_cast<std::size_t>(whole("target")) - 1;
        plan.height = number("height_m");
        return plan;
    }

    /// Two tasks may be of one kind: then the height shows which.
    [[nodiscard]] std::size_t taskOf(std::size_t material) const {
        const auto kind = required(fromKey<TaskKind>(text("task")), "task");
        const double distance = std::abs(number("height_m"));
        for (std::size_t i = 0; i < study_.tasks.size(); ++i) {
            const StudyTask& task = study_.tasks[i];
            if (task.kind == kind && std::ranges::count(task.materials, material) > 0 &&
                distance >= task.nearest && distance <= task.farthest) {
                return i;
            }
        }
        fail("task");
    }

    template <class List, class Name>
    [[nodiscard]] std::size_t indexOf(const List& list, Name name, const char* column) const {
        const auto found = std::ranges::find(list, text(column), name);
        if (found == list.end()) {
            fail(column);
        }
        return static_cast<std::size_t>(found - list.begin());
    }

    [[nodiscard]] std::uint64_t whole(const char* column) const {
        const std::string& cell = text(column);
        std::uint64_t value = 0;
        const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
        if (error != std::errc() || end != cell.data() + cell.size()) {
            fail(column);
        }
        return value;
    }

    [[nodiscard]] Vector3 vector(const std::string& name) const {
        return {table_.number(row_, name + "_x_m"), table_.number(row_, name + "_y_m"),
                table_.number(row_, name + "_z_m")};
    }

    template <class Value>
    [[nodiscard]] Value required(const std::optional<Value>& value, const char* column) const {
        return value ? *value : throw refusal(column);
    }

    [[nodiscard]] std::string text(const char* column) const { return table_.text(row_, column); }
    [[nodiscard]] double number(const char* column) const { return table_.number(row_, column); }

    [[nodiscard]] InputError refusal(const char* column) const {
        return {table_.file(), "line " + std::to_string(table_.line(row_)),
                std::string(column) + " is '" + text(column) + "', which is none of this study"};
    }
    [[noreturn]] void fail(const char* column) const { throw refusal(column); }

    const CsvTable& table_;
    std::size_t row_;
    const Study& study_;
};

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

void writeTrials(const std::filesystem::path& path, const Study& study,
                 std::span<const TrialRecord> trials) {
    CsvWriter table(
        path,
        {"a trial a row: docs/study.md",
         "error: from the target to the tip when the trial ended; in percent of the way "
         "from start to target"},
        kTrialColumns);
    for (const TrialRecord& trial : trials) {
        addTrial(table, study, trial);
    }
    table.close();
}

std::vector<TrialRecord> readTrials(const std::filesystem::path& path, const Study& study) {
    const CsvTable table = readCsv(path);
    std::vector<TrialRecord> trials;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        trials.push_back(TrialRow(table, row, study).read());
    }
    return trials;
}

std::vector<TrialMoment> readMoments(const std::filesystem::path& path) {
    const CsvTable table = readCsv(path);
    std::vector<TrialMoment> moments;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const auto vector = [&](const std::string& name, const char* unit) {
            return Vector3(table.number(row, name + "_x_" + unit),
                           table.number(row, name + "_y_" + unit),
                           table.number(row, name + "_z_" + unit));
        };
        moments.push_back({.time = table.number(row, "time_s"),
                           .tip = vector("tip", "m"),
                           .shown = vector("shown", "m"),
                           .device = vector("device", "m"),
                           .force = vector("force", "n"),
                           .deviceForce = vector("device_force", "n"),
                           .largestForce = table.number(row, "largest_force_n")});
    }
    return moments;
}

void writeMoments(const std::filesystem::path& path, std::span<const TrialMoment> moments) {
    CsvWriter table(path, {"moments of a trial, a hundred times a second and at its end"},
                    kMomentColumns);
    for (const TrialMoment& moment : moments) {
        table.add(moment.time);
        add(table, moment.tip);
        add(table, moment.shown);
        add(table, moment.device);
        add(table, moment.force);
        add(table, moment.deviceForce);
        table.add(moment.largestForce);
        table.endRow();
    }
    table.close();
}

}  // namespace asperity
