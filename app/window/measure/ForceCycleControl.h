#pragma once

#include "app/reports/ForceCycleTable.h"
#include "app/window/Stage.h"
#include "core/haptics/cycle/CycleDetector.h"
#include "ui/view/MapTool.h"

#include <QAbstractTableModel>
#include <QSet>
#include <QVector>
#include <QWidget>

#include <filesystem>
#include <vector>

class QCheckBox;
class QLabel;
class QSortFilterProxyModel;
class QTableView;
class QToolButton;

namespace asperity {

class ForceCyclePage;

/// A force cycle as it is marked on the whole scan.
struct MarkedForceCycle {
    int number = 0;    ///< as the table counts it
    QPointF position;  ///< world [m]
};

/// Numbered dots where the tip touched, with those that are selected in the table in strong colors.
class ForceCycleMarks : public MapTool {
    Q_OBJECT

public:
    using MapTool::MapTool;

    void setForceCycles(const QVector<MarkedForceCycle>& cycles);
    void setSelected(const QSet<int>& numbers);
    void setShown(bool shown);
    [[nodiscard]] bool isShown() const { return shown_; }

    void paint(QPainter& painter, const OverviewMap& map) const override;

private:
    void paintOne(QPainter& painter, const OverviewMap& map, const MarkedForceCycle& cycle) const;

    QVector<MarkedForceCycle> cycles_;
    QSet<int> selected_;
    bool shown_ = true;
};

/// Force cycles since the program started, the first on top. Qt::UserRole gives a cell's number in
/// its SI unit, or its text; invalid: the cycle has no such value.
class ForceCycleModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column {
        Number,
        Time,
        X,
        Y,
        SnapIn,
        SnapInDistance,
        PullOff,
        Work,
        Stiffness,
        MaxForce,
        MaxIndentation,
        Material,
        Scan,
        ColumnCount
    };

    using QAbstractTableModel::QAbstractTableModel;

    void append(const ForceCycle& entry);
    /// The last one has gone on.
    void updateLast(const ForceCycle& entry);
    void clear();
    [[nodiscard]] const std::vector<ForceCycle>& forceCycles() const { return cycles_; }

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                      int role) const override;

private:
    std::vector<ForceCycle> cycles_;
};

/// Collects the force cycles since the program started, of all scenes, for their table and their
/// marks on the whole scan.
class ForceCycleControl : public Feature {
public:
    explicit ForceCycleControl(Stage& stage);

    [[nodiscard]] ForceCyclePage& page() { return *page_; }
    /// Every tick, in order; allocates nothing but at the first contact of a cycle.
    void take(const TickSample& sample);
    /// Once a frame: shows new cycles at once, and the progress of the last a few times a second.
    void show();
    /// Writes all cycles; says in the window when that fails.
    void writeTo(const std::filesystem::path& file);

private:
    void begin();
    void end();
    void clear();
    void askForFile();
    void write(const std::filesystem::path& file);
    /// @param more there are new cycles
    void update(bool more);
    void markAll();

    ForceCyclePage* page_;  ///< the window's
    ForceCycleMarks marks_;
    CycleDetector detector_;
    std::vector<ForceCycle> fresh_;  ///< that the table does not show yet, or not as they are now
    std::int64_t number_ = -1;       ///< of the last cycle of this run; -1: none yet
    bool continues_ = false;  ///< the first of `fresh_` is the last row of the table, gone on
    int framesSince_ = 0;     ///< the last update
    QString material_;
    QString scan_;
};

/// The table of all force cycles: sorted by a click on a column's title; rows are
/// selected to mark them on the whole scan or to copy them.
class ForceCyclePage : public QWidget {
    Q_OBJECT

public:
    explicit ForceCyclePage(QWidget* parent = nullptr);

    [[nodiscard]] ForceCycleModel& model() { return *model_; }
    /// Numbers of the selected cycles, from 1.
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

    ForceCycleModel* model_;
    QSortFilterProxyModel* sorted_;
    QTableView* table_;
    QLabel* count_;
    QToolButton* export_;
    QToolButton* copy_;
    QToolButton* clear_;
};

}  // namespace asperity
