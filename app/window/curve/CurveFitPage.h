#pragma once

#include "app/curves/FitFiles.h"
#include "ui/plot/ForceDistancePlot.h"

#include <QWidget>

#include <optional>

class QComboBox;
class QLabel;
class QPushButton;
class QSpinBox;
class QTableWidget;

namespace asperity {

class CurveFitForm;

/// A file of measured curves as it is opened.
struct OpenedCurves {
    QString name;
    std::size_t count = 0;  ///< 0: no file
    CurveGrid grid;
};

/// Room for measured force curves: one of a file, each step up to its fit, the simulation over it,
/// and what was found.
class CurveFitPage : public QWidget {
    Q_OBJECT

public:
    explicit CurveFitPage(QWidget* parent = nullptr);

    void setFile(const OpenedCurves& file);
    /// Shows a curve with its fit; until then, or the next setWorking(), nothing can be saved.
    void setCurve(const FittedCurve& curve);
    /// Another curve is on its way.
    void setWorking();
    /// No curve is shown, for this reason.
    void setComplaint(const QString& reason);

    [[nodiscard]] CurveFitForm& form() { return *form_; }
    [[nodiscard]] std::size_t index() const;
    [[nodiscard]] const ForceDistancePlot& plot() const { return *plot_; }

Q_SIGNALS:
    void openChosen();
    void columnsChosen();
    /// Another curve of the file, or another fit of it, is wanted.
    void changed();
    void saveChosen();
    void sceneChosen();

private:
    enum class Step { Stored, Corrected, Separation, Residual };

    void addParts();
    [[nodiscard]] QWidget* newFileRow();
    [[nodiscard]] QWidget* newButtonRow();
    void connectParts();
    void draw();
    void fillValues();
    void fillSteps();
    void showPlace();

    std::optional<FittedCurve> curve_;
    CurveGrid grid_;
    QPushButton* open_;
    QPushButton* columns_;
    QLabel* file_;
    QSpinBox* index_;
    QLabel* place_;  ///< of the curve in the file
    CurveFitForm* form_;
    QComboBox* step_;
    ForceDistancePlot* plot_;
    QLabel* verdict_;
    QLabel* reasons_;
    QTableWidget* values_;
    QTableWidget* steps_;
    QPushButton* save_;
    QPushButton* scene_;
};

}  // namespace asperity
