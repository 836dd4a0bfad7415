#include "ui/measure/MarkerModel.h"

namespace asperity {

namespace {

/// In a unit that is the same for all rows.
QString markerLengthText(double meters, double factor, int decimals) {
    return QString::number(factor * meters, 'f', decimals);
}

}  // namespace

void MarkerModel::set(const std::vector<Marker>& markers, const std::vector<double>& heights) {
    if (markers.size() == markers_.size()) {  // a selection stays
        markers_ = markers;
        heights_ = heights;
        if (!markers_.empty()) {
            Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, kColumns - 1));
        }
        return;
    }
    beginResetModel();
    markers_ = markers;
    heights_ = heights;
    endResetModel();
}

int MarkerModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(markers_.size());
}

int MarkerModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : kColumns;
}

QVariant MarkerModel::data(const QModelIndex& index, int role) const {
    const auto row = static_cast<std::size_t>(index.row());
    const Marker& marker = markers_.at(row);
    if (role == Qt::TextAlignmentRole) {
        return QVariant(Qt::AlignVCenter |
                        (index.column() == Name ? Qt::AlignLeft : Qt::AlignRight));
    }
    if (role == Qt::ToolTipRole) {
        return index.column() == Name ? tr("Double click: rename")
                                      : headerData(index.column(), Qt::Horizontal, role);
    }
    if (role != Qt::DisplayRole && role != Qt::EditRole) {
        return {};
    }
    switch (index.column()) {
    case X:
        return markerLengthText(marker.x, 1e6, 4);
    case Y:
        return markerLengthText(marker.y, 1e6, 4);
    case Z:
        return markerLengthText(heights_.at(row), 1e9, 2);
    default:
        return QString::fromStdString(marker.name);
    }
}

bool MarkerModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    const QString name = value.toString().trimmed();
    if (role != Qt::EditRole || index.column() != Name || name.isEmpty() ||
        name == data(index, Qt::EditRole).toString()) {
        return false;
    }
    Q_EMIT renameWanted(index.row(), name);
    return true;
}

Qt::ItemFlags MarkerModel::flags(const QModelIndex& index) const {
    const Qt::ItemFlags flags = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
    return index.column() == Name ? flags | Qt::ItemIsEditable : flags;
}

QVariant MarkerModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal) {
        return {};
    }
    if (role == Qt::DisplayRole) {
        switch (section) {
        case X:
            return QStringLiteral("x [µm]");
        case Y:
            return QStringLiteral("y [µm]");
        case Z:
            return QStringLiteral("z [nm]");
        default:
            return tr("marker");
        }
    }
    if (role == Qt::ToolTipRole) {
        switch (section) {
        case X:
            return tr("From the left edge of the scan");
        case Y:
            return tr("From the lower edge of the scan");
        case Z:
            return tr("Height of the undeformed surface there");
        default:
            return tr("Name of the place; it is kept in the scene");
        }
    }
    return {};
}

}  // namespace asperity
