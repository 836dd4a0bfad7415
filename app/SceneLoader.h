#pragma once

#include "app/LoadedScene.h"

#include <QObject>
#include <QString>

#include <filesystem>
#include <memory>
#include <thread>

namespace asperity {

/// Loads scenes on a thread of its own, so that the window goes on while a large scan is fitted.
/// A second request while one is under way waits for it to end, and only the last one counts.
class SceneLoader : public QObject {
    Q_OBJECT

public:
    explicit SceneLoader(QObject* parent = nullptr);
    ~SceneLoader() override;
    SceneLoader(const SceneLoader&) = delete;
    SceneLoader& operator=(const SceneLoader&) = delete;

    void load(const std::filesystem::path& input);

Q_SIGNALS:
    void loaded(std::shared_ptr<asperity::LoadedScene> scene);
    void failed(QString reason);

private:
    void begin();
    void end(const std::shared_ptr<LoadedScene>& scene, const QString& reason);

    std::filesystem::path next_;  ///< empty: nothing is asked for
    bool busy_ = false;
    std::thread thread_;
};

}  // namespace asperity
