/// Opens the dialog that opens a scan, chooses one and, where it is asked for, a part of it, and
/// saves what the dialog shows, in the dark where that is asked for.
/// Usage: asperity_open_picture SCENE_OR_SCAN OUT.png [part] [dark]

#include "app/commands/VirtualDisplay.h"
#include "app/window/lab/LiveWindow.h"
#include "app/window/scene/OpenControl.h"
#include "app/window/scene/PreviewPane.h"
#include "app/window/scene/ScaleControl.h"
#include "core/Error.h"
#include "tools/screenshots/PictureTool.h"
#include "ui/widgets/Theme.h"

#include <QFileInfo>
#include <QLabel>
#include <QSpinBox>
#include <QTimer>

#include <algorithm>
#include <string>

namespace asperity {

namespace {

constexpr int kPoll = 100;       // [ms]
constexpr int kLongest = 20000;  // [ms]

/// The middle of the scan.
void chooseAPart(OpenDialog& dialog) {
    for (const char* axis : {"Column", "Row"}) {
        auto* count = dialog.findChild<QSpinBox*>(QStringLiteral("crop%1s").arg(axis));
        auto* first = dialog.findChild<QSpinBox*>(QStringLiteral("crop%1").arg(axis));
        count->setValue(count->value() / 2);
        first->setValue(count->value() / 2);
    }
}

int run(char** argv) {
    const VirtualDisplay display;
    LiveWindow live;
    OpenControl& files = live.stage().get<OpenControl>();
    bool hasPart = false;
    for (char** choice = argv + 3; *choice != nullptr; ++choice) {
        hasPart = hasPart || std::string(*choice) == "part";
        if (std::string(*choice) == "dark") {
            theme::choose(ThemeChoice::Dark);
        }
    }
    int looks = 0;
    QTimer timer;
    QObject::connect(&timer, &QTimer::timeout, [&] {
        OpenDialog& dialog = *files.dialog();
        const bool isKnown = dialog.findChild<ScaleForm*>()->isVisible() ||
                             dialog.preview().isComplete() ||
                             !dialog.findChild<QLabel*>("openMessage")->text().isEmpty();
        if (!isKnown) {
            return;
        }
        ++looks;
        if (looks == 1 && hasPart) {
            chooseAPart(dialog);
        } else if (looks == (hasPart ? 10 : 3)) {  // the part is looked at, too
            dialog.grab().save(QString::fromUtf8(argv[2]));
            live.window().close();
        }
    });
    QTimer::singleShot(0, &live.window(), [&] {
        files.ask();
        files.dialog()->choose(QFileInfo(QString::fromUtf8(argv[1])).absoluteFilePath());
        timer.start(kPoll);
    });
    QTimer::singleShot(kLongest, &live.window(), &QWidget::close);
    const int status = live.exec();
    if (looks == 0) {
        throw Error("the file was not looked into");
    }
    return status;
}

}  // namespace

}  // namespace asperity

int main(int argc, char** argv) {
    return asperity::runPictureTool({argv, static_cast<std::size_t>(argc)},
                                    static_cast<std::size_t>(std::clamp(argc - 1, 2, 4)),
                                    "asperity_open_picture SCENE_OR_SCAN OUT.png [part] [dark]",
                                    asperity::run);
}
