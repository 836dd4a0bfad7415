#include "app/experiment/OpenStudy.h"

#include "app/recording/Recording.h"
#include "core/Error.h"
#include "core/ShareOut.h"
#include "core/experiment/Study.h"
#include "core/experiment/TrialRun.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace asperity {

namespace {

constexpr int kMaxAttempts = 5;

/// Does one trial after the other.
class TrialRunner {
public:
    TrialRunner(const StudyScenes& scenes, const OperatorRun& run, ExperimentFolder& folder)
        : scenes_(scenes), run_(run), folder_(folder) {}

    void complete(const PlannedTrial& trial, const CancelCheck& check) const {
        auto next = folder_.nextAttempt(trial);
        while (next && next->attempt <= kMaxAttempts) {
            check();
            folder_.keep(attempt(*next));
            next = folder_.nextAttempt(trial);
        }
    }

private:
    [[nodiscard]] DoneTrial attempt(const PlannedTrial& trial) const {
        const LoadedScene& loaded = scenes_.of(trial.material, trial.lever);
        const OperatorTraits person = operatorOf(run_.seed, trial.participant);
        const TrialSetup setup{.study = folder_.study(),
                               .scene = loaded.scene,
                               .person = person,
                               .bench = {.arm = person.arm}};
        const std::filesystem::path folder = folder_.begin(trial);
        if (!run_.record) {
            return runTrial(setup, trial);
        }
        std::optional<Recording> recording;
        DoneTrial done =
            runTrial(setup, trial,
                     {.begin =
                          [&](const TickMemory& memory) {
                              recording.emplace(RecordingTarget{.folder = folder}, loaded, memory,
                                                setup.bench.delay);
                          },
                      .tick = [&](const TickSample& sample) { recording->take(sample); }});
        recording->finish();
        return done;
    }

    const StudyScenes& scenes_;
    const OperatorRun& run_;
    ExperimentFolder& folder_;
};

}  // namespace

StudyScenes::StudyScenes(const Study& study, Progress* progress) : levers_(study.levers.size()) {
    if (!study.scene.truth.curve.empty()) {
        throw Error("the instrument of this study's scene plays a recorded curve ([truth] curve), "
                    "which is of one place: a study needs the whole sample");
    }
    const auto count = static_cast<double>(study.materials.size() * levers_);
    for (std::size_t material = 0; material < study.materials.size(); ++material) {
        for (std::size_t lever = 0; lever < levers_; ++lever) {
            const auto done = static_cast<double>(scenes_.size());
            ProgressPart part(progress, done / count, (done + 1.0) / count);
            scenes_.push_back(loadScene(sceneOf(study, material, lever), &part));
        }
    }
    checkStudyOn(study, {}, [&](std::size_t material, std::size_t lever) -> const Scene& {
        return of(material, lever).scene;
    });
}

void runOperators(const StudyScenes& scenes, const OperatorRun& run, ExperimentFolder& folder,
                  Progress* progress) {
    const std::vector<PlannedTrial> planned = planTrials(folder.study(), run.operators, run.seed);
    requirePlanned(folder, planned);
    const TrialRunner runner(scenes, run, folder);
    shareOut(static_cast<int>(planned.size()), progress, [&](int index, const CancelCheck& check) {
        runner.complete(planned[static_cast<std::size_t>(index)], check);
    });
}

namespace {

/// Seed of the orders of trials: the same in every study of people, so that no folder keeps one.
constexpr std::uint64_t kSeed = 1;

int lastParticipant(std::span<const TrialRecord> trials) {
    int last = 0;
    for (const TrialRecord& trial : trials) {
        last = std::max(last, trial.plan.participant);
    }
    return last;
}

}  // namespace

ParticipantStudy::ParticipantStudy(ExperimentFolder& folder, int participant)
    : folder_(folder), participant_(participant) {
    if (!areInOrderOfPeople(folder.study(), folder.trials())) {
        throw Error(folder.path().string() +
                    ": holds trials in another order, as of operators of a model; choose another "
                    "folder");
    }
    trials_ = planTrials(folder.study(), participant, kSeed);
    std::erase_if(trials_, [participant](const PlannedTrial& trial) {
        return trial.participant != participant;
    });
}

int ParticipantStudy::done() const {
    return static_cast<int>(std::ranges::count_if(
        trials_, [this](const PlannedTrial& trial) { return !folder_.nextAttempt(trial); }));
}

bool ParticipantStudy::isNew() const {
    return std::ranges::none_of(folder_.trials(), [this](const TrialRecord& trial) {
        return trial.plan.participant == participant_;
    });
}

std::optional<PlannedTrial> ParticipantStudy::next() const {
    for (const PlannedTrial& trial : trials_) {
        if (const auto attempt = folder_.nextAttempt(trial)) {
            return attempt;
        }
    }
    return std::nullopt;
}

bool areInOrderOfPeople(const Study& study, std::span<const TrialRecord> trials) {
    return !unplannedTrial(trials, planTrials(study, lastParticipant(trials), kSeed));
}

int participantToGoOn(const Study& study, std::span<const TrialRecord> trials) {
    const std::size_t perPerson = planTrials(study, 1, kSeed).size();
    for (int participant = 1;; ++participant) {
        const auto counting = std::ranges::count_if(trials, [participant](const TrialRecord& one) {
            return one.plan.participant == participant && one.counts();
        });
        if (static_cast<std::size_t>(counting) < perPerson) {
            return participant;
        }
    }
}

namespace {

Study requireForPeople(Study study) {
    if (!study.aids.coupling) {
        throw Error("[aids] coupling = false: without a coupling a study is for the operator model "
                    "only, see asperity experiment");
    }
    return study;
}

}  // namespace

OpenStudy::OpenStudy(Study wanted, const std::filesystem::path& out, int participant,
                     Progress* progress)
    : study(requireForPeople(std::move(wanted)))
    , scenes(study, progress)
    , folder(out, study, holdsStudy(out) ? FolderUse::Resume : FolderUse::New)
    , person(folder, participant) {}

}  // namespace asperity
