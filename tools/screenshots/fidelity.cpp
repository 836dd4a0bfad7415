/// Opens the fidelity panel on a scene, measures, and saves what the panel shows.
/// Usage: asperity_fidelity_picture SCENE_OR_SCAN OUT.png

#include "app/commands/VirtualDisplay.h"
#include "app/loading/SceneLoader.h"
#include "app/window/fidelity/FidelityPanel.h"
#include "app/window/lab/LiveWindow.h"
#include "core/Error.h"
#include "tools/screenshots/PictureTool.h"
#include "ui/shell/Menus.h"

#include <QAction>
#include <QPixmap>
#include <QPushButton>
#include <QTimer>

#include <string>

namespace asperity {

namespace {

int run(char** argv) {
    const VirtualDisplay display;
    LiveWindow live;
    live.stage().runs().use(loadScene(argv[1], {}));
    live.window().menus().entry("fidelity").trigger();
    FidelityPanel& panel = *live.window().findChild<FidelityPanel*>();
    panel.findChild<QPushButton*>(QStringLiteral("fidelityDetails"))->click();
    panel.findChild<QPushButton*>(QStringLiteral("measure"))->click();
    QTimer timer;
    QObject::connect(&timer, &QTimer::timeout, &panel, [&] {
        if (panel.tradeOff()) {
            panel.grab().save(QString::fromUtf8(argv[2]));
            live.window().close();
        }
    });
    timer.start(100);
    QTimer::singleShot(120000, &live.window(), &QWidget::close);
    const int status = live.exec();
    if (!panel.tradeOff()) {
        throw Error("the scene was not measured within two minutes");
    }
    return status;
}

}  // namespace

}  // namespace asperity

int main(int argc, char** argv) {
    return asperity::runPictureTool({argv, static_cast<std::size_t>(argc)}, 2,
                                    "asperity_fidelity_picture SCENE_OR_SCAN OUT.png",
                                    asperity::run);
}
