#include "app/window/fidelity/FidelityControl.h"

#include "app/window/fidelity/FidelityPanel.h"
#include "tests/app/window/ControlFixture.h"

namespace asperity::test {
namespace {

class FidelityControlTest : public ControlFixture {
protected:
    void SetUp() override { useFlatScene(); }
    FidelityPanel& panel() { return *window.findChild<FidelityPanel*>(); }
    const Scene& scene() { return run().scene(); }

    FidelityControl& fidelity = stage.add<FidelityControl>();
};

TEST_F(FidelityControlTest, ATermIsOverruledAndGivenBack) {
    ASSERT_TRUE(has(scene().model, ModelTerm::Adhesion));
    Q_EMIT panel().termChosen(ModelTerm::Adhesion, false);
    ASSERT_TRUE(changeEnds());
    EXPECT_FALSE(has(scene().model, ModelTerm::Adhesion));
    Q_EMIT panel().automaticRequested();
    ASSERT_TRUE(changeEnds());
    EXPECT_TRUE(has(scene().model, ModelTerm::Adhesion));
}

TEST_F(FidelityControlTest, AModelIsPickedAndTheChartStays) {
    panel().showTradeOff(TradeOff{});
    ForceModelOptions options = ofForce(scene().model);
    options.closestPointSearch = SearchEffort::Local;
    Q_EMIT panel().optionsPicked(options);
    ASSERT_TRUE(changeEnds());
    EXPECT_EQ(scene().model.closestPointSearch, SearchEffort::Local);
    EXPECT_TRUE(panel().tradeOff().has_value());
    useFlatScene();
    EXPECT_FALSE(panel().tradeOff().has_value()) << "of another scene";
}

TEST_F(FidelityControlTest, AModelThatCannotBeIsRefused) {
    const LiveRun* const before = runs.run();
    ForceModelOptions options = ofForce(scene().model);
    options.law = ContactLaw::HertzFilm;  // the sample has no film
    Q_EMIT panel().optionsPicked(options);
    EXPECT_NE(complaint(), "");
    EXPECT_EQ(runs.run(), before);
}

TEST_F(FidelityControlTest, AStudyCanBeStopped) {
    Q_EMIT panel().measureRequested();
    Q_EMIT panel().measureRequested();  // one at a time
    Q_EMIT panel().stopRequested();
    QTest::qWait(200);  // in which it ends: nothing may come of it
    EXPECT_FALSE(panel().tradeOff().has_value());
    EXPECT_EQ(complaint(), "");
}

}  // namespace
}  // namespace asperity::test
