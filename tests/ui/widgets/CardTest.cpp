#include "ui/widgets/Card.h"

#include "tests/support/ShortDoubleClicks.h"
#include "tests/support/Waits.h"

#include <QApplication>
#include <QSignalSpy>
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

class CardTest : public ::testing::Test {
protected:
    CardTest() {
        card.setFoldable();
        card.resize(300, 200);
        card.show();
    }
    QToolButton& heading() { return *card.findChild<QToolButton*>(); }
    QPoint arrow() { return {4, heading().height() / 2}; }
    QPoint words() { return {heading().width() - 8, heading().height() / 2}; }
    bool becomes(bool folded) {
        return test::eventually([&] { return card.isFolded() == folded; });
    }

    const test::ShortDoubleClicks quick;
    FilledCard card;
};

TEST_F(CardTest, AClickOnTheArrowFoldsItAtOnceAndTheNextOneUnfoldsIt) {
    EXPECT_EQ(card.title(), QStringLiteral("Forces"));
    EXPECT_FALSE(card.isFolded());
    const int before = card.sizeHint().height();
    QTest::mouseClick(&heading(), Qt::LeftButton, Qt::NoModifier, arrow());
    EXPECT_TRUE(card.isFolded());
    EXPECT_FALSE(card.content->isVisibleTo(&card));
    EXPECT_LT(card.sizeHint().height(), before - 90);
    EXPECT_LT(card.maximumHeight(), 40);
    QTest::mouseClick(&heading(), Qt::LeftButton, Qt::NoModifier, arrow());
    EXPECT_FALSE(card.isFolded());
    EXPECT_TRUE(card.content->isVisibleTo(&card));
}

TEST_F(CardTest, AClickOnTheTitleFoldsItWhenNoSecondClickFollows) {
    QSignalSpy enlarged(&card, &Card::enlargeRequested);
    QTest::mouseClick(&heading(), Qt::LeftButton, Qt::NoModifier, words());
    EXPECT_FALSE(card.isFolded());
    EXPECT_TRUE(becomes(true));
    QTest::mouseClick(&heading(), Qt::LeftButton, Qt::NoModifier, words());
    EXPECT_TRUE(becomes(false));
    EXPECT_EQ(enlarged.count(), 0);
}

TEST_F(CardTest, ADoubleClickOnTheTitleAsksForRoomAndFoldsNothing) {
    QSignalSpy enlarged(&card, &Card::enlargeRequested);
    QSignalSpy folded(&card, &Card::foldedChanged);
    QTest::mouseClick(&heading(), Qt::LeftButton, Qt::NoModifier, words());
    QTest::mouseDClick(&heading(), Qt::LeftButton, Qt::NoModifier, words());
    QTest::qWait(2 * QApplication::doubleClickInterval());  // the first click must fold nothing
    EXPECT_EQ(enlarged.count(), 1);
    EXPECT_EQ(folded.count(), 0);
    QTest::mouseDClick(&card, Qt::LeftButton, Qt::NoModifier,
                       QPoint(card.width() - 20, heading().geometry().center().y()));
    EXPECT_EQ(enlarged.count(), 2) << "right of the words";
    QTest::mouseDClick(&card, Qt::LeftButton, Qt::NoModifier, QPoint(2, card.height() - 3));
    EXPECT_EQ(enlarged.count(), 2) << "below the title";
}

TEST_F(CardTest, AnEnlargedCardCannotBeFolded) {
    card.setEnlarged(true);
    QTest::mouseClick(&heading(), Qt::LeftButton, Qt::NoModifier, arrow());
    EXPECT_FALSE(card.isFolded());
    card.setEnlarged(false);
    QTest::mouseClick(&heading(), Qt::LeftButton, Qt::NoModifier, arrow());
    EXPECT_TRUE(card.isFolded());
}

TEST(Card, AClickOnTheTitleOfOneThatCannotBeFoldedDoesNothing) {
    FilledCard card;
    EXPECT_TRUE(card.findChild<QToolButton*>()->testAttribute(Qt::WA_TransparentForMouseEvents));
}

}  // namespace
}  // namespace asperity
