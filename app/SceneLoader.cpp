#include "app/SceneLoader.h"

#include <exception>
#include <new>
#include <utility>

namespace asperity {

SceneLoader::SceneLoader(QObject* parent) : QObject(parent) {}

SceneLoader::~SceneLoader() {
    if (thread_.joinable()) {
        thread_.join();
    }
}

void SceneLoader::load(const std::filesystem::path& input) {
    next_ = input;
    if (!busy_) {
        begin();
    }
}

void SceneLoader::begin() {
    busy_ = true;
    thread_ = std::thread([this, input = std::exchange(next_, {})] {
        std::shared_ptr<LoadedScene> scene;
        QString reason;
        try {
            scene = std::make_shared<LoadedScene>(loadScene(input, {}));
        } catch (const std::bad_alloc&) {
            reason = "out of memory";
        } catch (const std::exception& error) {
            reason = QString::fromStdString(error.what());
        }
        QMetaObject::invokeMethod(
            this, [this, scene, reason] { end(scene, reason); }, Qt::QueuedConnection);
    });
}

void SceneLoader::end(const std::shared_ptr<LoadedScene>& scene, const QString& reason) {
    thread_.join();
    if (!next_.empty()) {
        begin();
        return;
    }
    busy_ = false;
    if (scene) {
        Q_EMIT loaded(scene);
    } else {
        Q_EMIT failed(reason);
    }
}

}  // namespace asperity
