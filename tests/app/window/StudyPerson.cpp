// A person who begins and ends the trials of a study by the button, until the program is killed.
// Usage: StudyPerson STUDY FOLDER

#include "app/session/LiveWindow.h"
#include "ui/window/WindowMenus.h"

#include <QAction>
#include <QPushButton>
#include <QTimer>

namespace {

constexpr int kPeriod = 650;  // [ms]

}  // namespace

int main(int /*argc*/, char** argv) {
    asperity::LiveWindow live;
    asperity::Session& session = live.session();
    session.scenes().open(std::filesystem::path(argv[1]).parent_path() / "scene.toml");
    const auto startStudy = [&] {
        if (session.runs().fixedBy().isEmpty()) {
            session.studies().choice().chooseStudy(argv[1]);
            session.studies().choice().chooseFolder(argv[2]);
            live.window().findChild<QPushButton*>("startStudy")->click();
        }
    };
    QObject::connect(&session.runs(), &asperity::RunControl::started, startStudy);
    QTimer presses;
    QObject::connect(&presses, &QTimer::timeout, [&] { live.window().menus().trial->trigger(); });
    presses.start(kPeriod);
    return live.exec();
}
