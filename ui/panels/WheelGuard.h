#pragma once

class QWidget;

namespace asperity {

/// Has a knob use the wheel only while it has the focus, and not take the focus by the wheel: a
/// device that turns the wheel on its way elsewhere changes nothing.
void guardFromWheel(QWidget& knob);

}  // namespace asperity
