#pragma once

#include "core/SiFormat.h"
#include "core/haptics/cycle/CurveBranch.h"
#include "core/uncertainty/CycleBudgets.h"
#include "ui/shell/RunPanel.h"

#include <QString>
#include <QWidget>

#include <functional>
#include <optional>
#include <utility>
#include <vector>

class QPainter;

namespace asperity {

/// A cycle with the material that it was made on.
struct CycleRow {
    QString material;
    ContactCycle cycle;
    bool hidden = false;  ///< its curves are not drawn
};

/// Readings of the curves of a few cycles, the newest on top: pull-off force, work of adhesion,
/// hysteresis and contact stiffness, with units. Rows without space are left out, so that the table
/// grows and shrinks with its panel; the tool tip of a row says all of its cycle.
class CycleTable : public QWidget {
    Q_OBJECT

public:
    enum Column { Material, PullOff, Work, Hysteresis, Stiffness, ColumnCount };

    explicit CycleTable(QWidget* parent = nullptr);

    /// Source of the budgets at a row's position, called when they are needed; none: not known.
    using BudgetSource = std::function<std::optional<LandmarkBudgets>(int row)>;
    void setBudgetSource(BudgetSource source) { budgetsOf_ = std::move(source); }
    /// Each row's colors are those of its index, see branchColors().
    void setRows(const std::vector<CycleRow>& newestFirst);
    [[nodiscard]] int rows() const { return static_cast<int>(rows_.size()); }
    [[nodiscard]] QString text(int row, Column column) const;
    /// All of a cycle, with standard deviations by noise and by model, and what the latter come
    /// from.
    [[nodiscard]] QString details(int row) const;

    /// All values of all rows, each with its material.
    [[nodiscard]] ShownNumbers numbers() const;

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;
    bool event(QEvent* event) override;

Q_SIGNALS:
    /// The user clicks on a cycle's row, counted from the top.
    void rowClicked(int row);

protected:
    void mouseReleaseEvent(QMouseEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    /// Returns the reading of a cycle that a column shows [SI].
    [[nodiscard]] static std::optional<Reading> reading(const ContactCycle& cycle, Column column);
    /// The unit of a column, of the largest of its values.
    [[nodiscard]] SiScale unitOf(Column column) const;
    [[nodiscard]] int lineHeight() const;
    /// Returns the row at this height of the widget [px]; none: -1.
    [[nodiscard]] int rowAt(int y) const;
    [[nodiscard]] QRect cell(int line, int column) const;
    void paintRow(QPainter& painter, int row) const;

    /// The readings of a row with what is open in them.
    [[nodiscard]] std::vector<CycleBudget> budgets(int row) const;

    std::vector<CycleRow> rows_;
    BudgetSource budgetsOf_;
};

}  // namespace asperity
