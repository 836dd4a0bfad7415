#pragma once

#include "core/fidelity/RequiredTerms.h"
#include "core/studies/TradeOffStudy.h"

#include <QTableWidget>
#include <QWidget>

#include <array>
#include <optional>
#include <string>

class QLabel;
class QPushButton;
class QComboBox;

namespace asperity {

class NumberBox;
class TradeOffChart;

/// The terms of the model, one a row: whether it is in, what it is worth and why. The user may
/// overrule each.
class TermTable : public QTableWidget {
    Q_OBJECT

public:
    explicit TermTable(QWidget* parent = nullptr);

    void show(const RequiredTerms& needs, const ModelChoices& choices);

Q_SIGNALS:
    /// @param on none: as the scene requires
    void termChosen(asperity::ModelTerm term, std::optional<bool> on);

protected:
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    void addRow(int row);
    void showNeed(int row, const TermNeed& need, const std::string& reason);
    void colorNow(int row);
    void showChoice(int row, const ModelChoices& choices);
    /// Sets whether the term can be on; where not, the entry says why.
    void setPossible(int row, bool possible);
    void choose(ModelTerm term, int item);
    void setText(int row, int column, const QString& text);
    /// All rows in sight, each as high as its words need at this width.
    void fitHeight();

    std::array<QComboBox*, kModelTerms.size()> choices_;
    bool lawIsGiven_ = false;
};

/// Speed against accuracy, a window of its own: one sentence on the model in use, and on request
/// its terms with what each is worth, and the measured ways for a tick. Setters show a state and
/// emit nothing; signals tell what the user changed.
class FidelityPanel : public QWidget {
    Q_OBJECT

public:
    explicit FidelityPanel(QWidget* parent = nullptr);

    /// @param period from one tick to the next [s]
    void showModel(const RequiredTerms& needs, const ModelChoices& choices, double period);
    /// None: the chart is empty.
    void showTradeOff(const std::optional<TradeOff>& study);
    [[nodiscard]] const std::optional<TradeOff>& tradeOff() const { return study_; }
    /// Shows why no study can be made of this scene; empty: one can.
    void refuseMeasuring(const QString& reason);
    /// Shows the progress of a study, 0..1; none: no study is under way.
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
    [[nodiscard]] QWidget* briefLine();
    [[nodiscard]] QWidget* termCard();
    [[nodiscard]] QWidget* chartCard();
    void connectInputs();
    void showCurrent();
    [[nodiscard]] QString keyText() const;

    QLabel* brief_;         ///< one sentence
    QPushButton* details_;  ///< shows all the rest
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
