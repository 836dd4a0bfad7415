#include "ui/widgets/FlowLayout.h"

#include <QWidget>

#include <gtest/gtest.h>

namespace asperity {
namespace {

class FlowLayoutTest : public ::testing::Test {
protected:
    FlowLayoutTest() {
        flow->setContentsMargins(0, 0, 0, 0);
        flow->setSpacing(10);
    }
    /// @return one that is 100 pixels wide, and more where it stretches
    QWidget* add(int height, int stretch = 0, int largest = 1000) {
        auto* widget = new QWidget;
        widget->setMinimumSize(100, height);
        widget->setMaximumSize(largest, height);
        flow->addWidget(widget, stretch);
        return widget;
    }
    void layAt(int width) {
        whole.resize(width, flow->heightForWidth(width));
        flow->setGeometry(whole.rect());
    }

    QWidget whole;
    FlowLayout* flow = new FlowLayout(&whole);
};

TEST_F(FlowLayoutTest, KeepsOneLineWhereThereIsRoom) {
    const QWidget* tall = add(40);
    const QWidget* low = add(20);
    layAt(210);
    EXPECT_EQ(tall->geometry(), QRect(0, 0, 100, 40));
    EXPECT_EQ(low->geometry(), QRect(110, 20, 100, 20)) << "aligned at the bottom";
    EXPECT_EQ(flow->sizeHint(), QSize(210, 40));
}

TEST_F(FlowLayoutTest, BeginsAnotherLineWhereThereIsNone) {
    add(40);
    const QWidget* second = add(20);
    layAt(209);
    EXPECT_EQ(second->geometry(), QRect(0, 50, 100, 20));
    EXPECT_EQ(flow->heightForWidth(209), 70);
    EXPECT_EQ(flow->minimumSize().width(), 100);
}

TEST_F(FlowLayoutTest, WhatIsLeftGoesToThoseThatStretchUpToTheirMaximum) {
    const QWidget* small = add(20, 1, 130);
    const QWidget* large = add(20, 1);
    layAt(310);
    EXPECT_EQ(small->width(), 130);
    EXPECT_EQ(large->width(), 170);
}

TEST_F(FlowLayoutTest, RoomBetweenPushesTheRestToTheEnd) {
    const QWidget* first = add(20);
    flow->addStretch();
    const QWidget* last = add(20);
    layAt(400);
    EXPECT_EQ(first->geometry().left(), 0);
    EXPECT_EQ(last->geometry().left(), 400 - first->width());
}

TEST_F(FlowLayoutTest, RoomBetweenGoesToTheNextLineWithWhatItPushes) {
    add(20);
    flow->addStretch();
    const QWidget* last = add(20);
    layAt(180);
    EXPECT_EQ(last->geometry(), QRect(80, 30, 100, 20));
}

/// Asks for 100 pixels, or more, and may be 50 wide.
class Asking : public QWidget {
public:
    explicit Asking(int width) : width_(width) {}
    [[nodiscard]] QSize sizeHint() const override { return {width_, 20}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {50, 20}; }

private:
    int width_;
};

TEST_F(FlowLayoutTest, SharesEquallyUnlessOneAsksForMoreThanItsShare) {
    auto* first = new Asking(100);
    auto* second = new Asking(150);
    flow->addWidget(first, 1);
    flow->addWidget(second, 1);
    layAt(330);
    EXPECT_EQ(first->width(), 160);
    EXPECT_EQ(second->width(), 160);
    layAt(270);
    EXPECT_EQ(first->width(), 110);
    EXPECT_EQ(second->width(), 150);
    layAt(259);
    EXPECT_EQ(second->y(), 30) << "there is no room for what both ask for";
}

TEST_F(FlowLayoutTest, AHiddenWidgetTakesNoRoom) {
    add(20)->hide();
    const QWidget* shown = add(20);
    layAt(100);
    EXPECT_EQ(shown->pos(), QPoint(0, 0));
}

}  // namespace
}  // namespace asperity
