/// Opens the live window with the simulated device, presses the tip into the sample beside a guide,
/// and saves what the window shows.
/// Usage: asperity_device_picture SCENE_OR_SCAN WIDTH HEIGHT OUT.png

#include "app/commands/VirtualDisplay.h"
#include "app/loading/SceneLoader.h"
#include "app/window/Stage.h"
#include "app/window/ViewControl.h"
#include "app/window/device/DeviceControl.h"
#include "app/window/lab/LiveWindow.h"
#include "core/Error.h"
#include "tools/screenshots/PictureTool.h"
#include "ui/shell/Menus.h"

#include <QAction>
#include <QTimer>

#include <string>

namespace asperity {

namespace {

constexpr double kWay = 3.0;           // time to go in [s]
constexpr double kDepth = 1.2e-9;      // of the base below first touch [m]
constexpr double kPressing = 0.08;     // device force [N]
constexpr double kPictureAfter = 2.0;  // the guide is there [s]

DevicePath pathDown(const Scene& scene) {
    PathPlan plan{.duration = 4.0 * kWay, .indentation = kDepth, .slideLength = 12e-9};
    plan.position = startPosition(scene).head<2>();
    return slidePath(scene, plan);
}

int run(char** argv) {
    const VirtualDisplay display;
    LiveWindow live;
    live.window().resize(std::stoi(argv[2]), std::stoi(argv[3]));
    Stage& stage = live.stage();
    stage.runs().use(loadScene(argv[1], {}));
    stage.get<DeviceControl>().pilotDevice(pathDown(stage.run()->scene()));
    double guided = 0.0;
    bool saved = false;
    QTimer timer;
    QObject::connect(&timer, &QTimer::timeout, [&] {
        const TickSample sample = stage.run()->loop().snapshot().sample;
        if (guided == 0.0 && sample.output.deviceForce.z() > kPressing) {
            live.window().menus().entry("guidePlane").trigger();
            guided = sample.time;
        }
        if (!saved && guided > 0.0 && sample.time > guided + kPictureAfter) {
            stage.get<ViewControl>().savePicture(QString::fromUtf8(argv[4]));
            saved = true;
            live.window().close();
        }
    });
    timer.start(30);
    QTimer::singleShot(40000, &live.window(), &QWidget::close);
    const int status = live.exec();
    if (!saved) {
        throw Error("the device was not seen pressing");
    }
    return status;
}

}  // namespace

}  // namespace asperity

int main(int argc, char** argv) {
    return asperity::runPictureTool({argv, static_cast<std::size_t>(argc)}, 4,
                                    "asperity_device_picture SCENE_OR_SCAN WIDTH HEIGHT OUT.png",
                                    asperity::run);
}
