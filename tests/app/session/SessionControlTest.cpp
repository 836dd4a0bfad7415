#include "app/session/SessionControl.h"

#include "app/session/WindowSection.h"
#include "core/io/scene/SceneFile.h"
#include "tests/app/window/WindowFixture.h"
#include "tests/support/ShippedScene.h"
#include "ui/view/ZoomView.h"
#include "ui/window/WindowLayout.h"
#include "ui/window/WindowMenus.h"

#include <QAction>
#include <QApplication>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTimer>
#include <QtTest>

#include <filesystem>
#include <functional>

namespace asperity::test {
namespace {

namespace fs = std::filesystem;

/// Closes the question for a file's name, which holds this thread, while it lives.
class ClosedQuestion {
public:
    /// @param look before it is closed
    explicit ClosedQuestion(const std::function<void(const QFileDialog&)>& look) {
        QObject::connect(&timer_, &QTimer::timeout, [look] {
            if (auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget())) {
                look(*dialog);
                dialog->close();
            }
        });
        timer_.start(50);
    }

private:
    QTimer timer_;
};

class SavedSession : public Window {
protected:
    void open(const fs::path& file) {
        QSignalSpy opened(&session.scenes(), &SceneControl::opened);
        session.scenes().open(file);
        ASSERT_TRUE(eventually([&] { return opened.count() == 1; }));
    }
    void openShipped() { open(shippedScene("polystyrene")); }

    PanelSwitch panel(MainWindow& of) { return of.layout().switches().front(); }

    /// Changes scene, view and panels.
    void change() {
        SceneDescription next = *session.edits().wanted();
        next.setpoint = 3e-9;
        next.markers.push_back({.name = "here", .x = 50e-9, .y = 60e-9});
        session.edits().change("Setpoint", next);
        window.view().setDirection(0.5, 0.7);
        window.view().setHalfWidth(30e-9);
        panel(window).setShown(false);
    }

    /// What another window shows of the file.
    void expectChanged(const fs::path& file) {
        MainWindow other;
        Session reopened(other);
        other.show();
        reopened.scenes().open(file);
        ASSERT_TRUE(eventually([&] { return reopened.run() != nullptr; }));
        EXPECT_EQ(reopened.run()->scene().description.setpoint, 3e-9);
        ASSERT_EQ(reopened.run()->scene().description.markers.size(), 1U);
        EXPECT_EQ(reopened.run()->scene().description.markers[0].name, "here");
        EXPECT_NEAR(other.view().camera().azimuth(), 0.5, 1e-12);
        EXPECT_NEAR(other.view().camera().elevation(), 0.7, 1e-12);
        EXPECT_NEAR(other.view().halfWidth(), 30e-9, 1e-12);
        EXPECT_FALSE(panel(other).isShown());
        const Vector2 here = session.run()->basePosition().head<2>();
        EXPECT_LT((reopened.run()->basePosition().head<2>() - here).norm(), 1e-12);
    }

    /// Once the entry works.
    void pressSave() {
        ASSERT_TRUE(eventually([this] { return window.menus().saveSession->isEnabled(); }));
        QTest::keyClick(&window, Qt::Key_S, Qt::ControlModifier);
    }

    /// A program before this one showed silicon.
    void leaveSilicon() {
        MainWindow first;
        Session earlier(first);
        earlier.keepIn(kept());
        earlier.scenes().open(shippedScene("silicon"));
        ASSERT_TRUE(keeps(readScene(shippedScene("silicon")).setpoint));
    }
    bool showsSilicon() {
        return session.run() != nullptr &&
               session.run()->scene().description.sample.material.name.find("silicon") !=
                   std::string::npos;
    }

    [[nodiscard]] fs::path kept() const { return folder.file("kept"); }
    /// Whether the session that is kept by itself has this setpoint.
    bool keeps(double setpoint) {
        return eventually([&] {
            return fs::exists(kept() / "session.toml") &&
                   readScene(kept() / "session.toml").setpoint == setpoint;
        });
    }
};

TEST_F(SavedSession, OpensAsItWas) {
    openShipped();
    ASSERT_NO_FATAL_FAILURE(change());
    session.saving().saveAs(folder.file("mine"));
    EXPECT_NE(told().find("mine.toml"), std::string::npos);
    expectChanged(folder.file("mine.toml"));
}

TEST_F(SavedSession, IsAScene) {
    openShipped();
    change();
    session.saving().saveAs(folder.file("mine.toml"));
    EXPECT_EQ(readScene(folder.file("mine.toml")).setpoint, 3e-9);
}

TEST_F(SavedSession, CtrlSWritesToTheFileThatItHas) {
    openShipped();
    session.saving().saveAs(folder.file("mine.toml"));
    change();
    ASSERT_NO_FATAL_FAILURE(pressSave());
    ASSERT_TRUE(
        eventually([this] { return readScene(folder.file("mine.toml")).setpoint == 3e-9; }));
    open(folder.file("mine.toml"));
    SceneDescription next = *session.edits().wanted();
    next.setpoint = 4e-9;
    session.edits().change("Setpoint", next);
    ASSERT_NO_FATAL_FAILURE(pressSave());
    EXPECT_TRUE(
        eventually([this] { return readScene(folder.file("mine.toml")).setpoint == 4e-9; }));
}

TEST_F(SavedSession, CtrlSAfterUndoneOpenWritesToTheFileOfTheSceneThatIsBack) {
    openShipped();
    session.saving().saveAs(folder.file("first.toml"));
    session.saving().saveAs(folder.file("second.toml"));
    const std::string second = contentOf(folder.file("second.toml"));
    open(folder.file("first.toml"));
    SceneDescription next = *session.edits().wanted();
    next.setpoint = 5e-9;
    session.edits().change("Setpoint", next);
    open(folder.file("second.toml"));
    ASSERT_TRUE(eventually([this] { return window.menus().undo->isEnabled(); }));
    QTest::keyClick(&window, Qt::Key_Z, Qt::ControlModifier);
    ASSERT_TRUE(eventually([this] { return session.run()->scene().description.setpoint == 5e-9; }));
    ASSERT_NO_FATAL_FAILURE(pressSave());
    EXPECT_TRUE(
        eventually([this] { return readScene(folder.file("first.toml")).setpoint == 5e-9; }));
    EXPECT_EQ(contentOf(folder.file("second.toml")), second);
}

TEST_F(SavedSession, CtrlSAsksForANameOnceASceneWithoutOneIsBack) {
    openShipped();
    session.saving().saveAs(folder.file("mine.toml"));
    const std::string mine = contentOf(folder.file("mine.toml"));
    open(shippedScene("silicon"));
    open(folder.file("mine.toml"));
    ASSERT_TRUE(eventually([this] { return window.menus().undo->isEnabled(); }));
    QTest::keyClick(&window, Qt::Key_Z, Qt::ControlModifier);
    ASSERT_TRUE(changeEnds());
    QSignalSpy asked(window.menus().saveSessionAs, &QAction::triggered);
    bool wasAsked = false;
    const ClosedQuestion question([&wasAsked](const QFileDialog&) { wasAsked = true; });
    ASSERT_NO_FATAL_FAILURE(pressSave());
    EXPECT_TRUE(eventually([&wasAsked] { return wasAsked; }));
    EXPECT_EQ(asked.count(), 1);
    EXPECT_EQ(contentOf(folder.file("mine.toml")), mine);
}

TEST_F(SavedSession, IsKeptByItself) {
    openShipped();
    session.keepIn(kept());
    EXPECT_FALSE(window.menus().restoreSession->isEnabled());
    change();
    ASSERT_TRUE(keeps(3e-9));
    session.runs().end();  // as at the end of the program
    {
        MainWindow next;
        Session another(next);
        another.keepIn(kept());
        EXPECT_EQ(another.saving().folder(), nullptr) << "the first one keeps the folder";
    }
}

TEST_F(SavedSession, TheOneBeforeIsOffered) {
    leaveSilicon();
    openShipped();
    session.keepIn(kept());
    const fs::path offered = session.saving().folder()->before();
    const std::string before = contentOf(offered);
    ASSERT_TRUE(window.menus().restoreSession->isEnabled());
    window.menus().restoreSession->trigger();
    ASSERT_TRUE(eventually([this] { return showsSilicon(); }));
    EXPECT_TRUE(keeps(session.run()->scene().description.setpoint));
    EXPECT_EQ(contentOf(offered), before);
    EXPECT_TRUE(session.files().recent().files().empty() ||
                session.files().recent().files().front() != offered)
        << "it is no file of the user's";
}

TEST_F(SavedSession, ItsFileIsKnownAfterAnotherStart) {
    {
        MainWindow first;
        Session earlier(first);
        earlier.keepIn(kept());
        earlier.scenes().open(shippedScene("silicon"));
        ASSERT_TRUE(eventually([&] { return earlier.run() != nullptr; }));
        earlier.saving().saveAs(folder.file("mine.toml"));
    }
    session.keepIn(kept());
    session.saving().openLast();
    ASSERT_TRUE(eventually([this] { return session.run() != nullptr; }));
    SceneDescription next = *session.edits().wanted();
    next.setpoint = 6e-9;
    session.edits().change("Setpoint", next);
    ASSERT_NO_FATAL_FAILURE(pressSave());
    EXPECT_TRUE(
        eventually([this] { return readScene(folder.file("mine.toml")).setpoint == 6e-9; }));
}

TEST_F(SavedSession, TheLastOneThatCannotBeOpenedStaysAndTheWindowSaysWhere) {
    fs::create_directories(kept());
    (void)folder.write("kept/session.toml", "[sample]\nfile = \"/media/away/scan.gsf\"\n");
    session.keepIn(kept());
    session.saving().openLast();
    ASSERT_TRUE(eventually([this] { return window.findChild<QMessageBox*>() != nullptr; }));
    const std::string words = window.findChild<QMessageBox*>()->text().toStdString();
    const fs::path aside = kept() / "session_unopened.toml";
    for (const std::string& part : {std::string("could not be opened"), aside.string(),
                                    std::string("scan.gsf"), std::string("Restore the session")}) {
        EXPECT_NE(words.find(part), std::string::npos) << part << " is not in: " << words;
    }
    openShipped();
    EXPECT_TRUE(keeps(readScene(shippedScene("polystyrene")).setpoint));
    EXPECT_NE(contentOf(aside).find("/media/away/scan.gsf"), std::string::npos);
    EXPECT_EQ(session.saving().folder()->before(), aside);
}

TEST_F(SavedSession, ANameIsSuggestedAmongTheDocumentsOrWhereTheLastOneWasSaved) {
    openShipped();
    QString suggested;
    const ClosedQuestion question([&suggested](const QFileDialog& dialog) {
        EXPECT_EQ(dialog.windowTitle(), QStringLiteral("Save the session"));
        suggested = dialog.selectedFiles().value(0);
    });
    ASSERT_NO_FATAL_FAILURE(pressSave());
    ASSERT_TRUE(eventually([&suggested] { return !suggested.isEmpty(); }));
    const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    EXPECT_EQ(QFileInfo(suggested).fileName(), QStringLiteral("polystyrene.toml"));
    EXPECT_EQ(QDir(documents).exists() ? QFileInfo(suggested).path() : documents, documents);
}

TEST(WindowSection, ComesBackAsItWas) {
    const ScratchFolder scratch;
    const QVariantMap kept{{"views/large/axes", true},
                           {"stand/azimuth_rad", -1.25},
                           {"count", 3},
                           {"name", QStringLiteral("größe \"x\"")},
                           {"bytes", QByteArray("\0\xff\x01", 3)},
                           {"list", QVariantList{2, QByteArray("ab")}},
                           {"names", QStringList{"a", "b"}}};
    const QVariantMap back =
        windowSectionOf(scratch.write("a.toml", "[sample]\n" + windowSection(kept)));
    EXPECT_EQ(back.keys(), kept.keys());
    EXPECT_EQ(back["views/large/axes"].toBool(), true);
    EXPECT_EQ(back["stand/azimuth_rad"].toDouble(), -1.25);
    EXPECT_EQ(back["name"].toString(), kept["name"].toString());
    EXPECT_EQ(back["bytes"].toByteArray(), kept["bytes"].toByteArray());
    EXPECT_EQ(back["list"].toList()[0].toInt(), 2);
    EXPECT_EQ(back["list"].toList()[1].toByteArray(), QByteArray("ab"));
    EXPECT_EQ(back["names"].toStringList(), kept["names"].toStringList());
    EXPECT_TRUE(windowSectionOf(scratch.write("b.toml", "[window\n")).isEmpty());
    EXPECT_TRUE(windowSectionOf(scratch.file("none.toml")).isEmpty());
}

}  // namespace
}  // namespace asperity::test
