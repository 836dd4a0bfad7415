#pragma once

#include "ui/measure/Touch.h"

#include <QAbstractTableModel>

#include <vector>

namespace asperity {

/// The touches of a session as a table, the first on top. Qt::UserRole gives the number of a cell
/// in its SI unit, or its text; invalid: the touch has no such value.
class TouchModel : public QAbstractTableModel {
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

    void append(const Touch& touch);
    /// The last one has gone on.
    void updateLast(const Touch& touch);
    void clear();
    [[nodiscard]] const std::vector<Touch>& touches() const { return touches_; }

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                      int role) const override;

private:
    std::vector<Touch> touches_;
};

}  // namespace asperity
