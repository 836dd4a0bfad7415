#include "ui/window/CardColumn.h"

#include "ui/panels/Card.h"
#include "ui/window/Splitters.h"

#include <QSplitter>
#include <QVBoxLayout>

#include <algorithm>

namespace asperity {

namespace {

constexpr int kShareUnit = 1000;  ///< sizes of a splitter are relative, but whole numbers

}  // namespace

CardColumn::CardColumn(QWidget* parent)
    : QWidget(parent), splitter_(newSplitter(Qt::Vertical, "cards", this)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(splitter_, 1);  // all the height while a card is open
    column->addStretch();
    settle();
}

void CardColumn::add(Card* card, int share) {
    cards_.push_back(card);
    shares_.push_back(share * kShareUnit);
    splitter_->addWidget(card);
    card->setFoldable();
    connect(card, &Card::foldedChanged, this, &CardColumn::settle);
    splitter_->setSizes({shares_.begin(), shares_.end()});
    settle();
}

void CardColumn::setShown(Card& card, bool shown) {
    card.setVisible(shown);
    settle();
}

bool CardColumn::isShown(const Card& card) { return !card.isHidden(); }

void CardColumn::reset() {
    for (Card* card : cards_) {
        card->setFolded(false);
    }
    splitter_->setSizes({shares_.begin(), shares_.end()});
}

void CardColumn::settle() {
    const bool anyOpen = std::any_of(cards_.begin(), cards_.end(), [](const Card* card) {
        return isShown(*card) && !card->isFolded();
    });
    splitter_->setSizePolicy(QSizePolicy::Preferred,
                             anyOpen ? QSizePolicy::Expanding : QSizePolicy::Maximum);
}

}  // namespace asperity
