#pragma once

#include "core/surface/measure/Profile.h"
#include "ui/measure/ProfilePlot.h"

#include <QWidget>

#include <optional>

class QCheckBox;
class QLabel;
class QSpinBox;
class QToolButton;

namespace asperity {

class ReadingGrid;

/// A profile of the scan with what two cursors read of it and, between two marked stretches, a
/// step height.
class ProfilePage : public QWidget {
    Q_OBJECT

public:
    explicit ProfilePage(QWidget* parent = nullptr);

    /// None: no line is drawn. @param zCalibration relative standard deviation of heights
    void setProfile(const std::optional<Profile>& profile, double zCalibration = 0.0);
    /// Shows whether a drag on the whole scan draws the line.
    void setDrawing(bool drawing);
    /// How many lines side by side, a pixel apart, the heights are means of.
    [[nodiscard]] int width() const;
    /// Where the cursors are, as shares of the line.
    [[nodiscard]] QVector<double> stops() const;

    [[nodiscard]] ProfilePlot& plot() { return *plot_; }
    [[nodiscard]] const ReadingGrid& readings() const { return *readings_; }

Q_SIGNALS:
    void drawingChosen(bool drawing);
    void widthChosen();
    void removeChosen();
    void stopsChanged();

private:
    void buildReadings();
    [[nodiscard]] QWidget* buildBar();
    void moveCursor(int index, double distance);
    void moveStretch(int index, int edge, double distance);
    [[nodiscard]] ProfilePlot::Stretches stretches() const;
    void show();
    void showCursors();
    void showStep();

    std::optional<Profile> profile_;
    double zCalibration_ = 0.0;
    ProfilePlot::Cursors cursors_{0.0, 1.0};                        ///< shares of the line
    ProfilePlot::Stretches stretches_{{{0.05, 0.3}, {0.7, 0.95}}};  ///< shares of the line
    ProfilePlot* plot_;
    ReadingGrid* readings_;
    QToolButton* draw_;
    QToolButton* remove_;
    QSpinBox* width_;
    QCheckBox* step_;
    QLabel* hint_;
};

}  // namespace asperity
