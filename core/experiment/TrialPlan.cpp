#include "core/experiment/TrialPlan.h"

#include "core/Error.h"
#include "core/Random.h"
#include "core/haptics/DevicePath.h"
#include "core/scene/Scene.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace asperity {

namespace {

std::vector<std::size_t> shuffled(std::size_t count, Random& random) {
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    for (std::size_t i = count; i > 1; --i) {
        const auto other = static_cast<std::size_t>(random.uniform() * static_cast<double>(i));
        std::swap(order[i - 1], order[other]);
    }
    return order;
}

/// Conditions in orders that the seed has drawn.
class Balance {
public:
    Balance(std::vector<std::size_t> conditions, Random& random)
        : conditions_(std::move(conditions)), names_(shuffled(conditions_.size(), random)) {}

    [[nodiscard]] std::vector<std::size_t> order(std::size_t row) const {
        std::vector<std::size_t> order = balancedOrder(conditions_.size(), row);
        for (std::size_t& condition : order) {
            condition = conditions_[names_[condition]];
        }
        return order;
    }

private:
    std::vector<std::size_t> conditions_;
    std::vector<std::size_t> names_;
};

std::vector<std::size_t> numbers(std::size_t count) {
    std::vector<std::size_t> all(count);
    std::iota(all.begin(), all.end(), std::size_t{0});
    return all;
}

std::uint64_t seedOf(std::uint64_t study, int participant, int trial) {
    std::uint64_t state = study;
    state ^= splitMix64(state) + static_cast<std::uint64_t>(participant);
    state ^= splitMix64(state) + static_cast<std::uint64_t>(trial);
    return splitMix64(state);
}

/// The trials of a study, whoever does them.
class Planner {
public:
    Planner(const Study& study, std::uint64_t seed) : study_(study), seed_(seed), random_(seed) {
        for (const StudyTask& task : study.tasks) {
            materials_.emplace_back(task.materials, random_);
        }
    }

    void addParticipant(int participant) {
        participant_ = participant;
        trial_ = 0;
        for (int repeat = 1; repeat <= study_.repeats; ++repeat) {
            addRepeat(repeat);
        }
    }

    [[nodiscard]] std::vector<PlannedTrial> take() { return std::move(trials_); }

private:
    void addRepeat(int repeat) {
        const auto row = static_cast<std::size_t>((participant_ - 1) * study_.repeats + repeat - 1);
        for (const std::size_t task : tasks_.order(row)) {
            for (const std::size_t lever : levers_.order(row)) {
                for (const std::size_t material : materials_[task].order(row)) {
                    add({.participant = participant_,
                         .task = task,
                         .material = material,
                         .lever = lever,
                         .repeat = repeat});
                }
            }
        }
    }

    void add(PlannedTrial trial) {
        trial.number = static_cast<int>(trials_.size()) + 1;
        trial.seed = seedOf(seed_, participant_, ++trial_);
        Random random(trial.seed);
        trial.target =
            static_cast<std::size_t>(random.uniform() * static_cast<double>(study_.targets.size()));
        const StudyTask& task = study_.tasks[trial.task];
        const double distance = random.uniform(task.nearest, task.farthest);
        trial.height = task.kind == TaskKind::Below ? -distance : distance;
        trials_.push_back(trial);
    }

    const Study& study_;
    std::uint64_t seed_;
    Random random_;
    Balance tasks_{numbers(study_.tasks.size()), random_};
    Balance levers_{numbers(study_.levers.size()), random_};
    std::vector<Balance> materials_;  ///< of each task
    int participant_ = 0;
    int trial_ = 0;
    std::vector<PlannedTrial> trials_;
};

/// In an order of its own, which a script can repeat to the bit.
double distance(const Vector3& a, const Vector3& b) {
    const Vector3 way = a - b;
    return std::sqrt((way.x() * way.x() + way.y() * way.y()) + way.z() * way.z());
}

/// Between the extremes of each axis, the largest.
double handleMotion(const std::vector<TrialMoment>& moments) {
    constexpr double kLastPart = 0.5;  // [s]
    Vector3 low = moments.back().device;
    Vector3 high = low;
    for (const TrialMoment& moment : moments) {
        if (moment.time >= moments.back().time - kLastPart) {
            low = low.cwiseMin(moment.device);
            high = high.cwiseMax(moment.device);
        }
    }
    return (high - low).maxCoeff();
}

}  // namespace

PlannedTrial again(PlannedTrial trial) {
    ++trial.attempt;
    std::uint64_t state = trial.seed;
    trial.seed = splitMix64(state);
    return trial;
}

std::vector<std::size_t> balancedOrder(std::size_t count, std::size_t row) {
    std::vector<std::size_t> order(count);
    const std::size_t shift = row % std::max<std::size_t>(count, 1);
    for (std::size_t i = 0; i < count; ++i) {  // 0, 1, n - 1, 2, n - 2, ...
        const std::size_t step = i % 2 == 1 ? (i + 1) / 2 : (count - i / 2) % count;
        order[i] = (step + shift) % count;
    }
    if (count % 2 == 1 && (row / count) % 2 == 1) {
        std::reverse(order.begin(), order.end());
    }
    return order;
}

std::vector<PlannedTrial> planTrials(const Study& study, int participants, std::uint64_t seed) {
    Planner planner(study, seed);
    for (int participant = 1; participant <= participants; ++participant) {
        planner.addParticipant(participant);
    }
    return planner.take();
}

TrialPositions positionsOf(const Study& study, const Scene& scene, const PlannedTrial& trial) {
    const Vector2 middle = 0.5 * Vector2(scene.surface.sizeX(), scene.surface.sizeY());
    const auto above = [&](const Vector2& at, double height) {
        return Vector3(at.x(), at.y(), touchHeight(scene, at.x(), at.y()) + height);
    };
    return {.start = above(middle, study.startHeight),
            .target = above(middle + study.targets.at(trial.target), trial.height)};
}

TrialMoment momentOf(const TickSample& sample, double time, const Vector3& tip) {
    return {.time = time,
            .tip = tip,
            .shown = sample.output.model.tip,
            .device = sample.input.device.position,
            .force = sample.output.estimate.force,
            .deviceForce = sample.output.deviceForce};
}

void evaluate(DoneTrial& trial) {
    if (trial.moments.empty()) {
        throw Error("a trial without a moment has no result");
    }
    TrialRecord& record = trial.record;
    const TrialMoment& end = trial.moments.back();
    record.error = distance(end.tip, record.target);
    record.errorPercent = 100.0 * record.error / distance(record.start, record.target);
    record.time = end.time;
    record.handleMotion = handleMotion(trial.moments);
    record.largestForce = 0.0;
    for (const TrialMoment& moment : trial.moments) {
        record.largestForce = std::max(record.largestForce, moment.largestForce);
    }
}

}  // namespace asperity
