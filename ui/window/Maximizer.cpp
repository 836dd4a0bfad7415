#include "ui/window/Maximizer.h"

#include "ui/panels/Card.h"
#include "ui/window/Splitters.h"

#include <QBoxLayout>
#include <QHBoxLayout>
#include <QShortcut>
#include <QSplitter>
#include <QStackedLayout>
#include <QToolButton>

namespace asperity {

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
    back->setToolTip(tr("Put this panel back to its place, as a double click on its title does"));
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
    place_ = home.indexOf(&panel);
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
    home_->insertWidget(place_, &panel);
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
