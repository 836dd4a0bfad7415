#include "ui/panels/TextBox.h"

#include "ui/panels/LineHistory.h"

namespace asperity {

bool TextBox::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride &&
        isForWindowHistory(static_cast<QKeyEvent&>(*event), *this)) {
        event->ignore();
        return false;
    }
    return QLineEdit::event(event);
}

}  // namespace asperity
