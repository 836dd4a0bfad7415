#pragma once

#include "app/reports/MeasureReport.h"
#include "app/window/Stage.h"
#include "app/window/measure/MeasuredHeights.h"
#include "app/window/measure/ProfilePlot.h"
#include "core/surface/measure/Profile.h"
#include "ui/view/ShapeTool.h"

#include <QLineF>
#include <QObject>
#include <QVector>
#include <QWidget>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

class QCheckBox;
class QComboBox;
class QLabel;
class QSpinBox;
class QToolButton;

namespace asperity {

class ProfilePage;
class ReadingGrid;

/// A profile line as it is drawn on the whole scan.
struct MarkedLine {
    QLineF line;    ///< world [m]
    int color = 0;  ///< as seriesColor() counts
};

/// A line on the whole scan, among others that a press selects. Shift keeps it horizontal or
/// vertical.
class LineTool : public ShapeTool {
    Q_OBJECT

public:
    using ShapeTool::ShapeTool;

    /// World [m]; of no length: nothing is drawn.
    [[nodiscard]] const QLineF& line() const { return points(); }
    /// Shows another line. @param line of no length: the next drag draws it
    void setLine(const MarkedLine& line);
    /// Shows further lines; a press on one of them emits otherPressed().
    void setOthers(const QVector<MarkedLine>& others);
    /// Marks a position on the line, such as a cursor's. @param shares of its length, 0..1
    void setStops(const QVector<double>& shares);

    void paint(QPainter& painter, const OverviewMap& map) const override;
    void press(const MapPointer& pointer, const OverviewMap& map) override;
    [[nodiscard]] Qt::CursorShape cursor(const MapPointer& pointer,
                                         const OverviewMap& map) const override;
    [[nodiscard]] QString hint() const override;

Q_SIGNALS:
    /// A press is on one of the other lines: it can be made the tool's before the drag begins.
    void otherPressed(int index);

private:
    /// The other line at the pointer where the tool's own is not; -1: none.
    [[nodiscard]] int otherAt(const MapPointer& pointer, const OverviewMap& map) const;
    [[nodiscard]] bool isEmptyShape(const QLineF& points) const override;
    [[nodiscard]] Grip gripAt(const QPointF& pixel, const OverviewMap& map) const override;
    [[nodiscard]] QPointF held(const QPointF& moving, const QPointF& fixed) const override;
    [[nodiscard]] Qt::CursorShape handleCursor(const Grip& grip) const override;

    QVector<double> stops_;
    QVector<MarkedLine> others_;
    int color_ = 0;
};

/// Samples the heights along the lines that are drawn on the whole scan.
class ProfileControl : public Feature {
public:
    /// @param stage has MeasuredHeights
    explicit ProfileControl(Stage& stage);

    [[nodiscard]] ProfilePage& page() { return *page_; }
    /// Another scan is shown: the lines were of the last one.
    void forget();
    /// Samples again.
    void refresh();
    /// Writes all profiles to a table; says in the window what came of it.
    void writeTo(const std::filesystem::path& file);

private:
    void take();
    void beginLine();
    void select(int index);
    void remove();
    void showLines();
    void write(const std::filesystem::path& file);
    [[nodiscard]] int freeColor() const;

    MeasuredHeights& heights_;
    ProfilePage* page_;  ///< the window's
    LineTool line_;      ///< the selected one
    QVector<MarkedLine> lines_;
    int selected_ = -1;  ///< of the lines; -1: the next drag draws another one
    std::vector<NamedProfile> profiles_;
    std::vector<std::string> provenance_;  ///< of the profiles
};

/// The mean profile of this many lines side by side, a pixel apart. Where some of them hold no data
/// the others count. @throw Error as profileOf()
[[nodiscard]] Profile meanProfile(const HeightField& heights, const QLineF& line, int width);

/// Profiles of the scan with what two cursors read of the selected one and, between two marked
/// stretches, a step height.
class ProfilePage : public QWidget {
    Q_OBJECT

public:
    /// A profile with its name and its color, as seriesColor() counts.
    struct Shown {
        NamedProfile profile;
        int color = 0;
    };

    explicit ProfilePage(QWidget* parent = nullptr);

    /// Lists the lines. @param selected -1: none
    void setLines(const QVector<MarkedLine>& lines, int selected);
    /// @param selected of the profiles, -1: none @param zCalibration relative standard deviation of
    /// heights @param words smoothing of the heights, or why there are none
    void setProfiles(const std::vector<Shown>& profiles, int selected, double zCalibration,
                     const QString& words);
    /// Shows whether a drag on the whole scan draws the line.
    void setDrawing(bool drawing);
    /// Returns the number of lines, side by side and a pixel apart, that the heights are means of.
    [[nodiscard]] int width() const;
    /// Returns the positions of the cursors, as shares of the line.
    [[nodiscard]] QVector<double> stops() const;

    /// The choice whether the surface that the tip touches is measured, else the leveled scan.
    [[nodiscard]] QCheckBox& smoothed() { return *smoothed_; }
    [[nodiscard]] ProfilePlot& plot() { return *plot_; }
    [[nodiscard]] const ReadingGrid& readings() const { return *readings_; }

Q_SIGNALS:
    void drawingChosen(bool drawing);
    void addChosen();
    void widthChosen();
    void removeChosen();
    void lineChosen(int index);
    void exportChosen();
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

    std::optional<Profile> profile_;  ///< the selected one
    double zCalibration_ = 0.0;
    ProfilePlot::Cursors cursors_{0.0, 1.0};                        ///< shares of the line
    ProfilePlot::Stretches stretches_{{{0.05, 0.3}, {0.7, 0.95}}};  ///< shares of the line
    ProfilePlot* plot_;
    ReadingGrid* readings_;
    QToolButton* draw_;
    QToolButton* add_;
    QToolButton* remove_;
    QComboBox* list_;
    QSpinBox* width_;
    QCheckBox* step_;
    QCheckBox* smoothed_;
    QToolButton* export_;
    QLabel* hint_;
};

}  // namespace asperity
