#pragma once

#include <QApplication>

namespace asperity::test {

/// While it lives, a click counts as single soon. Between the clicks of one double click that a
/// test makes no time passes.
class ShortDoubleClicks {
public:
    ShortDoubleClicks() { QApplication::setDoubleClickInterval(50); }
    ~ShortDoubleClicks() { QApplication::setDoubleClickInterval(usual_); }
    ShortDoubleClicks(const ShortDoubleClicks&) = delete;
    ShortDoubleClicks& operator=(const ShortDoubleClicks&) = delete;

private:
    int usual_ = QApplication::doubleClickInterval();  ///< [ms]
};

}  // namespace asperity::test
