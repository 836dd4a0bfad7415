#pragma once

#include "app/program/LoadedScene.h"
#include "app/reports/page/ReportPage.h"
#include "app/runs/RunFolder.h"
#include "core/SiFormat.h"
#include "core/Vector.h"
#include "core/haptics/VirtualRun.h"
#include "core/haptics/cycle/CurveBranch.h"
#include "core/uncertainty/CycleBudgets.h"
#include "ui/plot/CycleTrace.h"

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace asperity {

/// The curve of a force cycle as it is drawn.
struct ForceCycleCurve {
    ContactCycle cycle;
    CycleTrace trace;
};

/// All that a report shows of a run, taken tick by tick. Events and curves are found as in
/// summary.json and the window; times count from the first tick.
class RunHistory {
public:
    static constexpr std::size_t kDrawnCycles = 6;  ///< the first of them are drawn

    void take(TickSample sample);

    [[nodiscard]] const RunEvents& events() const noexcept { return events_.events(); }
    /// Returns the curves of the first cycles.
    [[nodiscard]] const std::vector<ForceCycleCurve>& curves() const noexcept { return curves_; }
    /// Returns the curve of a run without a cycle: the tip moves in free air, or beside the sample.
    [[nodiscard]] const CycleTrace& present() const noexcept { return present_; }
    /// Returns the path of the tip's apex [m].
    [[nodiscard]] const std::vector<Vector3>& tipPath() const noexcept { return path_; }
    /// Ticks by the worst flag in them, but for flags of noisy signals, which say little in a tick;
    /// by Severity. Ticks without such a flag are in none.
    [[nodiscard]] const std::array<long, 4>& ticksBySeverity() const noexcept { return worst_; }
    /// Ticks with the force off, by what switched it off.
    [[nodiscard]] const std::map<Fault, long>& faults() const noexcept { return faults_; }
    [[nodiscard]] double duration() const noexcept { return last_; }  ///< [s]

private:
    void takeCurve(const TickSample& sample);
    void takeFlags(const TickOutput& out);

    RunEventRecorder events_;
    CycleDetector detector_;
    CycleTrace present_;
    std::int64_t number_ = 0;  ///< of the present cycle
    std::vector<ForceCycleCurve> curves_;
    std::vector<Vector3> path_;
    std::array<long, 4> worst_{};
    std::map<Fault, long> faults_;
    double first_ = 0.0;  ///< in the time of the loop [s]
    double last_ = 0.0;   ///< [s]
};

/// The hash of a file of a run.
struct HashedFile {
    std::string sha256;
    std::string file;  ///< path as the user gave it, or name in a bundle
};

/// A run, replayed, as its page describes it.
struct ReportedRun {
    std::string name;              ///< of the files of its page
    std::filesystem::path folder;  ///< or bundle, as the user gave it
    std::string scan;              ///< its file, or its name in the bundle; empty: a shape
    const LoadedScene& loaded;     ///< lives until its page is made
    RunHistory history;
    std::optional<RecordedProgram> program;  ///< that made it; none: its folder does not say
    std::optional<RecordedSummary> summary;  ///< none: the run was cut off
    std::string state;                 ///< that it was cut off, a sentence; empty: it is complete
    std::string difference;            ///< first tick that the replay has otherwise; empty: none
    std::optional<HashedFile> bundle;  ///< none: the run is a folder
    std::vector<HashedFile> hashes;    ///< of its files, in the bundle where there is one
    std::string overview;              ///< PNG
    std::string deformation;           ///< PNG; empty: the tip never touched
};

struct Scene;

/// A value to four digits in a given prefix, without unit: "12.34".
[[nodiscard]] std::string numberText(double value, const SiScale& scale);

/// A value with its standard deviation, which has two digits, without unit: "3.395 ± 0.086". Where
/// none is known (0) as numberText().
[[nodiscard]] std::string measuredText(const Reading& reading, const SiScale& scale);

/// The same of a value of which no more is known than the noise: "3.395 ± 0.086 (noise)".
[[nodiscard]] std::string noisyText(const Reading& reading, const SiScale& scale);

/// The same in a prefix of its own, with unit: "(3.395 ± 0.086) nN".
[[nodiscard]] std::string measuredText(const Reading& reading, const std::string& unit);

/// A sentence that begins with a capital.
[[nodiscard]] std::string capitalized(std::string sentence);

/// A share for people: "12 %"; what is not zero is not shown as zero: "< 0.1 %".
[[nodiscard]] std::string shareText(long part, long whole);

/// Validity of the results of a run.
struct RunVerdict {
    PageTone tone = PageTone::Plain;
    std::string brief;        ///< a few words, for a table
    std::string sentence;     ///< the same with numbers
    bool hasReasons = false;  ///< they are in the section on validity
};

[[nodiscard]] RunVerdict verdictOn(const RunHistory& history);

/// A force cycle with what is open in its readings.
struct BudgetedCycle {
    ContactCycle cycle;
    std::vector<CycleBudget> budgets;
};

[[nodiscard]] std::vector<BudgetedCycle> budgeted(const Scene& scene,
                                                  const std::vector<ContactCycle>& cycles);

/// A value over the cycles of a run that have it, with its standard deviation by noise, model and
/// calibration together: of one that value, of several their mean and the deviation of one of them,
/// by their scatter in the place of the noise. None: no cycle has it.
struct CycleMean {
    Reading reading;
    long cycles = 0;
    bool isModelKnown = true;  ///< false: the deviation is by noise or scatter alone
};

[[nodiscard]] std::optional<CycleMean> pullOffOf(const std::vector<BudgetedCycle>& cycles);
[[nodiscard]] std::optional<CycleMean> adhesionWorkOf(const std::vector<BudgetedCycle>& cycles);
[[nodiscard]] double maxIndentationOf(const std::vector<BudgetedCycle>& cycles);  ///< [m]

/// Adds what the cycles of a run show, with the values of `cycles` in summary.json.
void addForceCycles(PageContent& page, const std::vector<BudgetedCycle>& cycles);

/// The force–distance curves of the first cycles.
void addCurves(PageContent& page, const RunHistory& history);

/// Adds the uncertainty of the readings of the cycles by model and calibration, and which input
/// contributes most; nothing where the scene has it off or nothing touched.
void addUncertainty(PageContent& page, const Scene& scene,
                    const std::vector<BudgetedCycle>& cycles);

/// The deformed sample at the deepest indentation and before pull-off, and the numbers of these
/// moments as the contact model has them.
void addPictures(PageContent& page, const ReportedRun& run);

/// Adds what was touched and where: the scan, the source of its scale, the tip's position.
void addSample(PageContent& page, const ReportedRun& run);

/// Tip, lever, material and what else the forces follow from, each with its source; and where the
/// instrument is not what the model assumes.
void addParameters(PageContent& page, const Scene& scene);

/// Contact law and approximations of the model, with why they were taken, as the run recorded it.
void addModel(PageContent& page, const ReportedRun& run);

/// Adds where the results do not hold, in words: flags and faults with their ticks.
void addValidity(PageContent& page, const RunHistory& history);

/// Adds how to repeat the run: programs, commands, hashes, and whether the replay was the same.
void addReproduction(PageContent& page, const ReportedRun& run);

/// A text as one word of a POSIX shell's command line, quoted where that is needed.
[[nodiscard]] std::string shellWord(const std::string& text);

}  // namespace asperity
