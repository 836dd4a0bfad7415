#include "ui/panels/Card.h"

#include <QToolButton>
#include <QVBoxLayout>
#include <QtTest>

#include <gtest/gtest.h>

namespace asperity {
namespace {

class FilledCard : public Card {
public:
    FilledCard() : Card(QStringLiteral("Forces")) {
        body().addWidget(content);
        content->setMinimumHeight(100);
    }
    QWidget* content = new QWidget(this);
};

TEST(Card, AClickOnTheTitleFoldsItAndTheNextOneUnfoldsIt) {
    FilledCard card;
    card.setFoldable();
    auto* heading = card.findChild<QToolButton*>();
    ASSERT_NE(heading, nullptr);
    EXPECT_EQ(card.title(), QStringLiteral("Forces"));
    EXPECT_FALSE(card.isFolded());
    const int before = card.sizeHint().height();
    QTest::mouseClick(heading, Qt::LeftButton);
    EXPECT_TRUE(card.isFolded());
    EXPECT_FALSE(card.content->isVisibleTo(&card));
    EXPECT_LT(card.sizeHint().height(), before - 90);
    QTest::mouseClick(heading, Qt::LeftButton);
    EXPECT_FALSE(card.isFolded());
    EXPECT_TRUE(card.content->isVisibleTo(&card));
}

}  // namespace
}  // namespace asperity
