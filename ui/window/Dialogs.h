#pragma once

#include <QString>

class QWidget;

namespace asperity {

/// The file that a person chooses; empty: none.
[[nodiscard]] QString askForScan(QWidget* window);
[[nodiscard]] QString askForPath(QWidget* window);
[[nodiscard]] QString askForRecording(QWidget* window);
[[nodiscard]] QString askForPicture(QWidget* window);

/// What must be read; the window goes on meanwhile.
void complainIn(QWidget* window, const QString& message);
void explainControls(QWidget* window);
void explainProgram(QWidget* window);

}  // namespace asperity
