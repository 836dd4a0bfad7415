#pragma once

#include <QVariantMap>

namespace asperity {

class MainWindow;

/// Folds, hides and sizes the panels as `kept` says, and puts pages on top. What cannot be read
/// stays as it is.
void restoreLayout(MainWindow& window, const QVariantMap& kept);
/// Adds how the panels stand now; nothing while one of them is enlarged.
void keepLayout(MainWindow& window, QVariantMap& kept);

}  // namespace asperity
