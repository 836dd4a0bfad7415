#pragma once

class QSettings;

namespace asperity {

class MainWindow;

/// Has the views look as `settings` remember them: colors, ranges, what is drawn, the second view.
/// What cannot be read stays as it is.
void restoreViews(MainWindow& window, const QSettings& settings);
/// Writes how the views look now. Pinned ranges are of a scan, and are not kept.
void saveViews(MainWindow& window, QSettings& settings);

}  // namespace asperity
