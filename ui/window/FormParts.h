#pragma once

#include "ui/panels/WheelGuard.h"

#include <QComboBox>
#include <QPushButton>
#include <QSpinBox>
#include <QString>

#include <initializer_list>

namespace asperity {

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
