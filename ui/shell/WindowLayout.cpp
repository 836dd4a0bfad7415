#include "ui/shell/WindowLayout.h"

#include "ui/shell/CardColumn.h"
#include "ui/shell/PageTabs.h"
#include "ui/widgets/Card.h"
#include "ui/widgets/Theme.h"

#include <QBoxLayout>
#include <QHBoxLayout>
#include <QScrollArea>
#include <QShortcut>
#include <QSplitter>
#include <QStackedLayout>
#include <QToolButton>
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

void addPageSwitches(std::vector<PanelSwitch>& switches, const QString& area, int group,
                     PageTabs& pages) {
    for (const PageTabs::Page& page : pages.pages()) {
        switches.push_back(
            {area + page.title, page.title, group, page.shownAtFirst,
             [&pages, panel = page.panel] { return pages.isShown(panel); },
             [&pages, panel = page.panel](bool shown) { pages.setShown(panel, shown); },
             [&pages, panel = page.panel] { pages.showPage(panel); }});
    }
}

}  // namespace

WindowLayout::WindowLayout(const Middle& middle, QWidget* parent)
    : QWidget(parent)
    , views_(middle.split)
    , showViews_(middle.showViews)
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
    rows_->addWidget(middle.views);
    rows_->addWidget(tools_);
    rows_->setSizes(kRowShares);
    sides_->addWidget(rows_);
    sides_->addWidget(sidePages_);
    sides_->setSizes(kSideShares);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(kPanelGap, 0, kPanelGap, 0);
    column->setSpacing(kPanelGap);
    column->addWidget(middle.top);
    auto* area = new QWidget(this);
    auto* pages = new QStackedLayout(area);
    pages->addWidget(sides_);
    column->addWidget(area, 1);
    maximizer_ = new Maximizer(*pages, *middle.banner, *middle.column);
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
    return {sides_, rows_, &cards_->splitter(), views_};
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
    showViews_();
    views_->setSizes(QVector<int>(views_->count(), kSideShares.front()).toList());
}

Maximizer::Maximizer(QStackedLayout& pages, QWidget& banner, QBoxLayout& bannerHome)
    : QObject(&pages)
    , pages_(pages)
    , banner_(banner)
    , bannerHome_(bannerHome)
    , page_(new QWidget(pages.parentWidget()))
    , column_(new QVBoxLayout(page_))
    , escape_(new QShortcut(Qt::Key_Escape, page_)) {
    column_->setContentsMargins(0, 0, 0, 0);
    column_->setSpacing(kPanelGap);
    auto* back = new QToolButton(page_);
    back->setObjectName(QStringLiteral("backFromEnlarged"));
    back->setText(tr("◂ Back to all panels"));
    back->setToolTip(tr("Restore size and position, as a double click on the title does"));
    back->setFocusPolicy(Qt::TabFocus);
    column_->addWidget(back);
    pages_.addWidget(page_);
    escape_->setEnabled(false);
    connect(back, &QToolButton::clicked, this, &Maximizer::restore);
    connect(escape_, &QShortcut::activated, this, &Maximizer::restore);
}

void Maximizer::toggle(QWidget& panel) {
    const bool isEnlarged = panel_ == &panel;
    restore();
    if (auto* home = qobject_cast<QSplitter*>(panel.parentWidget());
        home != nullptr && !isEnlarged) {
        enlarge(panel, *home);
    }
}

void Maximizer::enlarge(QWidget& panel, QSplitter& home) {
    panel_ = &panel;
    home_ = &home;
    index_ = home.indexOf(&panel);
    sizes_ = home.saveState();
    if (auto* card = qobject_cast<Card*>(&panel)) {
        wasFolded_ = card->isFolded();
        card->setFolded(false);
        card->setEnlarged(true);
    }
    column_->addWidget(&banner_);
    column_->addWidget(&panel, 1);
    panel.show();
    pages_.setCurrentWidget(page_);
    escape_->setEnabled(escapeWorks_);
    Q_EMIT changed(true);
}

void Maximizer::restore() {
    if (panel_ == nullptr) {
        return;
    }
    QWidget& panel = *panel_;
    panel_ = nullptr;
    escape_->setEnabled(false);
    if (auto* card = qobject_cast<Card*>(&panel)) {
        card->setEnlarged(false);
        card->setFolded(wasFolded_);
    }
    bannerHome_.insertWidget(0, &banner_);
    home_->insertWidget(index_, &panel);
    panel.show();
    home_->restoreState(sizes_);
    pages_.setCurrentIndex(0);
    Q_EMIT changed(false);
}

void Maximizer::setEscape(bool works) {
    escapeWorks_ = works;
    escape_->setEnabled(works && isActive());
}

}  // namespace asperity
