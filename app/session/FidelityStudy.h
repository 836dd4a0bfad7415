#pragma once

#include "core/studies/TradeOffStudy.h"

#include <QObject>

#include <atomic>
#include <exception>
#include <memory>
#include <thread>

namespace asperity {

/// Measures speed against accuracy of a scene on a thread of its own, one study at a time.
class FidelityStudy : public QObject {
    Q_OBJECT

public:
    explicit FidelityStudy(QObject* parent = nullptr);
    /// Cancels what is under way.
    ~FidelityStudy() override;
    FidelityStudy(const FidelityStudy&) = delete;
    FidelityStudy& operator=(const FidelityStudy&) = delete;

    /// Nothing is under way. @param scene a copy: the study changes its model
    void start(std::unique_ptr<Scene> scene);
    [[nodiscard]] bool isBusy() const { return thread_.joinable(); }
    /// The scene is another one, or nobody wants to know any more: what is under way ends early.
    void cancel() { cancelled_ = true; }

Q_SIGNALS:
    void progressed(double fraction);
    /// @param study null: it was cancelled
    void finished(std::shared_ptr<const asperity::TradeOff> study);
    void failed(std::exception_ptr reason);

private:
    struct Outcome {
        std::shared_ptr<const TradeOff> study;  ///< null: there is a reason
        std::exception_ptr reason;
    };

    class Report;

    [[nodiscard]] Outcome outcomeOf(Scene& scene);
    void end(const Outcome& outcome);

    std::atomic<bool> cancelled_ = false;
    std::thread thread_;
};

/// Whether the scan is small enough to be copied for a study.
[[nodiscard]] bool canBeStudied(const Scene& scene) noexcept;

}  // namespace asperity
