#pragma once

#include "core/scene/Marker.h"

#include <QAbstractTableModel>

#include <functional>
#include <vector>

namespace asperity {

/// The markers of a scene as a table; their names can be edited in place. A change of a name is
/// only asked for: the scene has the last word.
class MarkerModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Name, X, Y, Z, kColumns };

    using QAbstractTableModel::QAbstractTableModel;

    /// @param heights of the surface at rest under each [m]
    void set(const std::vector<Marker>& markers, const std::vector<double>& heights);
    [[nodiscard]] const std::vector<Marker>& markers() const { return markers_; }

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                      int role) const override;

Q_SIGNALS:
    void renameWanted(int row, QString name);

private:
    std::vector<Marker> markers_;
    std::vector<double> heights_;  ///< [m]
};

}  // namespace asperity
