#include "ui/panels/WheelGuard.h"

#include <QEvent>
#include <QWidget>

namespace asperity {

namespace {

class WheelGuard : public QObject {
public:
    using QObject::QObject;

    bool eventFilter(QObject* watched, QEvent* event) override {
        const auto* knob = qobject_cast<QWidget*>(watched);
        if (event->type() == QEvent::Wheel && knob != nullptr && !knob->hasFocus()) {
            event->ignore();
            return true;
        }
        return QObject::eventFilter(watched, event);
    }
};

}  // namespace

void guardFromWheel(QWidget& knob) {
    knob.setFocusPolicy(Qt::StrongFocus);
    knob.installEventFilter(new WheelGuard(&knob));
}

}  // namespace asperity
