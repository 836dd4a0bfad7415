// A person who begins and ends the trials of a study by the button, until the program is killed.
// Usage: StudyPerson STUDY FOLDER

#include "app/window/Stage.h"
#include "app/window/lab/LiveWindow.h"
#include "app/window/scene/SceneControl.h"
#include "app/window/study/StudyControl.h"
#include "ui/shell/Menus.h"

#include <QAction>
#include <QPushButton>
#include <QTimer>

namespace {

constexpr int kPeriod = 650;  // [ms]

}  // namespace

int main(int /*argc*/, char** argv) {
    asperity::LiveWindow live;
    asperity::Stage& stage = live.stage();
    stage.get<asperity::SceneControl>().open(std::filesystem::path(argv[1]).parent_path() /
                                             "scene.toml");
    const auto startStudy = [&] {
        if (stage.runs().fixedBy().isEmpty()) {
            stage.get<asperity::StudyControl>().choice().chooseStudy(argv[1]);
            stage.get<asperity::StudyControl>().choice().chooseFolder(argv[2]);
            live.window().findChild<QPushButton*>("startStudy")->click();
        }
    };
    QObject::connect(&stage.runs(), &asperity::RunControl::started, startStudy);
    QTimer presses;
    QObject::connect(&presses, &QTimer::timeout,
                     [&] { live.window().menus().entry("trial").trigger(); });
    presses.start(kPeriod);
    return live.exec();
}
