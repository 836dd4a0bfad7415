#include "app/experiment/ExperimentFolder.h"

#include "core/Error.h"
#include "core/FormattedText.h"
#include "core/io/experiment/StudyFile.h"
#include "core/scene/SceneDescription.h"

#include <algorithm>
#include <utility>

namespace asperity {

namespace {

constexpr const char* kStudy = "study.toml";
constexpr const char* kTable = "trials.csv";
constexpr const char* kTrials = "trials";
constexpr const char* kMoments = "trajectory.csv";

/// Everything that a study leaves, for one that replaces it.
const std::vector<std::string> kOwn{kTable,          kTrials,         "figure_11.png",
                                    "figure_11.svg", "figure_12.png", "figure_12.svg",
                                    "figure_13.png", "figure_13.svg", "statistics.csv",
                                    "findings.csv",  "summary.json",  kStudy};

bool isBefore(const TrialRecord& one, const TrialRecord& other) {
    return std::pair(one.plan.number, one.plan.attempt) <
           std::pair(other.plan.number, other.plan.attempt);
}

/// The same study, wherever its files lie.
Study comparable(Study study) {
    forEachFile(study.scene, [](std::string& file) {
        file = file.empty() ? file : std::filesystem::weakly_canonical(file).string();
    });
    return study;
}

}  // namespace

ExperimentFolder::ExperimentFolder(std::filesystem::path folder, const Study& study, FolderUse use)
    : claim_(std::move(folder)), study_(study) {
    take(use);
    std::filesystem::create_directories(path() / kTrials);
    claim_.keep();
    removeHalfTrials();  // of a program that was killed
}

ExperimentFolder::~ExperimentFolder() { removeHalfTrials(); }

void ExperimentFolder::removeHalfTrials() const noexcept {
    std::error_code failure;
    std::filesystem::directory_iterator entry(path() / kTrials, failure);
    for (; !failure && entry != std::filesystem::directory_iterator(); entry.increment(failure)) {
        if (entry->path().filename().native().starts_with('.')) {
            std::error_code ignored;
            std::filesystem::remove_all(entry->path(), ignored);
        }
    }
}

void ExperimentFolder::take(FolderUse use) {
    const bool isThere = std::filesystem::exists(path() / kStudy);
    if (isThere && use == FolderUse::Resume) {
        requireSameStudy();
        if (std::filesystem::exists(path() / kTable)) {
            trials_ = readTrials(path() / kTable, study_);
        }
        return;
    }
    const auto isOwn = [&](const std::string& name) {
        return std::filesystem::exists(path() / name);
    };
    if (isThere && use != FolderUse::Replace) {
        throw Error(path().string() +
                    ": contains a study; --resume continues it, --force replaces it");
    }
    if (!isThere && std::ranges::any_of(kOwn, isOwn)) {  // of a run, or somebody's
        throw Error(path().string() + ": holds files of the names of a study's, and no study");
    }
    for (const std::string& name : kOwn) {
        std::filesystem::remove_all(path() / name);
    }
    writeStudy(study_, path());
}

void ExperimentFolder::requireSameStudy() const {
    if (!holdsStudy(path(), study_)) {
        throw Error((path() / kStudy).string() +
                    ": is another study; --resume continues only the same one");
    }
}

std::filesystem::path ExperimentFolder::folderOf(const PlannedTrial& trial) const {
    const std::string name = formatted("%03d", trial.number);
    return path() / kTrials /
           (trial.attempt == 1 ? name : name + "_" + std::to_string(trial.attempt));
}

std::filesystem::path ExperimentFolder::stagingOf(const PlannedTrial& trial) const {
    const std::filesystem::path folder = folderOf(trial);
    return folder.parent_path() / ("." + folder.filename().string());
}

std::optional<PlannedTrial> ExperimentFolder::nextAttempt(const PlannedTrial& trial) const {
    const std::lock_guard lock(mutex_);
    PlannedTrial next = trial;
    for (const TrialRecord& done : trials_) {
        if (done.plan.number == trial.number) {
            if (done.counts()) {
                return std::nullopt;
            }
            next = again(next);
        }
    }
    return next;
}

std::filesystem::path ExperimentFolder::begin(const PlannedTrial& trial) const {
    std::filesystem::path staging = stagingOf(trial);
    std::filesystem::remove_all(staging);
    std::filesystem::create_directories(staging);
    return staging;
}

void ExperimentFolder::keep(const DoneTrial& trial) {
    writeMoments(stagingOf(trial.record.plan) / kMoments, trial.moments);
    const std::lock_guard lock(mutex_);
    std::filesystem::remove_all(folderOf(trial.record.plan));
    std::filesystem::rename(stagingOf(trial.record.plan), folderOf(trial.record.plan));
    std::vector<TrialRecord> trials = trials_;
    trials.insert(std::ranges::upper_bound(trials, trial.record, isBefore), trial.record);
    writeTable(std::move(trials));
}

/// Trials that cannot be written are not kept here either.
void ExperimentFolder::writeTable(std::vector<TrialRecord> trials) {
    writeTrials(path() / kTable, study_, trials);
    trials_ = std::move(trials);
}

void ExperimentFolder::strikeOut(const PlannedTrial& trial, const std::string& why) {
    const std::lock_guard lock(mutex_);
    std::vector<TrialRecord> trials = trials_;
    const auto found = std::ranges::find(trials, trial, &TrialRecord::plan);
    if (found == trials.end()) {
        throw Error("trial " + std::to_string(trial.number) + " was not done yet");
    }
    found->struckOut = why;
    writeTable(std::move(trials));
}

std::vector<TrialMoment> ExperimentFolder::momentsOf(const TrialRecord& trial) const {
    return readMoments(folderOf(trial.plan) / kMoments);
}

bool holdsStudy(const std::filesystem::path& folder) {
    std::error_code unknown;
    return std::filesystem::exists(folder / kStudy, unknown);
}

bool holdsStudy(const std::filesystem::path& folder, const Study& study) {
    return holdsStudy(folder) && comparable(readStudy(folder / kStudy)) == comparable(study);
}

std::optional<TrialRecord> unplannedTrial(std::span<const TrialRecord> trials,
                                          std::span<const PlannedTrial> planned) {
    for (const TrialRecord& trial : trials) {
        const auto found = std::ranges::find(planned, trial.plan.number, &PlannedTrial::number);
        PlannedTrial expected = found == planned.end() ? PlannedTrial{} : *found;
        while (expected.attempt < trial.plan.attempt) {
            expected = again(expected);
        }
        if (expected != trial.plan) {
            return trial;
        }
    }
    return std::nullopt;
}

void requirePlanned(const ExperimentFolder& folder, std::span<const PlannedTrial> planned) {
    if (const auto trial = unplannedTrial(folder.trials(), planned)) {
        throw Error((folder.path() / kTable).string() + ": trial " +
                    std::to_string(trial->plan.number) +
                    " is none of this study with this --seed, --operators and --repeats");
    }
}

}  // namespace asperity
