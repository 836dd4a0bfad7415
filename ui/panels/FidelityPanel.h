#pragma once

#include "core/studies/TradeOffStudy.h"
#include "ui/panels/TermTable.h"

#include <QWidget>

#include <optional>

class QLabel;
class QPushButton;

namespace asperity {

class NumberBox;
class TradeOffChart;

/// Speed against accuracy, a window of its own: the terms of the model with what each is worth, and
/// the measured ways for a tick. Setters show a state and emit nothing; signals tell what the
/// user changed.
class FidelityPanel : public QWidget {
    Q_OBJECT

public:
    explicit FidelityPanel(QWidget* parent = nullptr);

    void showModel(const SceneNeeds& needs, const ModelChoices& choices);
    /// None: the chart is empty.
    void showTradeOff(const std::optional<TradeOff>& study);
    [[nodiscard]] const std::optional<TradeOff>& tradeOff() const { return study_; }
    /// Why no study can be made of this scene; empty: one can.
    void refuseMeasuring(const QString& reason);
    /// How far a study is, 0..1; none: there is none under way.
    void setMeasuring(std::optional<double> fraction);

Q_SIGNALS:
    /// @param on none: as the scene requires
    void termChosen(asperity::ModelTerm term, std::optional<bool> on);
    void toleranceChosen(double share);  ///< of forces and of indentations
    void optionsPicked(const asperity::ForceModelOptions& options);
    void automaticRequested();  ///< nothing shall be overruled, with the tolerance by default
    void measureRequested();
    void stopRequested();  ///< of the study under way

private:
    [[nodiscard]] QWidget* termCard();
    [[nodiscard]] QWidget* chartCard();
    void connectInputs();
    void showCurrent();
    [[nodiscard]] QString keyText() const;

    TermTable* terms_;
    QLabel* summary_;
    NumberBox* tolerance_;
    QPushButton* automatic_;
    TradeOffChart* chart_;
    QLabel* key_;
    QPushButton* measure_;
    std::optional<TradeOff> study_;
    ForceModelOptions now_;  ///< of ticks at present
    std::optional<double> measuring_;
};

}  // namespace asperity
