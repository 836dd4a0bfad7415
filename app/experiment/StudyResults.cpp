#include "app/experiment/StudyResults.h"

#include "app/program/JsonText.h"
#include "core/FormattedText.h"
#include "core/TemporaryFile.h"
#include "core/experiment/StudyFindings.h"
#include "core/experiment/StudyStatistics.h"
#include "core/io/tables/CsvWriter.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace asperity {

namespace {

using nlohmann::ordered_json;

void writeStatistics(const std::filesystem::path& path,
                     const std::vector<StudyEstimate>& statistics) {
    CsvWriter table(
        path,
        {"of trials that count; low, high: 95 % confidence; empty: of all",
         "a participant is one value, but for the correlation: docs/study.md"},
        {"quantity", "task", "material", "lever", "count", "mean", "deviation", "low", "high"});
    for (const StudyEstimate& estimate : statistics) {
        table.add(keyOf(estimate.quantity))
            .add(keyOf(estimate.task))
            .add(estimate.material)
            .add(estimate.lever)
            .add(std::to_string(estimate.value.count))
            .add(estimate.value.mean)
            .add(estimate.value.deviation)
            .add(estimate.value.low)
            .add(estimate.value.high);
        table.endRow();
    }
    table.close();
}

void writeFindings(const std::filesystem::path& path, const std::vector<StudyFinding>& findings) {
    CsvWriter table(path, {"findings of Vogl, Ma, Sitti (2005), VII, beside those of this study"},
                    {"paper", "verdict", "ours"});
    for (const StudyFinding& finding : findings) {
        table.add(finding.paper).add(keyOf(finding.verdict)).add(finding.ours);
        table.endRow();
    }
    table.close();
}

/// What is no number has no value.
ordered_json numberOrNull(double value) {
    return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr);
}

ordered_json jsonOf(const StudyEstimate& estimate) {
    return {{"quantity", keyOf(estimate.quantity)},
            {"task", keyOf(estimate.task)},
            {"material", estimate.material},
            {"lever", estimate.lever},
            {"count", estimate.value.count},
            {"mean", numberOrNull(estimate.value.mean)},
            {"deviation", numberOrNull(estimate.value.deviation)},
            {"low", numberOrNull(estimate.value.low)},
            {"high", numberOrNull(estimate.value.high)}};
}

/// How many attempts each fault has ended.
std::map<std::string, int> faultsOf(const std::vector<TrialRecord>& trials) {
    std::map<std::string, int> faults;
    for (const TrialRecord& trial : trials) {
        if (trial.fault != Fault::None) {
            ++faults[keyOf(trial.fault)];
        }
    }
    return faults;
}

ordered_json summaryOf(const ExperimentFolder& folder, const std::vector<StudyEstimate>& statistics,
                       const std::vector<StudyFinding>& findings) {
    const std::vector<TrialRecord>& trials = folder.trials();
    ordered_json json{{"study", folder.study().name},
                      {"attempts", trials.size()},
                      {"counting", std::ranges::count_if(trials, &TrialRecord::counts)},
                      {"timed_out", std::ranges::count_if(trials, &TrialRecord::timedOut)},
                      {"faults", faultsOf(trials)},
                      {"statistics", ordered_json::array()},
                      {"findings", ordered_json::array()}};
    for (const StudyEstimate& estimate : statistics) {
        json["statistics"].push_back(jsonOf(estimate));
    }
    for (const StudyFinding& finding : findings) {
        json["findings"].push_back({{"paper", finding.paper},
                                    {"verdict", keyOf(finding.verdict)},
                                    {"ours", finding.ours}});
    }
    return json;
}

/// A number that is not known is a dash.
std::string numberText(const char* format, double number) {
    return std::isnan(number) ? "–" : formatted(format, number);
}

std::string valueText(const Estimate& value, const char* format) {
    return numberText(format, value.mean) + " (" + numberText(format, value.low) + " to " +
           numberText(format, value.high) + ")";
}

std::string rowText(const StudyEstimate& error, const StudyEstimate& time) {
    return formatted("%-5s %-18s %-20s %s %%; %s s\n", keyOf(error.task),
                     error.material.empty() ? "all" : error.material.c_str(), error.lever.c_str(),
                     valueText(error.value, "%.2f").c_str(), valueText(time.value, "%.1f").c_str());
}

}  // namespace

void writeStudyResults(const ExperimentFolder& folder) {
    const auto statistics = studyStatistics(folder.study(), folder.trials());
    const auto findings = findingsOf(folder.study(), folder.trials());
    writeStatistics(folder.path() / "statistics.csv", statistics);
    writeFindings(folder.path() / "findings.csv", findings);
    OutputFile summary(folder.path() / "summary.json");
    summary.stream() << jsonText(summaryOf(folder, statistics, findings)) << '\n';
    summary.commit();
}

std::string studyText(const ExperimentFolder& folder) {
    const auto statistics = studyStatistics(folder.study(), folder.trials());
    std::string text = formatted("%-5s %-18s %-20s %-25s  %s\n", "task", "material", "lever",
                                 "error, of the way", "time");
    for (const StudyEstimate& estimate : statistics) {
        const auto time = std::ranges::find_if(statistics, [&](const StudyEstimate& one) {
            return one.quantity == StudyQuantity::Time && one.task == estimate.task &&
                   one.material == estimate.material && one.lever == estimate.lever;
        });
        if (estimate.quantity == StudyQuantity::ErrorPercent && time != statistics.end()) {
            text += rowText(estimate, *time);
        }
    }
    text += "\nfindings of Vogl, Ma, Sitti (2005):\n";
    for (const StudyFinding& finding : findingsOf(folder.study(), folder.trials())) {
        text += formatted("  %-10s %s: %s\n", nameOf(finding.verdict), finding.paper.c_str(),
                          finding.ours.c_str());
    }
    for (const auto& [fault, count] : faultsOf(folder.trials())) {
        text += formatted("%d of %zu attempts ended by %s\n", count, folder.trials().size(),
                          fault.c_str());
    }
    return text;
}

}  // namespace asperity
