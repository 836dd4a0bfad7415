#pragma once

#include "core/fidelity/TradeOffStudy.h"

#include <QObject>

#include <exception>
#include <memory>
#include <thread>

namespace asperity {

/// Measures speed against accuracy of a scene on a thread of its own, one study at a time.
class FidelityStudy : public QObject {
    Q_OBJECT

public:
    explicit FidelityStudy(QObject* parent = nullptr);
    /// Waits for the end of what is under way: some seconds.
    ~FidelityStudy() override;
    FidelityStudy(const FidelityStudy&) = delete;
    FidelityStudy& operator=(const FidelityStudy&) = delete;

    /// Nothing is under way. @param scene a copy: the study changes its model
    void start(std::unique_ptr<Scene> scene);
    [[nodiscard]] bool isBusy() const { return thread_.joinable(); }
    /// The scene is another one: from now on nothing comes of what is under way but its end.
    void drop() { dropped_ = true; }

Q_SIGNALS:
    /// @param study null: it was dropped
    void finished(std::shared_ptr<const asperity::TradeOff> study);
    void failed(std::exception_ptr reason);

private:
    struct Outcome {
        std::shared_ptr<const TradeOff> study;  ///< null: there is a reason
        std::exception_ptr reason;
    };

    [[nodiscard]] static Outcome outcomeOf(Scene& scene);
    void end(const Outcome& outcome);

    bool dropped_ = false;
    std::thread thread_;
};

/// Whether the scan is small enough to be copied for a study.
[[nodiscard]] bool canBeStudied(const Scene& scene) noexcept;

}  // namespace asperity
