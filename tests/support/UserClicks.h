#pragma once

#include <QPoint>
#include <QStringList>

#include <functional>

class QMainWindow;
class QToolButton;
class QWidget;

namespace asperity::test {

/// Clicks and types as a user does, by events at visible widgets, and counts it.
class UserClicks {
public:
    /// At its middle. Fails the test where it cannot be seen or does not work.
    void click(QWidget& widget);
    void click(QWidget& widget, const QPoint& place);
    void doubleClick(QWidget& widget, const QPoint& place);
    /// Opens a menu and chooses an entry by the beginnings of their texts: {"File", "Open"}.
    void choose(const QMainWindow& window, const QStringList& path);
    /// Opens the menu of a button and chooses an entry by the beginning of its text.
    void choose(QToolButton& button, const QString& text);
    /// Types into what has the focus; one count for all of it.
    void type(QWidget& widget, const QString& text);

    [[nodiscard]] int clicks() const { return clicks_; }
    [[nodiscard]] int typed() const { return typed_; }

private:
    int clicks_ = 0;
    int typed_ = 0;
};

/// Does something as soon as it can be done, also within the event loop of a menu or a dialog.
/// Fails the test where that takes more than 10 s.
void onceReady(std::function<bool()> ready, std::function<void()> todo);

}  // namespace asperity::test
