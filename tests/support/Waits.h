#pragma once

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QtTest>

#include <algorithm>
#include <functional>

namespace asperity::test {

/// How long a test waits for what must come [ms].
inline constexpr int kPatience = 20'000;

/// Handles events until something holds. Time counts while this program has a processor: what a
/// turn of the loop takes longer than on a machine of its own, others have taken.
/// @return whether it does
[[nodiscard]] inline bool eventually(const std::function<bool()>& holds,
                                     int milliseconds = kPatience) {
    constexpr qint64 kLongestTurn = 50;  // with a frame of the window in it [ms]
    QElapsedTimer turn;
    for (qint64 waited = 0; !holds(); waited += std::min(turn.elapsed(), kLongestTurn)) {
        if (waited >= milliseconds) {
            return false;
        }
        turn.start();
        QTest::qWait(10);
    }
    return true;
}

/// Handles what is pending and what that posts, such as the layout after a change of size.
inline void handleEvents() {
    QCoreApplication::processEvents();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
}

}  // namespace asperity::test
