#pragma once

#include "ui/shell/MessagesPanel.h"
#include "ui/shell/WindowLayout.h"

#include <QString>
#include <QVariantMap>

#include <functional>

class QWidget;

namespace asperity {

class Card;
class Menus;
class WorkInBackground;

/// The window as its features see it: it takes their cards, pages, windows and entries,
/// and a way to speak to the user.
class Host {
public:
    virtual ~Host() = default;
    Host(const Host&) = delete;
    Host& operator=(const Host&) = delete;

    /// Returns the parent of dialogs.
    [[nodiscard]] virtual QWidget& widget() = 0;
    /// Returns the menus: an entry is added with the reason for which it may be off.
    [[nodiscard]] virtual Menus& menus() = 0;
    /// Returns the work in the background, which a line of the window names.
    [[nodiscard]] virtual WorkInBackground& works() = 0;
    /// Returns all that the window said; what it shows nowhere else is added here.
    [[nodiscard]] virtual MessageLog& messages() = 0;

    /// Fills the middle of the window; once, before cards and pages are added.
    virtual void setMiddle(const WindowLayout::Middle& middle) = 0;
    /// Adds a card at the bottom of the column on the right. @param share of its height
    virtual void addCard(Card& card, int share) = 0;
    /// Adds a widget to the bottom line, which a message covers for a while.
    virtual void addStatus(QWidget& status) = 0;
    /// Adds a page to the tabs below the view; it is hidden at first.
    virtual void addTool(QWidget* page, const QString& title) = 0;
    virtual void showTool(QWidget* page) = 0;
    virtual void hideTool(QWidget* page) = 0;
    /// Puts the column of cards on top, where the whole scan is in sight.
    virtual void showCards() = 0;
    /// Adds a page to the tabs right of the view, off while nothing can be changed.
    virtual void addSidePage(QWidget* page, const QString& title) = 0;
    virtual void showSidePage(QWidget* page) = 0;
    /// Adds a panel that is a window of its own: Esc closes it where that is no emergency stop;
    /// numbers half typed do not count then.
    virtual void addWindow(QWidget& panel) = 0;
    /// Shows such a panel, at first beside this window; or hides it.
    virtual void toggle(QWidget& panel) = 0;

    /// Shows a short message for a while.
    virtual void tell(const QString& message, MessageKind kind) = 0;
    void tell(const QString& message) { tell(message, MessageKind::Note); }
    /// Shows a message that must be read; the window stays responsive.
    virtual void complain(const QString& message) = 0;
    /// Names what is shown in the title; empty: nothing is.
    virtual void setTitle(const QString& title) = 0;

    /// Asks the user before the window closes while there is a reason not to.
    /// @param reason a sentence on what is under way and becomes of it; empty: nothing is
    virtual void askBeforeClosing(std::function<QString()> reason) = 0;

    /// Calls a function for each file that is dropped on the window, as a URI.
    virtual void onDrop(std::function<void(const QString& file)> open) = 0;
    /// Enables all that changes the scene, or disables it.
    virtual void allowChanges(bool allowed) = 0;
    /// Sets whether Esc is kept for an emergency stop, whatever window is active; else it closes
    /// what is open.
    virtual void keepEscape(bool isKept) = 0;
    /// Returns whether Esc would close something of the window.
    [[nodiscard]] virtual bool escapeCloses() const = 0;

    /// Adds how the panels are arranged; nothing while one of them fills the window.
    virtual void keep(QVariantMap& kept) = 0;
    /// Folds, hides and sizes the panels as `kept` has them, and puts pages on top. What cannot be
    /// read is as at the start.
    virtual void restore(const QVariantMap& kept) = 0;

protected:
    Host() = default;
};

/// Shows a tool's page with the whole scan in sight, where the tool marks and is drawn.
inline void showScanTool(Host& host, QWidget* page) {
    host.showTool(page);
    host.showCards();
}

}  // namespace asperity
