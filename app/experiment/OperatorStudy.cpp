#include "app/experiment/OperatorStudy.h"

#include "app/recording/Recording.h"
#include "core/ShareOut.h"
#include "core/experiment/StudyChecks.h"
#include "core/experiment/TrialRun.h"

#include <optional>

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
                              recording.emplace(RecordingPlace{.folder = folder}, loaded, memory,
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

}  // namespace asperity
