#pragma once

#include <QString>
#include <Qt>

class QPushButton;
class QTableView;
class QToolButton;
class QWidget;

// What the pages of measuring tools have in common.

namespace asperity {

/// A button with a word; a click leaves the keys to the view.
[[nodiscard]] QToolButton* pageButton(const QString& text, const char* objectName,
                                      const QString& toolTip, QWidget* parent);

/// A push button that Return does not press unless it has the focus.
[[nodiscard]] QPushButton* pushButton(const QString& text, const char* objectName,
                                      const QString& toolTip, Qt::FocusPolicy focus);

/// Rows are selected whole; columns are as wide as their contents.
void stylePageTable(QTableView& table, const char* objectName, const QString& toolTip);

}  // namespace asperity
