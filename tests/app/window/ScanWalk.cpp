#include "tests/app/window/ScanWalk.h"

#include "app/window/recording/RecordingControl.h"
#include "app/window/scene/OpenControl.h"
#include "app/window/scene/OpenDialog.h"
#include "app/window/scene/PreviewPane.h"
#include "tests/support/ReferenceTable.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QDialogButtonBox>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QTimer>
#include <QToolButton>

#include <algorithm>

namespace asperity::test {

namespace fs = std::filesystem;

void ScanWalk::SetUp() {
    ASPERITY_NEEDS_SHARED_DATA();
    Window::SetUp();
    openFlatScene();  // stands for the scene that comes with the program
    stage.get<OpenControl>().recent().setFolder(QString::fromStdString(folder.path().string()));
}

void ScanWalk::openScan(const std::string& file) {
    const fs::path scan = sharedData("afm/" + file);
    name_ = scan.filename().string();
    fs::copy_file(scan, folder.path() / name_);
    user.choose(window, {"File", "Open scan"});
    ASSERT_TRUE(eventually([this] { return stage.get<OpenControl>().dialog() != nullptr; }));
    clickFile();
    ASSERT_TRUE(eventually([this] { return dialog().preview().isComplete(); }));
}

/// In the dialog's list of the folder.
void ScanWalk::clickFile() {
    auto& list = *dialog().findChild<QAbstractItemView*>(QStringLiteral("treeView"));
    QModelIndex index;
    ASSERT_TRUE(eventually([&] {
        for (int row = 0; row < list.model()->rowCount(list.rootIndex()); ++row) {
            index = list.model()->index(row, 0, list.rootIndex());
            if (index.data().toString().toStdString() == name_) {
                return list.visualRect(index).isValid();
            }
        }
        return false;
    }));
    user.click(*list.viewport(), list.visualRect(index).center());
}

void ScanWalk::levelAndOpen() {
    user.choose(*dialog().findChild<QToolButton*>(QStringLiteral("addLevelingStep")),
                QStringLiteral("median of differences"));
    ASSERT_TRUE(eventually([this] { return dialog().preview().isComplete(); }));
    QSignalSpy begun(&stage.runs(), &RunControl::begun);
    user.click(*dialog().findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Open));
    ASSERT_TRUE(eventually([&] { return begun.count() == 1; }, 60000));
    ASSERT_TRUE(window.windowTitle().toStdString().starts_with(name_));
    const LevelingSteps& steps = stage.run()->scene().description.sample.leveling;
    EXPECT_NE(std::ranges::find(steps, LevelingStep::MedianOfDifferences), steps.end());
    ASSERT_TRUE(eventually([this] { return far(); })) << state();
    watch();
}

void ScanWalk::watch() {
    constexpr int kOftenerThanFrames = 5;  // [ms]
    auto* const timer = new QTimer(&window);
    QObject::connect(timer, &QTimer::timeout, &window, [this] { look(); });
    timer->start(kOftenerThanFrames);
}

void ScanWalk::look() {
    if (const std::string now = state(); saidOfTip_.empty() || saidOfTip_.back() != now) {
        saidOfTip_.push_back(now);
    }
}

void ScanWalk::startRecording() { user.click(*child<QAbstractButton>("record")); }

fs::path ScanWalk::stopRecording() {
    QSignalSpy finished(&stage.get<RecordingControl>(), &RecordingControl::finished);
    user.click(*child<QAbstractButton>("record"));
    if (!eventually([&] { return finished.count() == 1; })) {
        ADD_FAILURE() << "the recording does not end";
        return {};
    }
    return finished[0][0].toString().toStdString();
}

void ScanWalk::engage() {
    user.click(*child<QAbstractButton>("engage"));
    ASSERT_TRUE(eventually([this] { return inContact(); }, 60000)) << state();
}

void ScanWalk::withdraw() {
    user.click(*child<QAbstractButton>("withdraw"));
    ASSERT_TRUE(eventually([this] { return far(); })) << state();
    look();
}

void ScanWalk::expectNothingToRead() {
    EXPECT_EQ(window.findChild<QMessageBox*>(), nullptr);
    for (const Message& message : window.messages().messages()) {
        EXPECT_NE(message.kind, MessageKind::Error) << message.text.toStdString();
    }
    EXPECT_EQ(user.typed(), 0) << "nothing had to be typed";
}

}  // namespace asperity::test
