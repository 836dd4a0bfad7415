#pragma once

#include <QObject>

namespace asperity {

class MainWindow;

/// Shows what the program is made of.
class HelpControl : public QObject {
    Q_OBJECT

public:
    /// @param window outlives this
    explicit HelpControl(MainWindow& window);

private:
    void showAbout();

    MainWindow& window_;
};

}  // namespace asperity
