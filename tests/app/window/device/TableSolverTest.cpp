#include "app/window/scene/SceneControl.h"
#include "tests/app/window/WindowFixture.h"
#include "tests/support/EventLoopWatchdog.h"

#include <QSignalSpy>

#include <iostream>
#include <optional>

namespace asperity::test {
namespace {

/// A window whose scene has its contact law tabulated, with a watchdog on the event loop.
class TableSolverAlone : public Window {
protected:
    void SetUp() override {
        Window::SetUp();
        openFlatScene();  // the driver compiles its shaders
        watchdog_.emplace();
    }

    void step(const std::string& name, const std::function<void()>& act) {
        watchdog_->enter(name);
        act();
        live(400);  // a loop that something blocks later must have the time to be seen
    }
    std::filesystem::path tableScene() {
        return folder.write("table.toml", "[sample]\nfile = \"" + levelScan(folder, 64).string() +
                                              "\"\n[physics]\nlaw = \"md\"\n"
                                              "[fidelity]\ncontact_solver = \"table\"\n");
    }
    void open(const std::filesystem::path& scene) {
        QSignalSpy shown(&stage.runs(), &RunControl::begun);
        stage.get<SceneControl>().open(scene);
        ASSERT_TRUE(eventually([&] { return shown.count() == 1; }, 60000));
        expectTables();
    }
    void expectTables() {
        const Scene& scene = stage.run()->scene();
        EXPECT_NE(scene.belief.contact.table(), nullptr);
        EXPECT_NE(scene.truth.contact.table(), nullptr);
    }
    void setTip(double radius) {
        SceneDescription next = *stage.edits().wanted();
        next.tip.radius = radius;
        stage.edits().change(QStringLiteral("Tip radius"), next);
        EXPECT_TRUE(changeEnds());
        expectTables();
    }

    std::optional<EventLoopWatchdog> watchdog_;
};

TEST_F(TableSolverAlone, NoTableIsMadeOnTheEventLoop) {
    step("open", [this] { open(tableScene()); });
    step("tip", [this] { setTip(30e-9); });
    step("material", [this] {
        choose("material", "silicon oxide");
        EXPECT_TRUE(changeEnds());
        expectTables();
    });
    step("undo", [this] {
        stage.edits().undo();
        EXPECT_TRUE(changeEnds());
    });
    choose("device", "Simulated device");
    step("tip under a force-feedback device", [this] { setTip(20e-9); });
    const std::vector<BlockedStretch> longest = watchdog_->longest();
    std::cout << tableOf(longest);
    const double limit = watchdog_->longestBlock();
    for (const BlockedStretch& stretch : longest) {
        EXPECT_LT(stretch.processor, limit) << stretch.step;
        EXPECT_LT(stretch.own, kLongestWait) << stretch.step;
    }
}

}  // namespace
}  // namespace asperity::test
