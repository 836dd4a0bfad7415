#include "ui/help/ActionHelp.h"

#include <QAction>
#include <QMenu>
#include <QMenuBar>
#include <QStringList>

#include <functional>

namespace asperity {

namespace {

/// Calls `visit` with each entry below an action and the texts of the menus that lead to it.
void visitEntries(QAction& action, const QStringList& path,
                  const std::function<void(QAction&, const QStringList&)>& visit) {
    if (action.isSeparator()) {
        return;
    }
    if (action.menu() == nullptr) {
        visit(action, path);
        return;
    }
    for (QAction* const entry : action.menu()->actions()) {
        visitEntries(*entry, path + QStringList(plainText(action.text())), visit);
    }
}

QString keysOf(const QAction& action) {
    QStringList keys;
    for (const QKeySequence& shortcut : action.shortcuts()) {
        keys << shortcut.toString(QKeySequence::NativeText);
    }
    return keys.join(QStringLiteral(", "));
}

}  // namespace

QString plainText(const QString& text) {
    const QString ampersand(QChar(0));  // what "&&" stands for
    return QString(text)
        .replace(QStringLiteral("&&"), ampersand)
        .remove(QLatin1Char('&'))
        .replace(ampersand, QStringLiteral("&"));
}

std::vector<MenuHelp> helpOf(const QMenuBar& bar) {
    std::vector<MenuHelp> menus;
    for (QAction* const menu : bar.actions()) {
        MenuHelp help{plainText(menu->text()), {}};
        visitEntries(*menu, {}, [&help](const QAction& entry, const QStringList& path) {
            if (!entry.shortcut().isEmpty()) {
                const QString text = plainText(entry.text());
                const QString tip = entry.toolTip();
                const QStringList below = path.mid(1) + QStringList(text);
                // Qt makes a tip of the text where none is set.
                const bool isSame = tip.startsWith(QString(text).remove(QStringLiteral("…"))) &&
                                    tip.size() <= text.size();
                help.entries.push_back(
                    {keysOf(entry), below.join(QStringLiteral(" › ")), isSame ? QString() : tip});
            }
        });
        if (!help.entries.empty()) {
            menus.push_back(help);
        }
    }
    return menus;
}

std::vector<QAction*> entriesOf(const QMenuBar& bar) {
    std::vector<QAction*> entries;
    for (QAction* const menu : bar.actions()) {
        visitEntries(*menu, {},
                     [&entries](QAction& entry, const QStringList&) { entries.push_back(&entry); });
    }
    return entries;
}

}  // namespace asperity
