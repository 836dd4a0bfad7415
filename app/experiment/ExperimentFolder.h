#pragma once

#include "app/runs/OutputFolder.h"
#include "core/experiment/TrialPlan.h"

#include <filesystem>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace asperity {

/// Use of a folder for a study: it begins one, continues the one in it, or replaces that.
enum class FolderUse : std::uint8_t { New, Resume, Replace };

/// The folder of a study: study.toml and what it names, trials.csv, trials/NNN. Each trial is in
/// its place when it ends: whatever ends the program, at most one of each thread is lost.
class ExperimentFolder {
public:
    /// @throw Error where a study is in the folder and none continues or is replaced, or the one
    /// that is there is another study; FileError
    ExperimentFolder(std::filesystem::path folder, const Study& study, FolderUse use);
    /// Trials that began and were not kept leave nothing.
    ~ExperimentFolder();
    ExperimentFolder(const ExperimentFolder&) = delete;
    ExperimentFolder& operator=(const ExperimentFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const noexcept { return claim_.path(); }
    [[nodiscard]] const Study& study() const noexcept { return study_; }
    /// In the order of their numbers and attempts. Not while others keep trials.
    [[nodiscard]] const std::vector<TrialRecord>& trials() const noexcept { return trials_; }

    /// The next attempt at a trial; none: one counts already. Any thread.
    [[nodiscard]] std::optional<PlannedTrial> nextAttempt(const PlannedTrial& trial) const;
    /// An empty folder for a trial that begins: keep() puts it in place. Any thread.
    [[nodiscard]] std::filesystem::path begin(const PlannedTrial& trial) const;
    /// A trial has ended: its moments go into the folder of begin(), which takes its place, and it
    /// gets its row. Any thread. @throw Error, FileError
    void keep(const DoneTrial& trial);

    /// A trial that is there does not count, and is repeated. Any thread.
    /// @param why in one line @throw Error without such a trial; FileError
    void strikeOut(const PlannedTrial& trial, const std::string& why);

    /// Read again. @throw InputError
    [[nodiscard]] std::vector<TrialMoment> momentsOf(const TrialRecord& trial) const;

private:
    void take(FolderUse use);
    void removeHalfTrials() const noexcept;
    void requireSameStudy() const;
    void writeTable(std::vector<TrialRecord> trials);
    [[nodiscard]] std::filesystem::path folderOf(const PlannedTrial& trial) const;
    [[nodiscard]] std::filesystem::path stagingOf(const PlannedTrial& trial) const;

    ClaimedFolder claim_;
    const Study& study_;
    mutable std::mutex mutex_;
    std::vector<TrialRecord> trials_;
};

/// Returns whether a study lies in a folder.
[[nodiscard]] bool holdsStudy(const std::filesystem::path& folder);

/// Returns whether it is this study. @throw InputError where it cannot be read
[[nodiscard]] bool holdsStudy(const std::filesystem::path& folder, const Study& study);

/// The first trial that is none of these planned ones: of another seed or number of participants;
/// none: all are planned.
[[nodiscard]] std::optional<TrialRecord> unplannedTrial(std::span<const TrialRecord> trials,
                                                        std::span<const PlannedTrial> planned);

/// Refuses such a trial. @throw Error
void requirePlanned(const ExperimentFolder& folder, std::span<const PlannedTrial> planned);

}  // namespace asperity
