#include "ui/shell/CardColumn.h"

#include "ui/widgets/Card.h"

#include <QScrollArea>
#include <QScrollBar>
#include <QSplitter>
#include <QVBoxLayout>

#include <algorithm>

namespace asperity {

namespace {

constexpr int kShareUnit = 1000;  ///< sizes of a splitter are relative, but whole numbers

/// A splitter whose handles say what they are for.
class PanelSplitter : public QSplitter {
public:
    using QSplitter::QSplitter;

protected:
    QSplitterHandle* createHandle() override {
        QSplitterHandle* handle = QSplitter::createHandle();
        handle->setToolTip(tr("Drag to resize"));
        return handle;
    }
};

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

QSplitter* newSplitter(Qt::Orientation orientation, const char* objectName, QWidget* parent) {
    auto* splitter = new PanelSplitter(orientation, parent);
    splitter->setObjectName(QString::fromUtf8(objectName));
    splitter->setHandleWidth(kPanelGap);
    splitter->setChildrenCollapsible(false);
    return splitter;
}

QScrollArea* scrolled(QWidget* panel, bool sideways) {
    auto* area = new QScrollArea;
    area->setFrameShape(QFrame::NoFrame);
    area->setWidgetResizable(true);
    area->setFocusPolicy(Qt::NoFocus);
    area->setWidget(panel);
    if (!sideways) {
        area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
        area->setMinimumWidth(panel->minimumWidth() +
                              area->verticalScrollBar()->sizeHint().width());
    }
    return area;
}

}  // namespace asperity
