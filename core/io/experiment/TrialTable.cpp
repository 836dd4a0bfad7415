#include "core/io/experiment/TrialTable.h"

#include "core/Error.h"
#include "core/io/tables/CsvTable.h"
#include "core/io/tables/CsvWriter.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

namespace asperity {

namespace {

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
        plan.material = place(study_.materials, &SampleMaterial::name, "material");
        plan.lever = place(study_.levers, &StudyLever::name, "lever");
        plan.task = taskOf(plan.material);
        plan.repeat = static_cast<int>(whole("repeat"));
        plan.seed = whole("seed");
        plan.target = static_cast<std::size_t>(whole("target")) - 1;
        plan.height = number("height_m");
        return plan;
    }

    /// Two tasks may be of one kind: then the height tells which.
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
    [[nodiscard]] std::size_t place(const List& list, Name name, const char* column) const {
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
