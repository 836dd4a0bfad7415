// A window whose scene changes every few milliseconds, until the program is killed. It says in a
// file which changes were made, and when. Usage: SessionEditor FOLDER SCENE LOG

#include "app/window/Stage.h"
#include "app/window/lab/LiveWindow.h"
#include "app/window/scene/SceneControl.h"
#include "app/window/session/SessionControl.h"

#include <QTimer>

#include <chrono>
#include <cstdio>
#include <fcntl.h>
#include <unistd.h>

namespace {

constexpr int kPeriod = 20;  // [ms]

double now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

}  // namespace

int main(int /*argc*/, char** argv) {
    const int log = open(argv[3], O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
    asperity::LiveWindow live;
    asperity::Stage& stage = live.stage();
    stage.get<asperity::SessionControl>().keepIn(argv[1]);
    stage.get<asperity::SceneControl>().open(argv[2]);
    QTimer edits;
    int count = 0;
    QObject::connect(&edits, &QTimer::timeout, [&] {
        if (const asperity::SceneDescription* const present = stage.edits().wanted()) {
            asperity::SceneDescription next = *present;
            next.setpoint = ++count * 1e-12;
            stage.edits().change(QStringLiteral("Setpoint"), next);
            if (stage.run()->scene().description.setpoint == next.setpoint) {
                dprintf(log, "%d %.6f\n", count, now());
            }
        }
    });
    edits.start(kPeriod);
    return live.exec();
}
