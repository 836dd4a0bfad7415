#include "ui/window/ThemeMenu.h"

#include "ui/Theme.h"

#include <QAction>
#include <QActionGroup>
#include <QMenu>

namespace asperity {

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
