#include "ui/shell/Menus.h"

#include "ui/shell/WindowLayout.h"
#include "ui/widgets/Theme.h"

#include <QAction>
#include <QActionGroup>
#include <QMenu>
#include <QMenuBar>

#include <optional>

namespace asperity {

namespace {

constexpr const char* kOrder = "order";  ///< property of an entry: its index within its menu
constexpr int kSectionOrder = 1000;      ///< more than a section has ranks

int orderOf(const QAction& action) { return action.property(kOrder).toInt(); }

}  // namespace

Menus::Menus(QMenuBar& bar) : QObject(&bar) {
    for (const MenuName name : kValues<MenuName>) {
        QMenu* menu = bar.addMenu(tr(nameOf(name)));
        menu->setToolTipsVisible(true);  // they say why an entry does not work
        menus_[name] = menu;
    }
}

QAction& Menus::add(const MenuPosition& position, const char* name, const MenuEntry& entry) {
    QMenu& menu = *menus_.at(position.menu);
    auto* action = new QAction(entry.text, &menu);
    action->setObjectName(QString::fromLatin1(name));
    action->setShortcuts(entry.shortcuts);
    action->setCheckable(entry.isCheckable);
    action->setToolTip(entry.tip);
    insert(menu, position, *action);
    if (!entry.keptAs.isEmpty()) {
        kept_[entry.keptAs] = action;
    }
    if (entry.refusal) {
        refuseBy(*action, entry.refusal);
    }
    return *action;
}

QMenu& Menus::addMenu(const MenuPosition& position, const char* name, const QString& title) {
    QMenu& menu = *menus_.at(position.menu);
    auto* below = new QMenu(title, &menu);
    below->setObjectName(QString::fromLatin1(name));
    below->setToolTipsVisible(true);
    insert(menu, position, *below->menuAction());
    return *below;
}

void Menus::addEntriesOf(QMenu& menu, const MenuPosition& position) {
    MenuPosition next = position;
    for (QAction* const action : menu.actions()) {
        insert(*menus_.at(position.menu), next, *action);
        ++next.rank;
    }
}

void Menus::insert(QMenu& menu, const MenuPosition& position, QAction& action) {
    const int section = position.section * kSectionOrder;
    QAction* next = nullptr;
    bool hasLine = position.section == 0;
    for (QAction* const other : menu.actions()) {
        hasLine = hasLine || (other->isSeparator() && orderOf(*other) == section);
        if (next == nullptr && orderOf(*other) > section + position.rank) {
            next = other;
        }
    }
    if (!hasLine) {
        menu.insertSeparator(next)->setProperty(kOrder, section);
    }
    action.setProperty(kOrder, section + position.rank);
    menu.insertAction(next, &action);
}

void Menus::refuseBy(QAction& entry, const std::function<QString()>& refusal) {
    refusals_[&entry] = {.reason = refusal, .shown = {}, .tip = entry.toolTip()};
    refresh();
}

QAction& Menus::entry(const char* name) const {
    const QString sought = QString::fromLatin1(name);
    if (auto* const action = parent()->findChild<QAction*>(sought)) {
        return *action;
    }
    return *parent()->findChild<QMenu*>(sought)->menuAction();
}

void Menus::refresh() {
    if (isLocked_) {
        return;
    }
    for (auto& [entry, refusal] : refusals_) {
        const QString reason = refusal.reason();
        if (reason != refusal.shown) {
            refusal.shown = reason;
            entry->setEnabled(reason.isEmpty());
            entry->setToolTip(reason.isEmpty() ? refusal.tip : reason);
        }
    }
}

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
    reset->setToolTip(tr("Restore the default layout of all panels"));
    connect(reset, &QAction::triggered, &layout_, &WindowLayout::reset);
    check();
}

void PanelsMenu::check() {
    for (const PanelSwitch& part : layout_.switches()) {
        menu_.findChild<QAction*>(part.key)->setChecked(part.isShown());
    }
}

ThemeMenu::ThemeMenu(QMenu& menu) : QObject(&menu) {
    auto* group = new QActionGroup(this);
    const auto add = [&](const QString& text, const QString& toolTip, ThemeChoice choice) {
        QAction* entry = menu.addAction(text);
        entry->setToolTip(toolTip);
        entry->setCheckable(true);
        group->addAction(entry);
        connect(entry, &QAction::triggered, this, [choice] { theme::choose(choice); });
        connect(&menu, &QMenu::aboutToShow, entry,
                [entry, choice] { entry->setChecked(theme::choice() == choice); });
    };
    menu.setToolTipsVisible(true);
    add(tr("&Light"), tr("Dark letters on white"), ThemeChoice::Light);
    add(tr("&Dark"), tr("Light letters on black, for a dark laboratory"), ThemeChoice::Dark);
    add(tr("&As the desktop"), tr("Light or dark as the desktop was when the program started"),
        ThemeChoice::Desktop);
}

}  // namespace asperity
