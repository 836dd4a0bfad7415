#include "app/recording/Bundle.h"
#include "app/recording/RecordedRun.h"
#include "app/window/recording/RecordingControl.h"
#include "app/window/scene/SceneControl.h"
#include "tests/app/window/WindowFixture.h"
#include "tests/support/ShippedScene.h"
#include "ui/shell/Menus.h"

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
        stage.get<SceneControl>().open(folder.file("data/scenes/polystyrene.toml"));
        ASSERT_TRUE(eventually([this] {  // the black box begins anew with the fitted model
            return stage.run() != nullptr && !stage.run()->loaded().needs.pending;
        }));
        ASSERT_TRUE(runsFor(0.3));
    }

    /// @return the bundle's file; empty: there is none
    fs::path bundle() {
        EXPECT_TRUE(eventually([this] { return window.menus().entry("bundle").isEnabled(); }));
        QSignalSpy bundled(&stage.get<BundleControl>(), &BundleControl::bundled);
        QTest::keyClick(&window, Qt::Key_B, Qt::ControlModifier);
        return eventually([&] { return bundled.count() == 1; })
                   ? fs::path(bundled[0][0].toString().toStdString())
                   : fs::path();
    }
};

TEST_F(BundleInWindow, HoldsTheRecordingThatGoesOn) {
    window.menus().entry("record").trigger();
    ASSERT_TRUE(runsFor(0.3));
    const fs::path file = bundle();
    ASSERT_TRUE(isBundle(file));
    EXPECT_FALSE(window.menus().entry("record").isChecked());
    const RunLocation input(file);
    EXPECT_GT(readRun(input.folder()).samples.size(), 100U);
    EXPECT_TRUE(fs::exists(input.folder() / "picture.png"));
    EXPECT_TRUE(fs::exists(input.folder() / "scan/particles.gsf"));
    EXPECT_NE(bundle(), file) << "the first one stays";
}

TEST_F(BundleInWindow, HoldsACompactRecordingOnceItIsPacked) {
    window.menus().entry("compactRecordings").setChecked(true);
    window.menus().entry("record").trigger();
    ASSERT_TRUE(runsFor(0.3));
    const RunLocation input(bundle());
    EXPECT_TRUE(fs::exists(input.folder() / "recording.h5"));
    EXPECT_FALSE(fs::exists(input.folder() / "force_log.csv"));
    EXPECT_GT(readRun(input.folder()).samples.size(), 100U);
}

TEST_F(BundleInWindow, HoldsTheLastSecondsWhereNothingWasRecorded) {
    const RunLocation input(bundle());
    EXPECT_GT(readRun(input.folder()).samples.size(), 100U);
}

TEST_F(BundleInWindow, OpensWithoutItsScan) {
    const fs::path file = bundle();
    fs::remove_all(folder.file("data"));
    QSignalSpy opened(&stage.get<SceneControl>(), &SceneControl::opened);
    stage.get<SceneControl>().open(file);
    ASSERT_TRUE(eventually([&] { return opened.count() == 1; })) << told();
    EXPECT_EQ(fs::path(stage.run()->scene().description.sample.file).filename(), "particles.gsf");
    stage.get<SceneControl>().open(file);
    ASSERT_TRUE(eventually([this] { return told().find("particles") != std::string::npos; }));
}

}  // namespace
}  // namespace asperity::test
