#include "app/window/session/SessionControl.h"

#include "app/window/WindowSection.h"
#include "app/window/scene/OpenControl.h"
#include "app/window/scene/SceneControl.h"
#include "core/io/scene/SceneFile.h"
#include "tests/app/window/ControlFixture.h"
#include "tests/app/window/WindowFixture.h"
#include "tests/support/ShippedScene.h"
#include "ui/shell/FileDialogs.h"
#include "ui/shell/Menus.h"
#include "ui/shell/WindowLayout.h"
#include "ui/view/ZoomView.h"

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
    void SetUp() override {
        Window::SetUp();
        restoreFolders({});
    }
    void open(const fs::path& file) {
        QSignalSpy opened(&stage.get<SceneControl>(), &SceneControl::opened);
        stage.get<SceneControl>().open(file);
        ASSERT_TRUE(eventually([&] { return opened.count() == 1; }));
    }
    void openShipped() { open(shippedScene("polystyrene")); }

    PanelSwitch panel(MainWindow& of) { return of.layout().switches().front(); }

    /// Changes scene, view and panels.
    void change() {
        SceneDescription next = *stage.edits().wanted();
        next.setpoint = 3e-9;
        next.markers.push_back({.name = "here", .x = 50e-9, .y = 60e-9});
        stage.edits().change("Setpoint", next);
        panels.view().setDirection(0.5, 0.7);
        panels.view().setHalfWidth(30e-9);
        panel(window).setShown(false);
    }

    /// What another window shows of the file.
    void expectChanged(const fs::path& file) {
        WholeWindow other(kFramePeriod);
        const Stage& reopened = other.stage;
        other.window.show();
        reopened.get<SceneControl>().open(file);
        ASSERT_TRUE(eventually([&] { return reopened.run() != nullptr; }));
        EXPECT_EQ(reopened.run()->scene().description.setpoint, 3e-9);
        ASSERT_EQ(reopened.run()->scene().description.markers.size(), 1U);
        EXPECT_EQ(reopened.run()->scene().description.markers[0].name, "here");
        EXPECT_NEAR(other.panels.view().camera().azimuth(), 0.5, 1e-12);
        EXPECT_NEAR(other.panels.view().camera().elevation(), 0.7, 1e-12);
        EXPECT_NEAR(other.panels.view().halfWidth(), 30e-9, 1e-12);
        EXPECT_FALSE(panel(other.window).isShown());
        const Vector2 here = stage.run()->basePosition().head<2>();
        EXPECT_LT((reopened.run()->basePosition().head<2>() - here).norm(), 1e-12);
    }

    /// Once the entry works.
    void pressSave() {
        ASSERT_TRUE(eventually([this] { return window.menus().entry("saveSession").isEnabled(); }));
        QTest::keyClick(&window, Qt::Key_S, Qt::ControlModifier);
    }

    /// A program before this one showed silicon.
    void leaveSilicon() {
        const WholeWindow other(kFramePeriod);
        const Stage& earlier = other.stage;
        earlier.get<SessionControl>().keepIn(kept());
        earlier.get<SceneControl>().open(shippedScene("silicon"));
        ASSERT_TRUE(keeps(readScene(shippedScene("silicon")).setpoint));
    }
    bool showsSilicon() {
        return stage.run() != nullptr && stage.run()->scene().description.sample.material.name.find(
                                             "silicon") != std::string::npos;
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
    stage.get<SessionControl>().saveAs(folder.file("mine"));
    EXPECT_NE(told().find("mine.toml"), std::string::npos);
    expectChanged(folder.file("mine.toml"));
}

TEST_F(SavedSession, CtrlSWritesToTheFileThatItHas) {
    openShipped();
    stage.get<SessionControl>().saveAs(folder.file("mine.toml"));
    change();
    ASSERT_NO_FATAL_FAILURE(pressSave());
    ASSERT_TRUE(
        eventually([this] { return readScene(folder.file("mine.toml")).setpoint == 3e-9; }));
    open(folder.file("mine.toml"));
    SceneDescription next = *stage.edits().wanted();
    next.setpoint = 4e-9;
    stage.edits().change("Setpoint", next);
    ASSERT_NO_FATAL_FAILURE(pressSave());
    EXPECT_TRUE(
        eventually([this] { return readScene(folder.file("mine.toml")).setpoint == 4e-9; }));
}

TEST_F(SavedSession, CtrlSAfterUndoneOpenWritesToTheFileOfTheSceneThatIsBack) {
    openShipped();
    stage.get<SessionControl>().saveAs(folder.file("first.toml"));
    stage.get<SessionControl>().saveAs(folder.file("second.toml"));
    const std::string second = contentOf(folder.file("second.toml"));
    open(folder.file("first.toml"));
    SceneDescription next = *stage.edits().wanted();
    next.setpoint = 5e-9;
    stage.edits().change("Setpoint", next);
    open(folder.file("second.toml"));
    ASSERT_TRUE(eventually([this] { return window.menus().entry("undo").isEnabled(); }));
    QTest::keyClick(&window, Qt::Key_Z, Qt::ControlModifier);
    ASSERT_TRUE(eventually([this] { return stage.run()->scene().description.setpoint == 5e-9; }));
    ASSERT_NO_FATAL_FAILURE(pressSave());
    EXPECT_TRUE(
        eventually([this] { return readScene(folder.file("first.toml")).setpoint == 5e-9; }));
    EXPECT_EQ(contentOf(folder.file("second.toml")), second);
}

TEST_F(SavedSession, CtrlSAsksForANameOnceASceneWithoutOneIsBack) {
    openShipped();
    stage.get<SessionControl>().saveAs(folder.file("mine.toml"));
    const std::string mine = contentOf(folder.file("mine.toml"));
    open(shippedScene("silicon"));
    open(folder.file("mine.toml"));
    ASSERT_TRUE(eventually([this] { return window.menus().entry("undo").isEnabled(); }));
    QTest::keyClick(&window, Qt::Key_Z, Qt::ControlModifier);
    ASSERT_TRUE(changeEnds());
    QSignalSpy asked(&window.menus().entry("saveSessionAs"), &QAction::triggered);
    bool wasAsked = false;
    const ClosedQuestion question([&wasAsked](const QFileDialog&) { wasAsked = true; });
    ASSERT_NO_FATAL_FAILURE(pressSave());
    EXPECT_TRUE(eventually([&wasAsked] { return wasAsked; }));
    EXPECT_EQ(asked.count(), 1);
    EXPECT_EQ(contentOf(folder.file("mine.toml")), mine);
}

TEST_F(SavedSession, IsKeptByItself) {
    openShipped();
    keepSession(stage, kept());
    EXPECT_FALSE(window.menus().entry("restoreSession").isEnabled());
    change();
    ASSERT_TRUE(keeps(3e-9));
    stage.runs().end();  // as at the end of the program
    {
        const WholeWindow next(kFramePeriod);
        auto& another = next.stage.get<SessionControl>();
        another.keepIn(kept());
        EXPECT_EQ(another.folder(), nullptr) << "the first one keeps the folder";
    }
}

TEST_F(SavedSession, TheOneBeforeIsOffered) {
    leaveSilicon();
    openShipped();
    keepSession(stage, kept());
    const fs::path offered = stage.get<SessionControl>().folder()->before();
    const std::string before = contentOf(offered);
    ASSERT_TRUE(window.menus().entry("restoreSession").isEnabled());
    window.menus().entry("restoreSession").trigger();
    ASSERT_TRUE(eventually([this] { return showsSilicon(); }));
    EXPECT_TRUE(keeps(stage.run()->scene().description.setpoint));
    EXPECT_EQ(contentOf(offered), before);
    EXPECT_TRUE(stage.get<OpenControl>().recent().files().empty() ||
                stage.get<OpenControl>().recent().files().front() != offered)
        << "it is no file of the user's";
}

TEST_F(SavedSession, ItsFileIsKnownAfterAnotherStart) {
    {
        const WholeWindow other(kFramePeriod);
        const Stage& earlier = other.stage;
        earlier.get<SessionControl>().keepIn(kept());
        earlier.get<SceneControl>().open(shippedScene("silicon"));
        ASSERT_TRUE(eventually([&] { return earlier.run() != nullptr; }));
        earlier.get<SessionControl>().saveAs(folder.file("mine.toml"));
    }
    keepSession(stage, kept());
    stage.get<SessionControl>().openLast();
    ASSERT_TRUE(eventually([this] { return stage.run() != nullptr; }));
    SceneDescription next = *stage.edits().wanted();
    next.setpoint = 6e-9;
    stage.edits().change("Setpoint", next);
    ASSERT_NO_FATAL_FAILURE(pressSave());
    EXPECT_TRUE(
        eventually([this] { return readScene(folder.file("mine.toml")).setpoint == 6e-9; }));
}

TEST_F(SavedSession, TheLastOneThatCannotBeOpenedStaysAndTheWindowSaysWhere) {
    fs::create_directories(kept());
    (void)folder.write("kept/session.toml", "[sample]\nfile = \"/media/away/scan.gsf\"\n");
    keepSession(stage, kept());
    stage.get<SessionControl>().openLast();
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
    EXPECT_EQ(stage.get<SessionControl>().folder()->before(), aside);
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

/// Sessions of a stage that has no views and panels to restore.
class SessionOnStage : public ControlFixture {
protected:
    void open(const fs::path& file) {
        const int before = opened.count();
        scenes.open(file);
        ASSERT_TRUE(eventually([&] { return opened.count() == before + 1; })) << complaint();
    }

    SceneControl& scenes = stage.add<SceneControl>();
    SessionControl& sessions = stage.add<SessionControl>();
    QSignalSpy opened{&scenes, &SceneControl::opened};
};

TEST_F(SessionOnStage, WithoutARunThereIsNone) {
    sessions.saveAs(folder.file("mine.toml"));
    EXPECT_FALSE(fs::exists(folder.file("mine.toml")));
    EXPECT_EQ(told(), "");
    window.menus().refresh();
    EXPECT_FALSE(window.menus().entry("saveSession").isEnabled());
    EXPECT_FALSE(window.menus().entry("saveSessionAs").isEnabled());
    useFlatScene();
    window.menus().refresh();
    EXPECT_TRUE(window.menus().entry("saveSession").isEnabled());
    EXPECT_TRUE(window.menus().entry("saveSessionAs").isEnabled());
    EXPECT_FALSE(window.menus().entry("restoreSession").isEnabled()) << "none is kept";
}

TEST_F(SessionOnStage, HasThePartThatAFeatureAdded) {
    QString state = QStringLiteral("as saved");
    const QString key = QStringLiteral("test/state");
    stage.keepInSession({[&](QVariantMap& kept) { kept.insert(key, state); },
                         [&](const QVariantMap& kept) { state = kept.value(key).toString(); }});
    ASSERT_NO_FATAL_FAILURE(open(shippedScene("polystyrene")));
    EXPECT_EQ(state, QStringLiteral("as saved")) << "a scene alone restores nothing";
    sessions.saveAs(folder.file("mine.toml"));
    EXPECT_EQ(windowSectionOf(folder.file("mine.toml")).value(key).toString(), state);
    state = QStringLiteral("changed");
    ASSERT_NO_FATAL_FAILURE(open(folder.file("mine.toml")));
    EXPECT_EQ(state, QStringLiteral("as saved"));
}

TEST_F(SessionOnStage, IsASceneAndSavedToItsFileAgain) {
    ASSERT_NO_FATAL_FAILURE(open(shippedScene("polystyrene")));
    sessions.saveAs(folder.file("mine"));
    EXPECT_NE(told().find("mine.toml"), std::string::npos) << told();
    for (const double setpoint : {3e-9, 4e-9}) {
        SceneDescription next = *edits.wanted();
        next.setpoint = setpoint;
        edits.change("Setpoint", next);
        ASSERT_TRUE(changeEnds());
        sessions.save();
        EXPECT_EQ(readScene(folder.file("mine.toml")).setpoint, setpoint);
        ASSERT_NO_FATAL_FAILURE(open(folder.file("mine.toml")));
        EXPECT_EQ(run().scene().description.setpoint, setpoint);
    }
}

TEST_F(SessionOnStage, SaysWhyItCannotBeWritten) {
    ASSERT_NO_FATAL_FAILURE(open(shippedScene("polystyrene")));
    sessions.saveAs(folder.write("taken", "a file") / "mine.toml");
    EXPECT_NE(complaint().find("taken"), std::string::npos);
    EXPECT_EQ(told().find("Saved as"), std::string::npos) << told();
    EXPECT_EQ(contentOf(folder.file("taken")), "a file");
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
