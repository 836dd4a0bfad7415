#pragma once

#include "app/window/Stage.h"
#include "app/window/measure/ProfilePlot.h"
#include "core/surface/measure/Profile.h"
#include "ui/view/ShapeTool.h"

#include <QLineF>
#include <QObject>
#include <QVector>
#include <QWidget>

#include <optional>

class QCheckBox;
class QLabel;
class QSpinBox;
class QToolButton;

namespace asperity {

class ProfilePage;
class ReadingGrid;

/// A line on the whole scan. Shift keeps it horizontal or vertical.
class LineTool : public ShapeTool {
    Q_OBJECT

public:
    using ShapeTool::ShapeTool;

    /// World [m]; of no length: nothing is drawn.
    [[nodiscard]] const QLineF& line() const { return points(); }
    /// One that was not drawn here.
    void setLine(const QLineF& line) { setPoints(line); }
    /// Marks a position on the line, such as a cursor's. @param shares of its length, 0..1
    void setStops(const QVector<double>& shares);

    void paint(QPainter& painter, const OverviewMap& map) const override;
    [[nodiscard]] QString hint() const override;

private:
    [[nodiscard]] bool isEmptyShape(const QLineF& points) const override;
    [[nodiscard]] Grip gripAt(const QPointF& pixel, const OverviewMap& map) const override;
    [[nodiscard]] QPointF held(const QPointF& moving, const QPointF& fixed) const override;
    [[nodiscard]] Qt::CursorShape handleCursor(const Grip& grip) const override;

    QVector<double> stops_;
};

/// Samples the surface at rest along the line that is drawn on the whole scan.
class ProfileControl : public Feature {
public:
    explicit ProfileControl(Stage& stage);

    [[nodiscard]] ProfilePage& page() { return *page_; }
    /// Another scan is shown: the line was of the last one.
    void forget();
    /// Samples again.
    void refresh();

private:
    ProfilePage* page_;  ///< the window's
    LineTool line_;
};

/// The mean profile of this many lines side by side, a pixel apart. Where some of them hold no data
/// the others count. @throw Error as profileOf()
[[nodiscard]] Profile meanProfile(const BSplineSurface& surface, const QLineF& line, int width);

/// A profile of the scan with what two cursors read of it and, between two marked stretches, a
/// step height.
class ProfilePage : public QWidget {
    Q_OBJECT

public:
    explicit ProfilePage(QWidget* parent = nullptr);

    /// None: no line is drawn. @param zCalibration relative standard deviation of heights
    /// @param smoothing of the heights, in words
    void setProfile(const std::optional<Profile>& profile, double zCalibration = 0.0,
                    const QString& smoothing = {});
    /// Shows whether a drag on the whole scan draws the line.
    void setDrawing(bool drawing);
    /// Returns the number of lines, side by side and a pixel apart, that the heights are means of.
    [[nodiscard]] int width() const;
    /// Returns the positions of the cursors, as shares of the line.
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
    QString smoothing_;
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
