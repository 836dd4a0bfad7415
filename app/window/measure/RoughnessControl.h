#pragma once

#include "app/window/LongWork.h"
#include "app/window/Stage.h"
#include "app/window/measure/MeasuredHeights.h"
#include "app/window/measure/RoughnessPlot.h"
#include "core/surface/measure/PowerSpectrum.h"
#include "core/surface/measure/Roughness.h"
#include "core/surface/measure/Texture.h"
#include "ui/view/ShapeTool.h"

#include <QWidget>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>

class QCheckBox;
class QComboBox;
class QLabel;
class QStackedWidget;
class QToolButton;

namespace asperity {

class ReadingGrid;

/// The roughness of a scan or of a rectangle of it, and what it is of.
class RoughnessPage : public QWidget {
    Q_OBJECT

public:
    /// Area that the roughness is of, and how its heights were prepared.
    struct Subject {
        double width = 0.0;        ///< [m]
        double height = 0.0;       ///< [m]
        PixelRectangle pixels;     ///< with and without data
        bool isRectangle = false;  ///< of the scan; else all of it
        QString leveling;          ///< in words
        QString smoothing;         ///< in words
        QString calibration;       ///< its deviations in words; empty: not given
    };
    /// The numbers of ISO 25178-2, and the curves.
    struct Numbers {
        Roughness roughness;
        Texture texture;
        HeightHistogram histogram;
        PowerSpectrum spectrum;
    };
    /// Tables that can be exported.
    enum class Table : std::uint8_t { Numbers, Histogram, Spectrum };

    explicit RoughnessPage(QWidget* parent = nullptr);

    void setResult(const Subject& subject, const Numbers& numbers);
    /// Nothing to show. @param reason in words
    void clear(const QString& reason);
    /// It is being computed. @param share that is done, 0..1
    void setProgress(double share);
    /// Shows whether a drag on the whole scan draws the rectangle.
    void setDrawing(bool drawing);
    void setRectangle(bool drawn);

    /// The choice whether the surface that the tip touches is measured, else the leveled scan.
    [[nodiscard]] QCheckBox& smoothed() { return *smoothed_; }
    [[nodiscard]] const ReadingGrid& readings() const { return *readings_; }
    [[nodiscard]] QString subject() const;
    [[nodiscard]] const RoughnessPlot& histogram() const { return *histogram_; }
    [[nodiscard]] const RoughnessPlot& spectrum() const { return *spectrum_; }

Q_SIGNALS:
    void drawingChosen(bool drawing);
    void wholeChosen();
    void exportChosen(asperity::RoughnessPage::Table table);
    /// The user looks at it now.
    void shown();

protected:
    void showEvent(QShowEvent* event) override;

private:
    void addReadings();
    void addExports();
    [[nodiscard]] QWidget* buildBar();
    void showCurves(const Numbers& numbers);

    ReadingGrid* readings_;
    QToolButton* draw_;
    QToolButton* whole_;
    QCheckBox* smoothed_;
    QComboBox* kind_;
    QToolButton* export_;
    QLabel* state_;
    QLabel* subject_;
    QStackedWidget* plots_;
    RoughnessPlot* histogram_;
    RoughnessPlot* spectrum_;
};

/// Computes the roughness of the scan, or of the rectangle that is drawn on it, in the background,
/// while somebody looks at it.
class RoughnessControl : public Feature {
public:
    /// @param stage has MeasuredHeights
    explicit RoughnessControl(Stage& stage);

    [[nodiscard]] RoughnessPage& page() { return *page_; }
    /// Another scan is shown: the rectangle was of the last one.
    void forget();
    /// The surface is another one, or there is none.
    void refresh();
    /// Writes a table of what the page shows; says in the window what came of it.
    void writeTo(const std::filesystem::path& file, RoughnessPage::Table table);

private:
    struct Result {
        std::shared_ptr<const MeasuredScan> scan;
        RoughnessPage::Subject subject;
        RoughnessPage::Numbers numbers;
    };

    /// @param rectangle empty: all of the scan
    [[nodiscard]] static Result measure(std::shared_ptr<const MeasuredScan> scan,
                                        const QRectF& rectangle, Progress& progress);
    void show(const Result& result);
    void clear(const QString& reason);
    void askForFile(RoughnessPage::Table table);
    static void write(const std::filesystem::path& file, RoughnessPage::Table table,
                      const Result& result);

    MeasuredHeights& heights_;
    RoughnessPage* page_;  ///< the window's
    RectangleTool rectangle_;
    bool due_ = true;               ///< what the page shows is of another surface or rectangle
    std::optional<Result> result_;  ///< that the page shows
    BackgroundWork<Result> work_;
};

}  // namespace asperity
