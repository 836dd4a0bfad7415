#include "app/session/BundleControl.h"

#include "app/recording/Bundle.h"
#include "app/recording/RecordedRun.h"
#include "app/recording/RunPlace.h"
#include "tests/app/window/WindowFixture.h"
#include "tests/support/ShippedScene.h"
#include "ui/window/WindowMenus.h"

#include <QAction>
#include <QSignalSpy>
#include <QtTest>

#include <filesystem>

namespace asperity::test {
namespace {

namespace fs = std::filesystem;

class BundleInWindow : public Window {
protected:
    void SetUp() override {
        Window::SetUp();
        fs::copy(shippedScene("polystyrene").parent_path().parent_path(), folder.file("data"),
                 fs::copy_options::recursive);
        session.scenes().open(folder.file("data/scenes/polystyrene.toml"));
        ASSERT_TRUE(eventually([this] {  // the black box begins anew with the fitted model
            return session.run() != nullptr && !session.run()->loaded().needs.pending;
        }));
        ASSERT_TRUE(runsFor(0.3));
    }

    /// @return the bundle's file; empty: there is none
    fs::path bundle() {
        EXPECT_TRUE(eventually([this] { return window.menus().bundle->isEnabled(); }));
        QSignalSpy bundled(&session.bundles(), &BundleControl::bundled);
        QTest::keyClick(&window, Qt::Key_B, Qt::ControlModifier);
        return eventually([&] { return bundled.count() == 1; })
                   ? fs::path(bundled[0][0].toString().toStdString())
                   : fs::path();
    }
};

TEST_F(BundleInWindow, HoldsTheRecordingThatGoesOn) {
    window.menus().record->trigger();
    ASSERT_TRUE(runsFor(0.3));
    const fs::path file = bundle();
    ASSERT_TRUE(isBundle(file));
    EXPECT_FALSE(window.menus().record->isChecked());
    const RunPlace place(file);
    EXPECT_GT(readRun(place.folder()).samples.size(), 100U);
    EXPECT_TRUE(fs::exists(place.folder() / "picture.png"));
    EXPECT_TRUE(fs::exists(place.folder() / "scan/particles.gsf"));
    EXPECT_NE(bundle(), file) << "the first one stays";
}

TEST_F(BundleInWindow, HoldsACompactRecordingOnceItIsPacked) {
    window.menus().compactRecordings->setChecked(true);
    window.menus().record->trigger();
    ASSERT_TRUE(runsFor(0.3));
    const RunPlace place(bundle());
    EXPECT_TRUE(fs::exists(place.folder() / "recording.h5"));
    EXPECT_FALSE(fs::exists(place.folder() / "force_log.csv"));
    EXPECT_GT(readRun(place.folder()).samples.size(), 100U);
}

TEST_F(BundleInWindow, HoldsTheLastSecondsWhereNothingWasRecorded) {
    const RunPlace place(bundle());
    EXPECT_GT(readRun(place.folder()).samples.size(), 100U);
}

TEST_F(BundleInWindow, OpensWithoutItsScan) {
    const fs::path file = bundle();
    fs::remove_all(folder.file("data"));
    QSignalSpy opened(&session.scenes(), &SceneControl::opened);
    session.scenes().open(file);
    ASSERT_TRUE(eventually([&] { return opened.count() == 1; })) << told();
    EXPECT_EQ(fs::path(session.run()->scene().description.sample.file).filename(), "particles.gsf");
    session.scenes().open(file);
    ASSERT_TRUE(eventually([this] { return told().find("particles") != std::string::npos; }));
}

}  // namespace
}  // namespace asperity::test
