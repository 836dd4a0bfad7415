#include "app/session/FidelityStudy.h"

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

/// Carries the progress from the study's thread to the window's.
class FidelityStudy::Report : public Progress {
public:
    explicit Report(FidelityStudy& study) : study_(study) {}

    void report(double fraction) override {
        QMetaObject::invokeMethod(
            &study_, [&study = study_, fraction] { Q_EMIT study.progressed(fraction); },
            Qt::QueuedConnection);
    }
    [[nodiscard]] bool isCancelled() const override { return study_.cancelled_; }

private:
    FidelityStudy& study_;
};

FidelityStudy::FidelityStudy(QObject* parent) : QObject(parent) {}

FidelityStudy::~FidelityStudy() {
    cancel();
    if (thread_.joinable()) {
        thread_.join();
    }
}

void FidelityStudy::start(std::unique_ptr<Scene> scene) {
    cancelled_ = false;
    thread_ = std::thread([this, own = std::move(scene)] {
        QMetaObject::invokeMethod(
            this, [this, outcome = outcomeOf(*own)] { end(outcome); }, Qt::QueuedConnection);
    });
}

FidelityStudy::Outcome FidelityStudy::outcomeOf(Scene& scene) {
    try {
        Report report(*this);
        return {.study = std::make_shared<const TradeOff>(studyTradeOff(scene, kPlan, &report)),
                .reason = nullptr};
    } catch (const Cancelled&) {
        return {.study = nullptr, .reason = nullptr};
    } catch (...) {
        return {.study = nullptr, .reason = std::current_exception()};
    }
}

void FidelityStudy::end(const Outcome& outcome) {
    thread_.join();
    if (outcome.reason) {
        Q_EMIT failed(outcome.reason);
    } else {
        Q_EMIT finished(cancelled_ ? nullptr : outcome.study);
    }
}

}  // namespace asperity
