#pragma once

#include "app/window/device/LinePlot.h"
#include "core/haptics/DevicePath.h"
#include "core/haptics/SetpointApproach.h"

#include <QString>
#include <QWidget>

class QComboBox;
class QLabel;
class QPushButton;
class QSpinBox;

namespace asperity {

class GainSpinBox;
class NumberBox;

/// Path as it is asked for.
struct PathRequest {
    PlannedPath kind = PlannedPath::Slide;
    bool isFile = false;     ///< instead: the path of a file
    bool holdsForce = true;  ///< else the tip stays at its height, or at that of the file
    double load = 5e-9;      ///< held, or at which an approach ends [N]
    LinesPlan lines;         ///< repeats are its lines, also of an approach or a file
};

/// What a path is to be, whether it runs, and what the tip met on its last line.
class PathPage : public QWidget {
    Q_OBJECT

public:
    explicit PathPage(QWidget* parent = nullptr);

    [[nodiscard]] PathRequest request() const;
    void choose(PlannedPath kind);
    /// A path of a file is chosen. @param name shown
    void chooseFile(const QString& name);
    /// The path of a file can no longer be chosen.
    void forgetFile();
    /// Another scan: length and speed that suit it.
    /// @param width, pixel of the scan [m] @param tipRadius [m]
    void setScan(double width, double pixel, double tipRadius);
    /// Sets the setpoint of the scene [N], as long as no other load is typed.
    void setSetpoint(double force);
    /// Sets whether a path runs. @param progress in words
    void setRunning(bool running, const QString& progress);
    /// @param why no path can start, for the button's tool tip; empty: it can
    void setRefusal(const QString& why);

    [[nodiscard]] LinePlot& heights() { return *heights_; }
    [[nodiscard]] LinePlot& forces() { return *forces_; }

Q_SIGNALS:
    void changed();  ///< request() is another one
    void hidden();   ///< the user looks at something else
    void gainChanged(double gain);
    void startChosen();
    void stopChosen();
    void fileRequested();

protected:
    void hideEvent(QHideEvent* event) override;

private:
    void addParts();
    void connectParts();
    void showUse();
    void suggestLoad();

    double setpoint_ = 5e-9;  ///< of the scene [N]
    bool hasOwnLoad_ = false;
    int holdBefore_ = 0;  ///< choice for paths that are no file's
    QComboBox* kind_;
    QComboBox* hold_;
    NumberBox* load_;       ///< [nN]
    NumberBox* length_;     ///< [nm]
    NumberBox* direction_;  ///< [°]
    NumberBox* speed_;      ///< [nm/s]
    QSpinBox* lines_;
    GainSpinBox* gain_;
    QPushButton* file_;
    QPushButton* start_;
    QPushButton* stop_;
    QLabel* progress_;
    LinePlot* heights_;
    LinePlot* forces_;
};

}  // namespace asperity
