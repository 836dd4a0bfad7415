#pragma once

#include <QCoreApplication>
#include <QtTest>

#include <functional>

namespace asperity::test {

/// How long a test waits for what must come; long, since other programs may take the processor
/// [ms].
inline constexpr int kPatience = 20'000;

/// Handles events until something holds. @return whether it does
[[nodiscard]] inline bool eventually(const std::function<bool()>& holds,
                                     int milliseconds = kPatience) {
    return QTest::qWaitFor(holds, milliseconds);
}

/// Handles what is pending and what that posts, such as the layout after a change of size.
inline void handleEvents() {
    QCoreApplication::processEvents();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
}

}  // namespace asperity::test
