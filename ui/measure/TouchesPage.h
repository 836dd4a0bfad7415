#pragma once

#include "ui/measure/TouchModel.h"

#include <QSet>
#include <QWidget>

class QCheckBox;
class QLabel;
class QSortFilterProxyModel;
class QTableView;
class QToolButton;

namespace asperity {

/// The table of all touches of the session: sorted by a click on a column's title; rows are
/// selected to mark them on the whole scan or to copy them.
class TouchesPage : public QWidget {
    Q_OBJECT

public:
    explicit TouchesPage(QWidget* parent = nullptr);

    [[nodiscard]] TouchModel& model() { return *model_; }
    /// Numbers of the selected touches, from 1.
    [[nodiscard]] QSet<int> selected() const;
    /// The selected rows, or all without a selection, in the order shown, with a line of titles;
    /// cells parted by tabs.
    [[nodiscard]] QString rowsAsText() const;

Q_SIGNALS:
    void selectionChanged();
    void markingChosen(bool marked);  ///< on the whole scan
    void exportChosen();
    void clearChosen();

private:
    void buildTable();
    void copy();
    void showCount();

    TouchModel* model_;
    QSortFilterProxyModel* sorted_;
    QTableView* table_;
    QLabel* count_;
    QToolButton* export_;
    QToolButton* copy_;
    QToolButton* clear_;
};

}  // namespace asperity
