#include "tests/app/window/WindowFixture.h"
#include "tests/support/UserClicks.h"
#include "ui/view/ZoomView.h"
#include "ui/window/OpenDialog.h"
#include "ui/window/PreviewPane.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAction>
#include <QApplication>
#include <QFileDialog>
#include <QImage>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QTimer>
#include <QToolButton>
#include <QtTest>

#include <filesystem>
#include <iostream>

namespace asperity::test {
namespace {

namespace fs = std::filesystem;

/// The path of docs/first_steps.md, click by click.
class FirstSteps : public Window {
protected:
    void SetUp() override {
        Window::SetUp();
        openFlatScene();  // stands for the scene that comes with the program
        fs::copy_file(fs::path(ASPERITY_DATA_DIR) / "samples" / "granular_film.gsf", scan_);
        session.files().recent().setFolder(QString::fromStdString(folder.path().string()));
    }

    OpenDialog& dialog() { return *session.files().dialog(); }

    void openAScan() {
        user_.choose(window, {"File", "Open scan"});
        ASSERT_TRUE(eventually([this] { return session.files().dialog() != nullptr; }));
        clickFile();
        ASSERT_TRUE(eventually([this] { return dialog().preview().isComplete(); }));
    }

    /// In the dialog's list of the folder.
    void clickFile() {
        auto& list = *dialog().findChild<QAbstractItemView*>(QStringLiteral("treeView"));
        QModelIndex index;
        ASSERT_TRUE(eventually([&] {
            for (int row = 0; row < list.model()->rowCount(list.rootIndex()); ++row) {
                index = list.model()->index(row, 0, list.rootIndex());
                if (index.data().toString() == QStringLiteral("scan.gsf")) {
                    return list.visualRect(index).isValid();
                }
            }
            return false;
        }));
        user_.click(*list.viewport(), list.visualRect(index).center());
    }

    /// Adds a step to the leveling.
    void level() {
        auto& add = *dialog().findChild<QToolButton*>(QStringLiteral("addLevelingStep"));
        // Its menu runs an event loop of its own until something is chosen.
        QTimer::singleShot(200, &add, [&] {
            QMenu& menu = *add.menu();
            for (QAction* action : menu.actions()) {
                if (action->text().contains(QStringLiteral("median of differences"))) {
                    user_.click(menu, menu.actionGeometry(action).center());
                    return;
                }
            }
            ADD_FAILURE() << "no step by medians";
            menu.close();
        });
        user_.click(add);
        ASSERT_TRUE(eventually([this] { return dialog().preview().isComplete(); }));
        QSignalSpy begun(&session.runs(), &RunControl::begun);
        for (QPushButton* button : dialog().findChildren<QPushButton*>()) {
            if (button->isVisible() &&
                QString(button->text()).remove('&') == QStringLiteral("Open")) {
                user_.click(*button);
                break;
            }
        }
        ASSERT_TRUE(eventually([&] { return begun.count() == 1; }));
        ASSERT_TRUE(window.windowTitle().startsWith("scan.gsf"));
        ASSERT_TRUE(eventually([this] { return far(); })) << state();
    }

    void touch() {
        user_.click(*child<QAbstractButton>("record"));
        user_.click(*child<QAbstractButton>("engage"));
        ASSERT_TRUE(eventually([this] { return inContact(); })) << state();
        const QPoint middle = window.view().rect().center();
        drag(middle, middle + QPoint(30, 0));
        live(500);
    }

    /// The file dialog runs an event loop of its own.
    void savePicture() {
        QTimer::singleShot(400, &window, [this] {
            auto* chooser = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
            ASSERT_NE(chooser, nullptr);
            chooser->selectFile(QString::fromStdString(picture_.string()));
            for (QPushButton* button : chooser->findChildren<QPushButton*>()) {
                if (QString(button->text()).remove('&') == QStringLiteral("Save")) {
                    user_.click(*button);
                    return;
                }
            }
        });
        user_.choose(window, {"File", "Save picture"});
        ASSERT_TRUE(eventually([this] { return fs::exists(picture_); }));
    }

    UserClicks user_;
    fs::path scan_ = folder.path() / "scan.gsf";
    fs::path picture_ = folder.path() / "asperity.png";
};

TEST_F(FirstSteps, LeadFromAFileToAPictureAndAForceLog) {
    ASSERT_NO_FATAL_FAILURE(openAScan());
    ASSERT_NO_FATAL_FAILURE(level());
    ASSERT_NO_FATAL_FAILURE(touch());
    ASSERT_NO_FATAL_FAILURE(savePicture());
    user_.click(*child<QAbstractButton>("withdraw"));
    ASSERT_TRUE(eventually([this] { return far(); })) << state();
    QSignalSpy finished(&session.recordings(), &RecordingControl::finished);
    user_.click(*child<QAbstractButton>("record"));
    ASSERT_TRUE(eventually([&] { return finished.count() == 1; }));
    EXPECT_EQ(QImage(QString::fromStdString(picture_.string())).size(), window.size());
    const fs::path run = finished[0][0].toString().toStdString();
    EXPECT_GT(fs::file_size(run / "force_log.csv"), 100000U);
    EXPECT_TRUE(fs::exists(run / "summary.json"));
    EXPECT_EQ(window.findChild<QMessageBox*>(), nullptr) << "nothing had to be read";
    EXPECT_EQ(user_.typed(), 0) << "nothing had to be typed";
    EXPECT_LE(user_.clicks(), 14) << "docs/first_steps.md counts them";
    std::cout << user_.clicks() << " clicks\n";
}

}  // namespace
}  // namespace asperity::test
