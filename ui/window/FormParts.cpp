#include "ui/window/FormParts.h"

#include <QHBoxLayout>

namespace asperity {

namespace {

constexpr int kFormGap = 8;  // [px]

}  // namespace

QSpinBox* newNumber(const char* name, const QString& unit, int low, int high, const QString& tip) {
    auto* box = named(new QSpinBox, name, tip);
    box->setRange(low, high);
    box->setSuffix(unit);
    box->setKeyboardTracking(false);  // a half-typed number is no size
    guardFromWheel(*box);
    return box;
}

QComboBox* newList(const char* name, const QString& tip) {
    auto* list = named(new QComboBox, name, tip);
    guardFromWheel(*list);
    return list;
}

QPushButton* newButton(const QString& text, const char* name, const QString& tip) {
    auto* button = named(new QPushButton(text), name, tip);
    button->setAutoDefault(false);  // that is for what the dialog is for
    return button;
}

QWidget* newRow(std::initializer_list<QWidget*> parts) {
    auto* row = new QWidget;
    auto* line = new QHBoxLayout(row);
    line->setContentsMargins(0, 0, 0, 0);
    line->setSpacing(kFormGap);
    for (QWidget* const part : parts) {
        line->addWidget(part, qobject_cast<QPushButton*>(part) == nullptr ? 1 : 0);
    }
    return row;
}

}  // namespace asperity
