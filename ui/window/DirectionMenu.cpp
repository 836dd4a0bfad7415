#include "ui/window/DirectionMenu.h"

#include <QAction>
#include <QKeySequence>
#include <QMenu>

namespace asperity {

DirectionMenu::DirectionMenu(QMenu& menu, Keys keys) : QObject(&menu) {
    menu.setToolTipsVisible(true);
    const auto add = [&](ViewDirection side, const QString& text, const QString& key,
                         const QString& toolTip) {
        QAction* action = menu.addAction(text);
        if (keys == Keys::Digits) {
            action->setShortcut(QKeySequence(key));
        }
        action->setToolTip(toolTip);
        connect(action, &QAction::triggered, this, [this, side] { Q_EMIT sideChosen(side); });
    };
    add(ViewDirection::Front, tr("&Front"), QStringLiteral("1"),
        tr("From small y along the ground: x to the right, z up"));
    add(ViewDirection::Back, tr("&Back"), QStringLiteral("Ctrl+1"),
        tr("From large y along the ground: x to the left, z up"));
    add(ViewDirection::Right, tr("&Right"), QStringLiteral("3"),
        tr("From large x along the ground: y to the right, z up"));
    add(ViewDirection::Left, tr("&Left"), QStringLiteral("Ctrl+3"),
        tr("From small x along the ground: y to the left, z up"));
    add(ViewDirection::Top, tr("&Top"), QStringLiteral("7"),
        tr("From above: x to the right, y up"));
    add(ViewDirection::Bottom, tr("B&ottom"), QStringLiteral("Ctrl+7"),
        tr("From below, through the block: x to the right, y down"));
    menu.addSeparator();
    perspective_ = menu.addAction(tr("&Perspective"));
    perspective_->setCheckable(true);
    if (keys == Keys::Digits) {
        perspective_->setShortcut(QKeySequence(QStringLiteral("5")));
    }
    perspective_->setToolTip(
        tr("Near things look larger; without, lengths across the view are to scale"));
    connect(perspective_, &QAction::triggered, this, &DirectionMenu::perspectiveChosen);
}

void DirectionMenu::setPerspective(bool perspective) { perspective_->setChecked(perspective); }

}  // namespace asperity
