#pragma once

#include "core/fidelity/SceneNeeds.h"

#include <QTableWidget>

#include <array>
#include <optional>
#include <string>

class QComboBox;

namespace asperity {

/// The terms of the model, one a row: whether it is in, what it is worth and why. The user may
/// overrule each.
class TermTable : public QTableWidget {
    Q_OBJECT

public:
    explicit TermTable(QWidget* parent = nullptr);

    void show(const SceneNeeds& needs, const ModelChoices& choices);

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
    /// Whether the term can be on; where not, the entry says why.
    void setPossible(int row, bool possible);
    void choose(ModelTerm term, int item);
    void setText(int row, int column, const QString& text);
    /// All rows in sight, each as high as its words need at this width.
    void fitHeight();

    std::array<QComboBox*, kModelTerms.size()> choices_;
    bool lawIsGiven_ = false;
};

}  // namespace asperity
