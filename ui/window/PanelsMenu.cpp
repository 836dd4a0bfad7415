#include "ui/window/PanelsMenu.h"

#include "ui/window/Maximizer.h"
#include "ui/window/WindowLayout.h"

#include <QAction>
#include <QMenu>

#include <optional>

namespace asperity {

PanelsMenu::PanelsMenu(QMenu& menu, WindowLayout& layout)
    : QObject(&menu), menu_(menu), layout_(layout) {
    menu_.setToolTipsVisible(true);
    connect(&layout_, &WindowLayout::panelsChanged, this, &PanelsMenu::fill);
    connect(&menu_, &QMenu::aboutToShow, this, &PanelsMenu::check);
    fill();
}

void PanelsMenu::fill() {
    menu_.clear();
    std::optional<int> group;
    for (const PanelSwitch& part : layout_.switches()) {
        if (group && *group != part.group) {
            menu_.addSeparator();
        }
        group = part.group;
        QAction* entry = menu_.addAction(part.title);
        entry->setObjectName(part.key);
        entry->setCheckable(true);
        entry->setToolTip(tr("Hide or show “%1”").arg(part.title));
        connect(entry, &QAction::triggered, &layout_, [this, part](bool shown) {
            layout_.maximizer().restore();
            part.setShown(shown);
            if (shown) {
                part.toFront();
            }
        });
    }
    menu_.addSeparator();
    QAction* reset = menu_.addAction(tr("&Reset layout"));
    reset->setObjectName(QStringLiteral("resetLayout"));
    reset->setToolTip(tr("Show, size and place all panels as at first"));
    connect(reset, &QAction::triggered, &layout_, &WindowLayout::reset);
    check();
}

void PanelsMenu::check() {
    for (const PanelSwitch& part : layout_.switches()) {
        menu_.findChild<QAction*>(part.key)->setChecked(part.isShown());
    }
}

}  // namespace asperity
