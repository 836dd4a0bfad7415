#pragma once

#include <QString>
#include <QStringList>

class QWidget;

namespace asperity {

/// The file that a user chooses; empty: none.
/// @param patterns of the scans that are shown first, beside scenes: "*.gwy"
[[nodiscard]] QString askForScan(QWidget* window, const QStringList& patterns);
[[nodiscard]] QString askForPath(QWidget* window);
[[nodiscard]] QString askForRecording(QWidget* window);
[[nodiscard]] QString askForPicture(QWidget* window);

/// What must be read; the window goes on meanwhile.
void complainIn(QWidget* window, const QString& message);
void explainControls(QWidget* window);
void explainProgram(QWidget* window);

}  // namespace asperity
