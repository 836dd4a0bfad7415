#include "app/session/SceneLoader.h"

#include <utility>

namespace asperity {

/// Tells the window's thread how far the loader's thread is.
class SceneLoader::Report : public Progress {
public:
    explicit Report(SceneLoader& loader) : loader_(loader) {}

    void report(double fraction) override {
        QMetaObject::invokeMethod(
            &loader_,
            [&loader = loader_, fraction] {
                if (!loader.cancelled_) {
                    Q_EMIT loader.progressed(fraction);
                }
            },
            Qt::QueuedConnection);
    }
    [[nodiscard]] bool isCancelled() const override { return loader_.cancelled_; }

private:
    SceneLoader& loader_;
};

SceneLoader::SceneLoader(QObject* parent) : QObject(parent) {}

SceneLoader::~SceneLoader() {
    cancel();
    if (thread_.joinable()) {
        thread_.join();
    }
}

void SceneLoader::load(const std::filesystem::path& input) {
    cancel();
    next_ = input;
    if (!busy_) {
        begin();
    }
}

void SceneLoader::cancel() {
    next_.clear();
    cancelled_ = true;
}

// One at a time: two large scans at once may be more than the memory holds.
void SceneLoader::begin() {
    busy_ = true;
    cancelled_ = false;
    thread_ = std::thread([this, input = std::exchange(next_, {})] {
        QMetaObject::invokeMethod(
            this, [this, outcome = outcomeOf(input)] { end(outcome); }, Qt::QueuedConnection);
    });
}

SceneLoader::Outcome SceneLoader::outcomeOf(const std::filesystem::path& input) {
    Report report(*this);
    try {
        return {.scene = std::make_shared<LoadedScene>(loadScene(input, {}, &report)),
                .reason = nullptr};
    } catch (...) {
        return {.scene = nullptr, .reason = std::current_exception()};
    }
}

void SceneLoader::end(const Outcome& outcome) {
    thread_.join();
    busy_ = false;
    if (!next_.empty()) {
        begin();
    } else if (cancelled_) {
        return;
    } else if (outcome.scene) {
        Q_EMIT loaded(outcome.scene);
    } else {
        Q_EMIT failed(outcome.reason);
    }
}

}  // namespace asperity
