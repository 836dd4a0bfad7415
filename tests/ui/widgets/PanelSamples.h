#pragma once

#include "core/haptics/VirtualRun.h"
#include "tests/support/PixelCount.h"

#include <QLabel>
#include <QWidget>

#include <gtest/gtest.h>

namespace asperity::test {

/// A tick at `time` [s] with an estimated force [N] and nothing else.
inline TickSample tickWithForce(double time, const Vector3& force) {
    TickSample sample;
    sample.time = time;
    sample.output.estimate.force = force;
    return sample;
}

inline Snapshot snapshotOf(const TickSample& sample) {
    Snapshot snapshot;
    snapshot.sample = sample;
    return snapshot;
}

/// What a user reads in the label of this name.
inline QString textOf(const QWidget& widget, const char* objectName) {
    const auto* label = widget.findChild<QLabel*>(QString::fromUtf8(objectName));
    if (label == nullptr) {
        ADD_FAILURE() << "no label is called " << objectName;
        return {};
    }
    return label->text();
}

/// Whether any label shows a value that is not a number.
inline bool showsNan(const QWidget& widget) {
    for (const QLabel* label : widget.findChildren<QLabel*>()) {
        const QString text = label->text();
        if (text.contains(QStringLiteral("nan"), Qt::CaseInsensitive) ||
            text.contains(QStringLiteral("inf"), Qt::CaseInsensitive)) {
            return true;
        }
    }
    return false;
}

}  // namespace asperity::test

/// Lets a failed comparison of Qt's strings be read.
// NOLINTNEXTLINE(readability-identifier-naming): the name is GoogleTest's
inline void PrintTo(const QString& text, std::ostream* out) { *out << text.toStdString(); }
