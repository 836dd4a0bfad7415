#include "app/window/recording/ReportControl.h"

#include "app/window/recording/PlaybackControl.h"
#include "tests/app/ProgramRun.h"
#include "tests/app/window/WindowFixture.h"
#include "tests/support/ShippedScene.h"
#include "ui/shell/FileDialogs.h"
#include "ui/shell/Menus.h"

#include <QAction>
#include <QDesktopServices>
#include <QInputDialog>
#include <QMessageBox>
#include <QSignalSpy>
#include <QTextBrowser>
#include <QtTest>

#include <filesystem>

namespace asperity::test {
namespace {

namespace fs = std::filesystem;

/// Stands in for the desktop, which would open a browser.
struct Desktop {
    Desktop() { QDesktopServices::setUrlHandler(QStringLiteral("file"), &browser, "setSource"); }
    ~Desktop() { QDesktopServices::unsetUrlHandler(QStringLiteral("file")); }
    Desktop(const Desktop&) = delete;
    Desktop& operator=(const Desktop&) = delete;

    QTextBrowser browser;
};

class ReportInWindow : public Window {
protected:
    void SetUp() override {
        Window::SetUp();
        restoreFolders({});
        const ProgramRun made =
            runProgram("explore --no-pictures " + shippedScene("polystyrene").string() +
                       " --duration 0.5 --out '" + run.string() + "'");
        ASSERT_EQ(made.exitCode, 0) << made.output;
    }

    fs::path run = folder.file("a run");
    Desktop desktop;
};

TEST_F(ReportInWindow, IsOfTheRecordingThatIsLookedAtAndOpens) {
    PlaybackControl& playback = stage.get<PlaybackControl>();
    playback.look(run);
    ASSERT_TRUE(eventually([&] { return playback.shown() != nullptr; }, 60000)) << told();
    QSignalSpy written(&stage.get<ReportControl>(), &ReportControl::written);
    window.menus().entry("report").trigger();
    auto* question = window.findChild<QInputDialog*>(QStringLiteral("askForName"));
    ASSERT_NE(question, nullptr);
    const fs::path suggested = question->textValue().toStdString();
    EXPECT_EQ(suggested, fs::path(run.string() + "_report"));
    question->accept();
    ASSERT_TRUE(eventually([&] { return written.count() == 1; }, 60000)) << told();
    const fs::path page = written[0][0].toString().toStdString();
    EXPECT_EQ(page.parent_path(), suggested);
    EXPECT_TRUE(fs::exists(page));
    EXPECT_TRUE(fs::exists(fs::path(page).replace_extension(".pdf")));
    EXPECT_EQ(desktop.browser.source().toLocalFile().toStdString(), page.string());
}

TEST_F(ReportInWindow, SaysWhyThereIsNone) {
    stage.get<ReportControl>().write(folder.path(), folder.file("report"));
    const auto complaint = [this] { return window.findChild<QMessageBox*>(); };
    ASSERT_TRUE(eventually([&] { return complaint() != nullptr; }, 60000));
    EXPECT_TRUE(complaint()->text().contains(QStringLiteral("holds no run")))
        << complaint()->text().toStdString();
    EXPECT_FALSE(complaint()->text().contains(QStringLiteral("asperity:")));
    EXPECT_FALSE(fs::exists(folder.file("report")));
}

}  // namespace
}  // namespace asperity::test
