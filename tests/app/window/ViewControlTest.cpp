#include "app/window/ViewControl.h"

#include "tests/app/window/ControlFixture.h"

#include <QImage>
#include <QLabel>
#include <QtTest>

namespace asperity::test {
namespace {

class ViewControlTest : public ControlFixture {
protected:
    ViewControl& views = stage.add<ViewControl>();
};

TEST_F(ViewControlTest, DrawsThePanelsEverySecondFrameAndCountsBoth) {
    useFlatScene();
    for (int frame = 0; frame <= 40; ++frame) {
        runs.fetch();
        views.show(100.0 + 0.025 * frame);
    }
    const std::vector<ViewRate> rates = views.rates();
    ASSERT_EQ(rates.size(), 5U);
    EXPECT_EQ(rates[0].view, "zoom");
    EXPECT_NEAR(rates[0].framesPerSecond, 40.0, 1.0);
    for (const char* panel : {"forces", "cantilever", "overview", "second"}) {
        const auto found = std::ranges::find(rates, panel, &ViewRate::view);
        ASSERT_NE(found, rates.end()) << panel;
        EXPECT_NEAR(found->framesPerSecond, 20.0, 1.0);
    }
}

TEST_F(ViewControlTest, SavesAPictureWithAndWithoutARun) {
    const auto save = [this](const char* name) {
        const QString file = QString::fromStdString((folder.path() / name).string());
        views.savePicture(file);
        return QImage(file).size();
    };
    EXPECT_EQ(save("empty.png"), window.size());
    useFlatScene();
    EXPECT_EQ(save("run.png"), window.size());
    EXPECT_TRUE(told().starts_with("Saved as ")) << told();
    (void)save("no/such/folder.png");
    EXPECT_NE(complaint().find("folder.png: cannot be written: its folder is missing"),
              std::string::npos);
}

/// A picture at the moment of snap-in said "in c": the line's room was that of "far".
TEST_F(ViewControlTest, APictureShowsTextsThatHaveJustChangedInFull) {
    window.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
    auto* state = window.findChild<QLabel*>(QStringLiteral("state"));
    state->setText(QStringLiteral("a longer text than before"));
    ASSERT_LT(state->width(), state->sizeHint().width());
    views.savePicture(QString::fromStdString(folder.file("now.png").string()));
    EXPECT_GE(state->width(), state->sizeHint().width());
}

/// "the picture cannot be written" was all that was said of another type.
TEST_F(ViewControlTest, SaysInWhichTypesAPictureCanBeSaved) {
    const auto save = [this](const char* name) {
        views.savePicture(QString::fromStdString(folder.file(name).string()));
    };
    save("window.doc");
    const std::string refusal = complaint();
    EXPECT_NE(refusal.find("window.doc: no picture can be written with this extension"),
              std::string::npos)
        << refusal;
    EXPECT_NE(refusal.find(".png .jpg"), std::string::npos) << refusal;
    save("window.JPG");
    EXPECT_EQ(complaint(), "");
    EXPECT_EQ(QImage(QString::fromStdString(folder.file("window.JPG").string())).size(),
              window.size());
    save("window");
    EXPECT_TRUE(std::filesystem::exists(folder.file("window.png"))) << "the usual type";
}

}  // namespace
}  // namespace asperity::test
