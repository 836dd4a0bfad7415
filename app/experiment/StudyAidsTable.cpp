#include "app/experiment/StudyAidsTable.h"

#include "core/experiment/StudyStatistics.h"
#include "core/io/tables/CsvWriter.h"

#include <array>

namespace asperity {

namespace {

struct Measured {
    const char* name;
    double (*of)(const TrialRecord&);
};

constexpr std::array<Measured, 3> kMeasured{
    {{"error_percent", [](const TrialRecord& trial) { return trial.errorPercent; }},
     {"time_s", [](const TrialRecord& trial) { return trial.time; }},
     {"handle_motion_m", [](const TrialRecord& trial) { return trial.handleMotion; }}}};

double shareOfFaults(const std::vector<TrialRecord>& trials, const TrialChoice& choice) {
    double all = 0.0;
    double faults = 0.0;
    for (const TrialRecord& trial : trials) {
        if (choice(trial)) {
            all += 1.0;
            faults += trial.fault != Fault::None ? 1.0 : 0.0;
        }
    }
    return all > 0.0 ? faults / all : 0.0;
}

double meanOf(const std::map<int, double>& means) {
    double sum = 0.0;
    for (const auto& [participant, mean] : means) {
        sum += mean;
    }
    return sum / static_cast<double>(means.size());
}

}  // namespace

std::vector<AidVariant> aidVariants(const Study& study) {
    std::vector<AidVariant> variants{{.name = "as_given", .study = study}};
    const auto add = [&](const char* name, const auto& change) {
        Study other = study;
        change(other.aids);
        if (other != study) {
            variants.push_back({.name = name, .study = std::move(other)});
        }
    };
    add("no_coupling", [](StudyAids& aids) { aids.coupling = false; });
    add("no_forces", [](StudyAids& aids) { aids.forces = false; });
    add("no_deformation", [](StudyAids& aids) { aids.deformation = false; });
    add("point_guide", [](StudyAids& aids) { aids.guide = FixtureKind::Point; });
    return variants;
}

void writeAids(const std::filesystem::path& path, const Study& study,
               const std::vector<AidResult>& results) {
    CsvWriter table(
        path,
        {"difference: of participants' means, less those of the first variant; low, "
         "high: 95 % confidence"},
        {"variant", "task", "quantity", "mean", "difference", "low", "high", "share_of_faults"});
    for (const AidResult& result : results) {
        for (const TaskKind task : {TaskKind::Above, TaskKind::On, TaskKind::Below}) {
            const TrialChoice isOf = [&](const TrialRecord& trial) {
                return study.tasks.at(trial.plan.task).kind == task;
            };
            for (const Measured& measured : kMeasured) {
                const auto own = participantMeans(result.trials, isOf, measured.of);
                if (own.empty()) {
                    continue;
                }
                const Estimate difference = pairedDifference(
                    own, participantMeans(results.front().trials, isOf, measured.of));
                table.add(result.name)
                    .add(keyOf(task))
                    .add(measured.name)
                    .add(meanOf(own))
                    .add(difference.mean)
                    .add(difference.low)
                    .add(difference.high)
                    .add(shareOfFaults(result.trials, isOf));
                table.endRow();
            }
        }
    }
    table.close();
}

}  // namespace asperity
