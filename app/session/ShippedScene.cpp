#include "app/session/ShippedScene.h"

#include "app/program/DataFolder.h"
#include "app/session/Session.h"

#include <memory>

namespace asperity {

void showShippedInstead(Session& session) {
    SceneControl& scenes = session.scenes();
    auto* const once = new QObject(&session);
    const auto show = [&session, once] {
        once->deleteLater();
        const std::filesystem::path shipped = defaultSceneFile();
        if (session.run() == nullptr && !shipped.empty()) {
            session.scenes().open(shipped);
        }
    };
    // A file that fails without a question ends the program.
    const auto isAsked = std::make_shared<bool>(false);
    QObject::connect(&scenes, &SceneControl::scaleAsked, once, [isAsked] { *isAsked = true; });
    QObject::connect(&scenes, &SceneControl::openCanceled, once, show);
    QObject::connect(&scenes, &SceneControl::openFailed, once, [isAsked, show] {
        if (*isAsked) {
            show();
        }
    });
    QObject::connect(&session.runs(), &RunControl::begun, once, &QObject::deleteLater);
}

}  // namespace asperity
