#include "app/window/Stage.h"

#include "tests/app/window/ControlFixture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

namespace asperity::test {
namespace {

std::vector<std::string>* ended = nullptr;

class First : public Feature {
public:
    explicit First(Stage& stage) : Feature(stage) {}
    ~First() override { ended->push_back("first"); }
};

class Second : public Feature {
public:
    explicit Second(Stage& stage) : Feature(stage) {}
    ~Second() override { ended->push_back("second"); }
};

/// What features note; it outlives the stage, which tells them until its end.
struct Told {
    std::vector<std::string> words;
};

class StageTest : public Told, public ControlFixture {};

TEST_F(StageTest, AFrameHasItsStepsInOrderWhateverWasAddedFirst) {
    std::vector<std::string>& told = words;
    const auto tell = [&told](const char* what) {
        return [&told, what](double) { told.emplace_back(what); };
    };
    stage.onFrame(FrameStep::Show, tell("show"));
    stage.onFrame(FrameStep::Move, tell("move"));
    stage.onFrame(FrameStep::Act, tell("act"));
    stage.onFrame(FrameStep::Show, tell("show later"));
    stage.onTick([&told](const TickSample&) {
        if (told.back() != "tick") {
            told.emplace_back("tick");
        }
    });
    useFlatScene();
    stage.play(5);
    const std::vector<std::string> frame{"move", "tick", "act", "show", "show later"};
    EXPECT_TRUE(eventually([&] { return std::ranges::count(told, "show later") > 3; }));
    const auto begin = std::ranges::find(told, "tick");
    ASSERT_GE(told.end() - begin, 4);
    EXPECT_EQ(std::vector<std::string>(begin - 1, begin + 4), frame);
    EXPECT_EQ(std::ranges::count(told, "move"), std::ranges::count(told, "show"));
}

TEST_F(StageTest, WithoutARunNoFeatureIsTold) {
    int frames = 0;
    stage.onFrame(FrameStep::Act, [&frames](double) { ++frames; });
    stage.play(1);
    QTest::qWait(50);
    EXPECT_EQ(frames, 0);
}

TEST(StageOfFeatures, FindsThemAndEndsTheLastOneFirst) {
    std::vector<std::string> order;
    ended = &order;
    {
        HostStandIn window;
        LivePanels panels(window);
        Stage stage(window, panels);
        First& first = stage.add<First>();
        EXPECT_THROW(static_cast<void>(stage.get<Second>()), std::logic_error) << "not yet there";
        stage.add<Second>();
        EXPECT_EQ(&stage.get<First>(), &first);
    }
    EXPECT_EQ(order, (std::vector<std::string>{"second", "first"}));
}

}  // namespace
}  // namespace asperity::test
