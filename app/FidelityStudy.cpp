#include "app/FidelityStudy.h"

#include <utility>

namespace asperity {

namespace {

constexpr long kMostPixels = 2048L * 2048L;

/// Force errors are those of `asperity tradeoff`; times are of fewer rounds, so that it takes
/// seconds, and pictures are not shown.
constexpr TradeOffPlan kPlan{.duration = 2.0, .rounds = 3, .patches = 1};

}  // namespace

bool canBeStudied(const Scene& scene) noexcept {
    const auto& grid = scene.surface.grid();
    return static_cast<long>(grid.columns) * grid.rows <= kMostPixels;
}

FidelityStudy::FidelityStudy(QObject* parent) : QObject(parent) {}

FidelityStudy::~FidelityStudy() {
    if (thread_.joinable()) {
        thread_.join();
    }
}

void FidelityStudy::start(std::unique_ptr<Scene> scene) {
    dropped_ = false;
    thread_ = std::thread([this, own = std::move(scene)] {
        QMetaObject::invokeMethod(
            this, [this, outcome = outcomeOf(*own)] { end(outcome); }, Qt::QueuedConnection);
    });
}

FidelityStudy::Outcome FidelityStudy::outcomeOf(Scene& scene) {
    try {
        return {.study = std::make_shared<const TradeOff>(studyTradeOff(scene, kPlan)),
                .reason = nullptr};
    } catch (...) {
        return {.study = nullptr, .reason = std::current_exception()};
    }
}

void FidelityStudy::end(const Outcome& outcome) {
    thread_.join();
    if (dropped_) {
        Q_EMIT finished(nullptr);
    } else if (outcome.study) {
        Q_EMIT finished(outcome.study);
    } else {
        Q_EMIT failed(outcome.reason);
    }
}

}  // namespace asperity
