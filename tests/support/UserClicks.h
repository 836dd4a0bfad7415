#pragma once

#include <QPoint>
#include <QStringList>

class QMainWindow;
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
    /// Types into what has the focus; one count for all of it.
    void type(QWidget& widget, const QString& text);

    [[nodiscard]] int clicks() const { return clicks_; }
    [[nodiscard]] int typed() const { return typed_; }

private:
    int clicks_ = 0;
    int typed_ = 0;
};

}  // namespace asperity::test
