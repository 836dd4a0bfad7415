#pragma once

#include "app/program/LoadedScene.h"

#include <QObject>

#include <atomic>
#include <exception>
#include <filesystem>
#include <memory>
#include <thread>

namespace asperity {

/// Loads scenes on a thread of its own, so that the window goes on while a large scan is fitted.
/// Only the last request counts: it cancels one that is under way.
class SceneLoader : public QObject {
    Q_OBJECT

public:
    explicit SceneLoader(QObject* parent = nullptr);
    /// Cancels what is under way and waits for its end.
    ~SceneLoader() override;
    SceneLoader(const SceneLoader&) = delete;
    SceneLoader& operator=(const SceneLoader&) = delete;

    void load(const std::filesystem::path& input);
    /// From now on nothing comes of what is under way.
    void cancel();

Q_SIGNALS:
    /// @param fraction of the work that is done, 0..1
    void progressed(double fraction);
    void loaded(std::shared_ptr<asperity::LoadedScene> scene);
    void failed(std::exception_ptr reason);

private:
    class Report;
    struct Outcome {
        std::shared_ptr<LoadedScene> scene;  ///< null: there is a reason
        std::exception_ptr reason;
    };

    void begin();
    void end(const Outcome& outcome);
    [[nodiscard]] Outcome outcomeOf(const std::filesystem::path& input);

    std::filesystem::path next_;  ///< empty: nothing is asked for
    bool busy_ = false;
    std::atomic<bool> cancelled_ = false;
    std::thread thread_;
};

}  // namespace asperity
