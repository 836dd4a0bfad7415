#include "core/deformation/HalfSpaceWorker.h"

#include "core/deformation/HalfSpaceModel.h"
#include "core/scene/Scene.h"

#include <exception>
#include <utility>

namespace asperity {

namespace {

bool isSame(const TipState& first, const TipState& second) {
    return first.tip == second.tip && first.contact.indentation == second.contact.indentation &&
           first.contact.branch == second.contact.branch;
}

/// A thread may not throw: what cannot be solved counts as not converged.
HalfSpaceAnswer answerTo(HalfSpaceModel& model, const Scene& scene, const TipState& state,
                         const std::stop_token& stop) {
    try {
        return model.solve(scene, state, stop);
    } catch (const std::exception&) {
        return {.verdict = HalfSpaceVerdict::NotConverged, .state = state, .field = nullptr};
    }
}

}  // namespace

HalfSpaceWorker::HalfSpaceWorker(const Scene& scene)
    : scene_(scene), thread_([this](const std::stop_token& stop) { work(stop); }) {}

HalfSpaceWorker::~HalfSpaceWorker() = default;

void HalfSpaceWorker::ask(const TipState& state) {
    if (isSame(state, asked_)) {
        return;
    }
    asked_ = state;
    {
        const std::lock_guard lock(mutex_);
        next_ = state;
    }
    waiting_.notify_one();
}

std::shared_ptr<const HalfSpaceAnswer> HalfSpaceWorker::newest() const {
    const std::lock_guard lock(mutex_);
    return newest_;
}

void HalfSpaceWorker::work(const std::stop_token& stop) {
    HalfSpaceModel model;
    while (true) {
        std::unique_lock lock(mutex_);
        if (!waiting_.wait(lock, stop, [this] { return next_.has_value(); })) {
            return;
        }
        const TipState state = *std::exchange(next_, std::nullopt);
        lock.unlock();
        auto answer = std::make_shared<const HalfSpaceAnswer>(answerTo(model, scene_, state, stop));
        lock.lock();
        newest_ = std::move(answer);
    }
}

}  // namespace asperity
