#include "ui/window/WindowLayout.h"

#include "ui/Theme.h"
#include "ui/panels/Card.h"
#include "ui/panels/StateBanner.h"
#include "ui/window/CardColumn.h"
#include "ui/window/Maximizer.h"
#include "ui/window/PageTabs.h"
#include "ui/window/Splitters.h"
#include "ui/window/ViewSide.h"

#include <QScrollArea>
#include <QSplitter>
#include <QStackedLayout>
#include <QVBoxLayout>

namespace asperity {

namespace {

constexpr int kColumnMinimum = 372;  // [px]

// Relative, as a splitter takes them.
const QList<int> kSideShares{6900, 3100};
const QList<int> kRowShares{6500, 3500};

CardColumn* newCards(QWidget* parent) {
    auto* cards = new CardColumn(parent);
    cards->setMinimumWidth(theme::scaled(kColumnMinimum));
    return cards;
}

PanelSwitch columnSwitch(const QString& key, const QString& title, bool shownAtFirst,
                         PageTabs& pages) {
    return {key,
            title,
            4,
            shownAtFirst,
            [&pages] { return pages.isOpen(); },
            [&pages](bool shown) { pages.setOpen(shown); }};
}

void addPageSwitches(std::vector<PanelSwitch>& switches, const QString& place, int group,
                     PageTabs& pages) {
    for (const PageTabs::Page& page : pages.pages()) {
        switches.push_back(
            {place + page.title, page.title, group, page.shownAtFirst,
             [&pages, panel = page.panel] { return pages.isShown(panel); },
             [&pages, panel = page.panel](bool shown) { pages.setShown(panel, shown); },
             [&pages, panel = page.panel] { pages.showPage(panel); }});
    }
}

}  // namespace

WindowLayout::WindowLayout(QWidget* controls, ViewSide* viewSide, QWidget* parent)
    : QWidget(parent)
    , viewSide_(viewSide)
    , sides_(newSplitter(Qt::Horizontal, "sides", this))
    , rows_(newSplitter(Qt::Vertical, "rows", this))
    , cards_(newCards(this))
    , live_(scrolled(cards_, false))
    , tools_(new PageTabs("tools", this))
    , sidePages_(new PageTabs("sidePages", this)) {
    live_->setObjectName(QStringLiteral("live"));
    tools_->setTabsClosable(true);
    sidePages_->setTabBarAutoHide(true);
    sidePages_->addPage(live_, tr("Live"), true);
    rows_->addWidget(viewSide_);
    rows_->addWidget(tools_);
    rows_->setSizes(kRowShares);
    sides_->addWidget(rows_);
    sides_->addWidget(sidePages_);
    sides_->setSizes(kSideShares);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(kPanelGap, 0, kPanelGap, 0);
    column->setSpacing(kPanelGap);
    column->addWidget(controls);
    auto* middle = new QWidget(this);
    auto* pages = new QStackedLayout(middle);
    pages->addWidget(sides_);
    column->addWidget(middle, 1);
    maximizer_ = new Maximizer(*pages, viewSide_->banner(), viewSide_->column());
    for (PageTabs* tabs : {tools_, sidePages_}) {
        connect(tabs, &PageTabs::pageAdded, this, &WindowLayout::panelsChanged);
        connect(tabs, &PageTabs::enlargeRequested, this,
                [this, tabs] { maximizer_->toggle(*tabs); });
    }
}

void WindowLayout::showCards() { sidePages_->showPage(live_); }

void WindowLayout::addCard(Card* card, int share) {
    cards_->add(card, share);
    connect(card, &Card::enlargeRequested, this, [this, card] { maximizer_->toggle(*card); });
    Q_EMIT panelsChanged();
}

std::vector<PanelSwitch> WindowLayout::switches() {
    std::vector<PanelSwitch> switches;
    for (Card* card : cards_->cards()) {
        switches.push_back({QStringLiteral("card/") + card->title(), card->title(), 1, true,
                            [card] { return CardColumn::isShown(*card); },
                            [this, card](bool shown) { cards_->setShown(*card, shown); }});
    }
    addPageSwitches(switches, QStringLiteral("side/"), 2, *sidePages_);
    addPageSwitches(switches, QStringLiteral("tool/"), 3, *tools_);
    // After their pages, which open them.
    switches.push_back(
        columnSwitch(QStringLiteral("sides"), tr("Column on the right"), true, *sidePages_));
    if (!tools_->pages().empty()) {
        switches.push_back(
            columnSwitch(QStringLiteral("tools"), tr("Tools below the view"), false, *tools_));
    }
    return switches;
}

std::vector<QSplitter*> WindowLayout::splitters() {
    return {sides_, rows_, &cards_->splitter(), &viewSide_->views()};
}

void WindowLayout::reset() {
    maximizer_->restore();
    for (const PanelSwitch& each : switches()) {
        each.setShown(each.shownAtFirst);
    }
    cards_->reset();
    tools_->reset();
    sidePages_->reset();
    sides_->setSizes(kSideShares);
    rows_->setSizes(kRowShares);
    QSplitter& views = viewSide_->views();
    views.setSizes(QVector<int>(views.count(), kSideShares.front()).toList());
}

}  // namespace asperity
