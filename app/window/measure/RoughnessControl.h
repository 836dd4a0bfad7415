#pragma once

#include "app/window/LongWork.h"
#include "app/window/Stage.h"
#include "core/surface/measure/Roughness.h"
#include "core/surface/measure/Texture.h"
#include "ui/view/ShapeTool.h"

#include <QWidget>

#include <optional>

class QCheckBox;
class QLabel;
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
        std::size_t pixels = 0;    ///< in the area, with and without data
        bool isRectangle = false;  ///< of the scan; else all of it
        QString leveling;          ///< in words
        QString smoothing;         ///< in words
    };
    /// The numbers of ISO 25178-2.
    struct Numbers {
        Roughness roughness;
        Texture texture;
    };

    explicit RoughnessPage(QWidget* parent = nullptr);

    void setResult(const Subject& subject, const Numbers& numbers);
    /// Nothing to show. @param reason in words; empty: there is no scan
    void clear(const QString& reason);
    /// It is being computed. @param share that is done, 0..1
    void setProgress(double share);
    /// Shows whether a drag on the whole scan draws the rectangle.
    void setDrawing(bool drawing);
    void setRectangle(bool drawn);
    /// Returns whether the surface that the tip meets is to be measured, else the leveled scan.
    [[nodiscard]] bool isSmoothed() const;

    [[nodiscard]] const ReadingGrid& readings() const { return *readings_; }
    [[nodiscard]] QString subject() const;

Q_SIGNALS:
    void drawingChosen(bool drawing);
    void wholeChosen();
    void smoothedChosen();
    /// The user looks at it now.
    void shown();

protected:
    void showEvent(QShowEvent* event) override;

private:
    void addReadings();

    ReadingGrid* readings_;
    QToolButton* draw_;
    QToolButton* whole_;
    QCheckBox* smoothed_;
    QLabel* state_;
    QLabel* subject_;
};

/// Returns the smoothing that a scene gives its scan, in words.
[[nodiscard]] QString smoothingInWords(const SampleDescription& sample);

/// Computes the roughness of the scan, or of the rectangle that is drawn on it, in the background,
/// while somebody looks at it. It is that of the leveled heights before smoothing, unless the page
/// asks for the smoothed ones.
class RoughnessControl : public Feature {
public:
    explicit RoughnessControl(Stage& stage);

    [[nodiscard]] RoughnessPage& page() { return *page_; }
    /// Another scan is shown: the rectangle was of the last one.
    void forget();
    /// The surface is another one, or there is none.
    void refresh();

private:
    struct Result {
        RoughnessPage::Subject subject;
        RoughnessPage::Numbers numbers;
    };

    /// @param rectangle empty: all of the scan
    /// @param smoothed of the surface that the tip meets; else of the leveled scan, which is read
    ///        from its file where smoothing changed it. @throw InputError
    [[nodiscard]] static Result compute(const Scene& scene, const QRectF& rectangle, bool smoothed,
                                        Progress& progress);
    [[nodiscard]] static Result measure(const HeightRows& rows, const QRectF& rectangle,
                                        Progress& progress);

    RoughnessPage* page_;  ///< the window's
    RectangleTool rectangle_;
    bool due_ = true;  ///< what the page shows is of another surface or rectangle
    BackgroundWork<Result> work_;
};

}  // namespace asperity
