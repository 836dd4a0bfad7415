#pragma once

#include <QLabel>

namespace asperity {

/// Says below number boxes why the last number was refused, until another is typed.
class RefusalLine : public QLabel {
public:
    /// @param boxes holds the number boxes, all there already
    explicit RefusalLine(QWidget* boxes);

protected:
    void hideEvent(QHideEvent* /*event*/) override { clear(); }
};

}  // namespace asperity
