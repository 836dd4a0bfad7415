#include "core/experiment/StudyFindings.h"

#include "core/FormattedText.h"

#include <utility>

namespace asperity {

namespace {

std::string textOf(const Estimate& estimate, const char* unit) {
    return estimate.hasInterval() ? formatted("%.3g (%.3g to %.3g) %s", estimate.mean, estimate.low,
                                              estimate.high, unit)
                                  : "–";
}

/// What is measured of both of two conditions.
struct Measure {
    TrialValue value;
    const char* unit;
};

const Measure kError{&TrialRecord::errorPercent, "%"};
const Measure kTime{&TrialRecord::time, "s"};

/// The trials of one study, and what they say.
class Findings {
public:
    Findings(const Study& study, std::span<const TrialRecord> trials)
        : study_(study), trials_(trials) {}

    /// `more` has larger values than `less`.
    void isMore(const std::string& paper, const TrialChoice& more, const TrialChoice& less,
                const Measure& measure) {
        const Estimate difference = differenceOf(more, less, measure.value);
        add(paper, "difference " + textOf(difference, measure.unit),
            !difference.hasInterval() ? FindingVerdict::NotTested
            : difference.isAbove(0.0) ? FindingVerdict::Agrees
            : difference.isBelow(0.0) ? FindingVerdict::Differs
                                      : FindingVerdict::Open);
    }

    /// Nothing differs: an interval that leaves out 0 differs.
    void isNothing(const std::string& paper, const std::vector<Estimate>& values,
                   const char* unit) {
        std::string ours;
        FindingVerdict verdict = FindingVerdict::NotTested;
        for (const Estimate& value : values) {
            if (!value.hasInterval()) {
                continue;
            }
            ours += (ours.empty() ? "" : "; ") + textOf(value, unit);
            const bool isSome = value.isAbove(0.0) || value.isBelow(0.0);
            if (isSome || verdict == FindingVerdict::NotTested) {
                verdict = isSome ? FindingVerdict::Differs : FindingVerdict::Agrees;
            }
        }
        add(paper, ours, verdict);
    }

    void add(const std::string& paper, const std::string& ours, FindingVerdict verdict) {
        findings_.push_back({.paper = paper, .ours = ours, .verdict = verdict});
    }

    [[nodiscard]] Estimate differenceOf(const TrialChoice& one, const TrialChoice& other,
                                        const TrialValue& value) const {
        return pairedDifference(participantMeans(trials_, one, value),
                                participantMeans(trials_, other, value));
    }

    [[nodiscard]] TrialChoice task(TaskKind kind) const {
        return [this, kind](const TrialRecord& trial) {
            return study_.tasks.at(trial.plan.task).kind == kind;
        };
    }
    [[nodiscard]] TrialChoice on(TaskKind kind, const std::string& material) const {
        return [this, kind, material](const TrialRecord& trial) {
            return study_.tasks.at(trial.plan.task).kind == kind &&
                   study_.materials.at(trial.plan.material).name == material;
        };
    }

    [[nodiscard]] std::vector<StudyFinding> take() { return std::move(findings_); }

private:
    const Study& study_;
    std::span<const TrialRecord> trials_;
    std::vector<StudyFinding> findings_;
};

Estimate estimateIn(const std::vector<StudyEstimate>& statistics, StudyQuantity quantity,
                    TaskKind task) {
    const StudyEstimate* const found = find(statistics, quantity, task);
    return found == nullptr ? Estimate{} : found->value;
}

/// The paper relates time and error in C alone.
void addRelation(const std::vector<StudyEstimate>& statistics, Findings& findings) {
    const auto relation = [&](TaskKind task) {
        return estimateIn(statistics, StudyQuantity::TimeAndError, task);
    };
    const auto isSome = [](const Estimate& value) {
        return value.isAbove(0.0) || value.isBelow(0.0);
    };
    const Estimate above = relation(TaskKind::Above);
    const Estimate on = relation(TaskKind::On);
    const Estimate below = relation(TaskKind::Below);
    const bool isTold = above.count > 3 && on.count > 3 && below.count > 3;
    const bool isOnlyThere = isSome(below) && !isSome(above) && !isSome(on);
    findings.add("time and error are related in C alone",
                 "correlation in A " + textOf(above, "") + "; B " + textOf(on, "") + "; C " +
                     textOf(below, ""),
                 !isTold       ? FindingVerdict::NotTested
                 : isOnlyThere ? FindingVerdict::Agrees
                               : FindingVerdict::Differs);
}

}  // namespace

std::vector<StudyFinding> findingsOf(const Study& study, std::span<const TrialRecord> trials) {
    const std::vector<StudyEstimate> statistics = studyStatistics(study, trials);
    const std::string oxide = "silicon_oxide";
    const std::string polystyrene = "polystyrene";
    const std::string rubber = "silicone_rubber";
    const TaskKind a = TaskKind::Above;
    const TaskKind b = TaskKind::On;
    const TaskKind c = TaskKind::Below;
    Findings findings(study, trials);
    findings.isMore("the error is larger in B than in C", findings.task(b), findings.task(c),
                    kError);
    findings.isMore("the error is larger in C than in A", findings.task(c), findings.task(a),
                    kError);
    std::vector<Estimate> between;
    for (const auto& [one, other] : {std::pair(oxide, polystyrene), std::pair(polystyrene, rubber),
                                     std::pair(oxide, rubber)}) {
        between.push_back(findings.differenceOf(findings.on(a, one), findings.on(a, other),
                                                &TrialRecord::errorPercent));
    }
    findings.isNothing("in A the error is about the same on all materials", between, "%");
    findings.isMore("in B the error is larger on silicon oxide than on rubber",
                    findings.on(b, oxide), findings.on(b, rubber), kError);
    findings.isMore("in C the error is larger on rubber than on polystyrene",
                    findings.on(c, rubber), findings.on(c, polystyrene), kError);
    findings.isMore("in C polystyrene takes longer than rubber", findings.on(c, polystyrene),
                    findings.on(c, rubber), kTime);
    std::vector<Estimate> errors;
    std::vector<Estimate> times;
    for (const TaskKind task : {a, b, c}) {
        errors.push_back(estimateIn(statistics, StudyQuantity::ErrorLearning, task));
        times.push_back(estimateIn(statistics, StudyQuantity::TimeLearning, task));
    }
    findings.isNothing("the error does not change from repeat to repeat", errors, "% a repeat");
    findings.isNothing("the time does not change from repeat to repeat", times, "s a repeat");
    addRelation(statistics, findings);
    return findings.take();
}

}  // namespace asperity
