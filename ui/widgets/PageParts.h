#pragma once

#include "ui/widgets/NumberBox.h"

#include <QComboBox>
#include <QMap>
#include <QPushButton>
#include <QSpinBox>
#include <QString>
#include <QWidget>
#include <Qt>

#include <initializer_list>

class QTableView;
class QToolButton;
class QGridLayout;
class QLabel;

// Parts that pages and dialogs share.
namespace asperity {

/// A button with a word; a click leaves the keys to the view.
[[nodiscard]] QToolButton* pageButton(const QString& text, const char* objectName,
                                      const QString& toolTip, QWidget* parent);

/// A push button that Return does not press unless it has the focus.
[[nodiscard]] QPushButton* pushButton(const QString& text, const char* objectName,
                                      const QString& toolTip, Qt::FocusPolicy focus);

/// Rows are selected whole; columns are as wide as their contents.
void stylePageTable(QTableView& table, const char* objectName, const QString& toolTip);

/// Names and values below one another; a value can be selected and copied.
class ReadingGrid : public QWidget {
    Q_OBJECT

public:
    /// @param rows of names and values; what is more begins another column
    explicit ReadingGrid(QWidget* parent = nullptr, int rows = kRows);

    /// @param objectName of the value's label
    void add(const char* objectName, const QString& name, const QString& meaning);
    /// Shows a dash for an empty text.
    void set(const char* objectName, const QString& text);
    [[nodiscard]] QString text(const char* objectName) const;

private:
    static constexpr int kRows = 100;
    QGridLayout* grid_;
    int rows_;
    QMap<QString, QLabel*> values_;
};

/// A widget by its name, for what looks for it, and with what it is for.
template <typename Widget>
Widget* named(Widget* widget, const char* name, const QString& tip) {
    widget->setObjectName(QString::fromLatin1(name));
    widget->setToolTip(tip);
    return widget;
}

/// A whole number with its unit.
[[nodiscard]] QSpinBox* newNumber(const char* name, const QString& unit, int low, int high,
                                  const QString& tip);

/// Choices to drop down.
[[nodiscard]] QComboBox* newList(const char* name, const QString& tip);

/// A button that Return does not press.
[[nodiscard]] QPushButton* newButton(const QString& text, const char* name, const QString& tip);

/// Widgets beside one another; buttons take the room of their text alone.
[[nodiscard]] QWidget* newRow(std::initializer_list<QWidget*> parts);

}  // namespace asperity
