#include "ui/shell/PageTabs.h"

#include "ui/shell/CardColumn.h"

#include <QScrollArea>
#include <QTabBar>

#include <algorithm>
#include <stdexcept>

namespace asperity {

PageTabs::PageTabs(const char* objectName, QWidget* parent) : QTabWidget(parent) {
    setObjectName(QString::fromUtf8(objectName));
    setDocumentMode(true);
    tabBar()->setObjectName(objectName + QStringLiteral("Bar"));
    tabBar()->setFocusPolicy(Qt::TabFocus);  // a click leaves the keys to the view
    tabBar()->setExpanding(false);
    connect(this, &QTabWidget::tabCloseRequested, this, [this](int index) {
        setShown(static_cast<QScrollArea*>(widget(index))->widget(), false);
    });
    connect(this, &QTabWidget::tabBarDoubleClicked, this, [this](int index) {
        if (index >= 0) {
            Q_EMIT enlargeRequested();
        }
    });
    settle();
}

void PageTabs::addPage(QWidget* panel, const QString& title, bool shownAtFirst) {
    auto* area = qobject_cast<QScrollArea*>(panel);
    Page page{panel, area != nullptr ? area : scrolled(panel, true), title, shownAtFirst};
    page.area->setParent(this);
    page.area->hide();
    pages_.push_back(page);
    if (shownAtFirst) {
        setTabToolTip(addTab(page.area, title), toolTipOf(page));
    }
    settle();
    Q_EMIT pageAdded();
}

const PageTabs::Page& PageTabs::pageOf(const QWidget* panel) const {
    const auto found = std::find_if(pages_.begin(), pages_.end(), [panel](const Page& page) {
        return page.panel == panel || page.area->widget() == panel;
    });
    if (found == pages_.end()) {
        throw std::invalid_argument("no page of these tabs");
    }
    return *found;
}

/// Among the tabs that are shown: pages keep their order.
int PageTabs::tabIndexOf(const Page& page) const {
    int index = 0;
    for (const Page& before : pages_) {
        if (&before == &page) {
            break;
        }
        index += indexOf(before.area) >= 0 ? 1 : 0;
    }
    return index;
}

QString PageTabs::toolTipOf(const Page& page) {
    const QString& own = page.panel->toolTip();
    return (own.isEmpty() ? page.title : own) + tr("\nDouble click: enlarge");
}

bool PageTabs::isShown(const QWidget* panel) const { return indexOf(pageOf(panel).area) >= 0; }

void PageTabs::setShown(const QWidget* panel, bool shown) {
    const Page& page = pageOf(panel);
    const int index = indexOf(page.area);
    if (shown && index < 0) {
        insertTab(tabIndexOf(page), page.area, page.title);
        setTabToolTip(tabIndexOf(page), toolTipOf(page));
    } else if (!shown && index >= 0) {
        removeTab(index);
    }
    open_ = open_ || shown;
    settle();
}

void PageTabs::showPage(const QWidget* panel) {
    setShown(panel, true);
    setCurrentWidget(pageOf(panel).area);
}

void PageTabs::setOpen(bool open) {
    open_ = open;
    if (open && count() == 0 && !pages_.empty()) {
        setShown(pages_.front().panel, true);
    }
    settle();
}

void PageTabs::settle() { setVisible(isOpen()); }

QString PageTabs::pageOnTop() const {
    return currentIndex() < 0 ? QString() : tabText(currentIndex());
}

void PageTabs::putOnTop(const QString& title) {
    for (int i = 0; i < count(); ++i) {
        if (tabText(i) == title) {
            setCurrentIndex(i);
        }
    }
}

void PageTabs::reset() {
    for (const Page& page : pages_) {
        setShown(page.panel, page.shownAtFirst);
    }
    open_ = true;
    setCurrentIndex(0);
    settle();
}

}  // namespace asperity
