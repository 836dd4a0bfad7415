#pragma once

#include <QObject>

namespace asperity {

/// Tells that the theme's colors are others. Panels use theme::follow().
class ThemeChange : public QObject {
    Q_OBJECT

Q_SIGNALS:
    void happened();
};

}  // namespace asperity
