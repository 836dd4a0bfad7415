#include "app/recording/RecordedRun.h"
#include "app/window/export/ExportControl.h"
#include "app/window/export/ExportDialog.h"
#include "app/window/recording/RecordingControl.h"
#include "app/window/scene/SceneControl.h"
#include "core/io/tables/CsvTable.h"
#include "tests/app/window/WindowFixture.h"
#include "tests/support/EventLoopWatchdog.h"
#include "ui/shell/Menus.h"
#include "ui/view/ZoomView.h"

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QtTest>

#include <iostream>

namespace asperity::test {
namespace {

/// Exports as a user does: by keys and clicks.
class WindowThatExports : public Window {
protected:
    ExportDialog* dialog() { return stage.get<ExportControl>().dialog(); }
    void askByKey() {
        QApplication::setActiveWindow(&window);  // a bare X server has nobody who does so
        QTest::keyClick(&window, Qt::Key_E, Qt::ControlModifier);
        ASSERT_TRUE(eventually([this] { return dialog() != nullptr && dialog()->isVisible(); }));
        QApplication::setActiveWindow(dialog());
    }
    /// While a file is being written.
    void askByKeyInVain() {
        QApplication::setActiveWindow(&window);  // the dialog, which is gone, had the focus
        QTest::keyClick(&window, Qt::Key_E, Qt::ControlModifier);
        EXPECT_TRUE(
            eventually([this] { return told().find("being written") != std::string::npos; }, 2000))
            << told();
        EXPECT_EQ(dialog(), nullptr);
    }
    template <typename Widget>
    Widget* part(const char* name) {
        auto* found = dialog()->findChild<Widget*>(QString::fromLatin1(name));
        EXPECT_NE(found, nullptr) << name;
        return found;
    }
    void type(const char* line, const QString& text) {
        auto* field = part<QLineEdit>(line);
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, text);
    }
    void typeSize(const char* box, const QString& pixels) {
        auto* field = part<QSpinBox>(box);
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, pixels);
        QTest::keyClick(field, Qt::Key_Tab);
    }
    /// A list is chosen from by the keys.
    void select(const char* list, int index) {
        auto* box = part<QComboBox>(list);
        box->setFocus();
        QTest::keyClick(box, Qt::Key_Home);
        for (int i = 0; i < index; ++i) {
            QTest::keyClick(box, Qt::Key_Down);
        }
        ASSERT_EQ(box->currentIndex(), index);
    }
    void indent() {
        QTest::mouseClick(child<QAbstractButton>("engage"), Qt::LeftButton);
        ASSERT_TRUE(eventually([this] { return inContact(); })) << state();
    }
    QString file(const std::string& name) {
        return QString::fromStdString(folder.file(name).string());
    }
    QString here() { return QString::fromStdString(folder.path().string()); }
    /// A recording of what the tip does for a while.
    std::filesystem::path record() {
        QSignalSpy begun(&stage.runs(), &RunControl::begun);
        stage.get<SceneControl>().open(levelScan(folder, 64));  // a film reads the scan again
        EXPECT_TRUE(eventually([&] { return begun.count() == 1; }));
        QSignalSpy ended(&stage.get<RecordingControl>(), &RecordingControl::finished);
        stage.get<RecordingControl>().start({folder.path() / "recorded"});
        EXPECT_TRUE(runsFor(0.6));
        stage.get<RecordingControl>().finish();
        EXPECT_EQ(ended.count(), 1);
        return folder.path() / "recorded";
    }
    /// Where films of a recording go.
    void askForFilm(const std::filesystem::path& recording, const QString& name) {
        askByKey();
        select("exportSubject", static_cast<int>(ExportSubject::Film));
        select("exportFormat", 0);
        type("exportRecording", QString::fromStdString(recording.string()));
        type("exportFolder", here());
        type("exportName", name);
        typeSize("exportWidth", "320");
        typeSize("exportHeight", "240");
    }
};

TEST_F(WindowThatExports, NothingBeforeThereIsAScan) {
    live(200);  // some frames, none of which may offer it
    EXPECT_FALSE(window.menus().entry("exportView").isEnabled());
    QTest::keyClick(&window, Qt::Key_E, Qt::ControlModifier);
    EXPECT_EQ(dialog(), nullptr);
}

TEST_F(WindowThatExports, TheViewByKeyNameAndReturn) {
    openFlatScene();
    indent();
    askByKey();
    ASSERT_TRUE(
        eventually([this] { return !part<ExportPicture>("exportPreview")->picture().isNull(); }));
    type("exportFolder", here());
    typeSize("exportWidth", "640");
    typeSize("exportHeight", "480");
    type("exportName", "indented_{n}");
    EXPECT_TRUE(part<QLabel>("exportFile")->toolTip().contains("indented_1.png"));
    QTest::keyClick(part<QLineEdit>("exportName"), Qt::Key_Return);
    ASSERT_TRUE(eventually([this] { return told().find("indented_1.png") != std::string::npos; }))
        << told();
    EXPECT_EQ(QImage(file("indented_1.png")).size(), QSize(640, 480));
    EXPECT_TRUE(eventually([this] { return dialog() == nullptr; }));
    EXPECT_TRUE(stage.run()->loop().running());
}

/// Camera, width of frame and options are those of the window's view.
TEST_F(WindowThatExports, TheViewAsItIsNow) {
    openFlatScene();
    stage.runs().pause();
    ASSERT_TRUE(eventually([this] { return panels.view().isSettled(); }));
    const auto exported = [this](const QString& name) {
        askByKey();
        type("exportFolder", here());
        typeSize("exportWidth", "320");
        typeSize("exportHeight", "240");
        type("exportName", name);
        QTest::mouseClick(part<QPushButton>("exportWrite"), Qt::LeftButton);
        EXPECT_TRUE(
            eventually([&] { return told().find(name.toStdString()) != std::string::npos; }));
        EXPECT_TRUE(eventually([this] { return dialog() == nullptr; }));
        return QImage(file(name.toStdString() + ".png"));
    };
    const QImage first = exported("first");
    panels.view().lookFrom(ViewDirection::Top);
    const QImage fromAbove = exported("above");
    EXPECT_NE(fromAbove, first);
    panels.view().setHalfWidth(0.5 * panels.view().halfWidth());
    EXPECT_NE(exported("nearer"), fromAbove);
}

TEST_F(WindowThatExports, EscapeWritesNothing) {
    openFlatScene();
    askByKey();
    type("exportFolder", here());
    type("exportName", "never");
    QTest::keyClick(dialog(), Qt::Key_Escape);
    EXPECT_TRUE(eventually([this] { return dialog() == nullptr; }));
    ASSERT_TRUE(runsFor(0.3));
    EXPECT_FALSE(std::filesystem::exists(folder.file("never.png")));
}

TEST_F(WindowThatExports, EveryControlHasAToolTip) {
    openFlatScene();
    askByKey();
    for (const QWidget* const widget : dialog()->findChildren<QWidget*>()) {
        const bool isInput =
            qobject_cast<const QAbstractButton*>(widget) != nullptr ||
            qobject_cast<const QComboBox*>(widget) != nullptr ||
            qobject_cast<const QAbstractSpinBox*>(widget) != nullptr ||
            (qobject_cast<const QLineEdit*>(widget) != nullptr &&
             qobject_cast<const QAbstractSpinBox*>(widget->parentWidget()) == nullptr);
        if (isInput) {
            EXPECT_FALSE(widget->toolTip().isEmpty()) << widget->objectName().toStdString();
        }
    }
}

TEST_F(WindowThatExports, AFilmOfARecording) {
    askForFilm(record(), "film");
    EXPECT_EQ(part<QLabel>("exportMessage")->text().toStdString(), "");
    QTest::mouseClick(part<QPushButton>("exportWrite"), Qt::LeftButton);
    ASSERT_TRUE(eventually([this] { return told().find("Exported to") != std::string::npos; }))
        << told();
    EXPECT_TRUE(std::filesystem::exists(folder.file("film") / "frames.csv"));
    EXPECT_EQ(QImage(file("film/frame_00001.png")).size(), QSize(320, 240));
}

TEST_F(WindowThatExports, AFilmOfAPartSeenFromAbove) {
    const std::filesystem::path recording = record();
    const double end = readRun(recording).samples.front().time + 0.2;
    askForFilm(recording, "part");
    const auto message = [this] { return part<QLabel>("exportMessage")->text().toStdString(); };
    part<QComboBox>("exportFrom")->setEditText("midnight");
    EXPECT_EQ(message().find("'midnight' is no moment of a run"), 0U) << message();
    EXPECT_FALSE(part<QPushButton>("exportWrite")->isEnabled());
    part<QComboBox>("exportFrom")->setEditText("Start");
    part<QComboBox>("exportTo")->setEditText(QStringLiteral("%1 s").arg(end));
    QComboBox* const view = part<QComboBox>("exportFilmView");
    view->setCurrentIndex(view->findData("top"));
    EXPECT_EQ(message(), "");
    QTest::mouseClick(part<QPushButton>("exportWrite"), Qt::LeftButton);
    ASSERT_TRUE(eventually([this] { return told().find("Exported to") != std::string::npos; }))
        << told();
    const CsvTable frames = readCsv(folder.file("part") / "frames.csv");
    ASSERT_GT(frames.rows(), 3U);
    EXPECT_NEAR(frames.number(frames.rows() - 1, "time_s"), end, 0.04 + 1e-3);
}

TEST_F(WindowThatExports, ACanceledFilmLeavesNothing) {
    askForFilm(record(), "film");
    part<QDoubleSpinBox>("exportSpeed")->setValue(0.002);  // thousands of frames
    QTest::mouseClick(part<QPushButton>("exportWrite"), Qt::LeftButton);
    ASSERT_TRUE(eventually([this] { return window.menus().entry("cancelLoading").isEnabled(); }));
    ASSERT_TRUE(runsFor(1.0));
    askByKeyInVain();
    window.menus().entry("cancelLoading").trigger();
    EXPECT_TRUE(eventually([this] { return !window.menus().entry("cancelLoading").isEnabled(); }));
    ASSERT_TRUE(runsFor(1.0));
    EXPECT_FALSE(std::filesystem::exists(folder.file("film")));
    EXPECT_TRUE(told().find("Exported") == std::string::npos) << told();
    EXPECT_TRUE(stage.run()->loop().running());
}

class WindowThatExportsAlone : public WindowThatExports {};

TEST_F(WindowThatExportsAlone, ThePreviewDoesNotBlockTheWindow) {
    openFlatScene();
    askByKey();  // the driver compiles its shaders
    ASSERT_TRUE(
        eventually([this] { return !part<ExportPicture>("exportPreview")->picture().isNull(); }));
    EventLoopWatchdog watchdog;
    watchdog.enter("view");
    part<QAbstractButton>("exportClean")->click();
    live(1000);  // a loop that something blocks later must have the time to be seen
    watchdog.enter("plots");
    part<QComboBox>("exportSubject")->setCurrentIndex(static_cast<int>(ExportSubject::Forces));
    live(1000);
    std::cout << tableOf(watchdog.longest());
    const std::vector<BlockedStretch> longest = watchdog.longest();
    const double limit = watchdog.longestBlock();
    for (const BlockedStretch& stretch : longest) {
        EXPECT_LT(stretch.processor, limit) << stretch.step;
    }
}

}  // namespace
}  // namespace asperity::test
