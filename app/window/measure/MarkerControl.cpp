#include "app/window/measure/MarkerControl.h"

#include "app/window/live/LivePanels.h"
#include "app/window/live/OverviewPanel.h"
#include "ui/shell/Menus.h"
#include "ui/view/MapTool.h"
#include "ui/view/OverviewMap.h"
#include "ui/widgets/PageParts.h"
#include "ui/widgets/Theme.h"

#include <QAction>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QItemSelectionModel>
#include <QLineF>
#include <QPainter>
#include <QPainterPath>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace asperity {

namespace {

constexpr double kMarkerReach = 8.0;  ///< of the pointer to a marker [px]
constexpr double kArm = 5.0;          ///< half a marker's cross [px]

QPointF positionOf(const Marker& marker) { return {marker.x, marker.y}; }

/// A cross that is no plus: those are the tip's.
QPainterPath crossAt(const QPointF& center) {
    QPainterPath path;
    for (const QPointF& arm : {QPointF(kArm, kArm), QPointF(kArm, -kArm)}) {
        path.moveTo(center - arm);
        path.lineTo(center + arm);
    }
    return path;
}

bool isTaken(const std::vector<Marker>& markers, const std::string& name) {
    return std::any_of(markers.begin(), markers.end(),
                       [&name](const Marker& marker) { return marker.name == name; });
}

/// "M1", "M2", ...: the first that is free.
std::string freeName(const std::vector<Marker>& markers) {
    std::size_t number = 1;
    while (isTaken(markers, "M" + std::to_string(number))) {
        ++number;
    }
    return "M" + std::to_string(number);
}

/// In a unit that is the same for all rows.
QString markerLengthText(double meters, double factor, int decimals) {
    return QString::number(factor * meters, 'f', decimals);
}

}  // namespace

void MarkerTool::setMarkers(const std::vector<Marker>& markers) {
    markers_ = markers;
    held_ = -1;
    Q_EMIT marksChanged();
}

void MarkerTool::setSelected(int row) {
    selected_ = row;
    Q_EMIT marksChanged();
}

void MarkerTool::paint(QPainter& painter, const OverviewMap& map) const {
    for (std::size_t i = 0; i < markers_.size(); ++i) {
        const bool selected = static_cast<int>(i) == selected_;
        const Color& color = selected ? kLightPalette.force : kLightPalette.ink;
        const QPointF center = map.toPixel(positionOf(markers_[i]));
        strokeOverWhite(painter, color, selected ? 2.6 : 1.8, crossAt(center));
        labelMark(painter, color, center + QPointF(kArm + 4.0, 4.0),
                  QString::fromStdString(markers_[i].name));
    }
}

int MarkerTool::markerAt(const MapPointer& pointer, const OverviewMap& map) const {
    int nearest = -1;
    double distance = kMarkerReach;
    for (std::size_t i = 0; i < markers_.size(); ++i) {
        const double one = QLineF(map.toPixel(positionOf(markers_[i])), pointer.pixel).length();
        if (one <= distance) {
            distance = one;
            nearest = static_cast<int>(i);
        }
    }
    return nearest;
}

void MarkerTool::press(const MapPointer& pointer, const OverviewMap& map) {
    held_ = markerAt(pointer, map);
    pressed_ = pointer.pixel;
    moved_ = false;
    if (held_ >= 0) {
        Q_EMIT markerPressed(held_);
    }
}

void MarkerTool::drag(const MapPointer& pointer, const OverviewMap& map) {
    moved_ = moved_ || QLineF(pressed_, pointer.pixel).length() >= kMinDrag;
    if (held_ >= 0 && moved_) {
        const QPointF position = map.onScan(pointer.position);
        Marker& marker = markers_[static_cast<std::size_t>(held_)];
        marker.x = position.x();
        marker.y = position.y();
        Q_EMIT marksChanged();
    }
}

/// One change of the scene for a whole drag.
void MarkerTool::release(const MapPointer& pointer, const OverviewMap& map) {
    drag(pointer, map);
    const int row = std::exchange(held_, -1);
    if (row >= 0 && moved_) {
        Q_EMIT moveWanted(row, positionOf(markers_[static_cast<std::size_t>(row)]));
    }
}

void MarkerTool::doubleClick(const MapPointer& pointer, const OverviewMap& map) {
    if (map.mapRect().contains(pointer.pixel) && markerAt(pointer, map) < 0) {
        Q_EMIT markerWanted(pointer.position);
    }
}

Qt::CursorShape MarkerTool::cursor(const MapPointer& pointer, const OverviewMap& map) const {
    return markerAt(pointer, map) >= 0 ? Qt::SizeAllCursor : Qt::CrossCursor;
}

QString MarkerTool::hint() const { return tr("Double click: set a marker; drag: move one"); }

MarkerControl::MarkerControl(Stage& stage)
    : Feature(stage), page_(new MarkersPage(&host_.widget())) {
    addScanTool(page_, tr("Markers"), 30, "markers",
                {.text = tr("&Markers"),
                 .tip = tr("Named points to travel to"),
                 .shortcuts = {tr("Ctrl+M")}});
    const QAction& here =
        host_.menus().add({MenuName::Measure, 0, 40}, "markerHere",
                          {.text = tr("Marker at the cross-&hair"),
                           .tip = tr("By its key: sets a marker where the pointer is, in any view"),
                           .shortcuts = {tr("Ctrl+Shift+M")}});
    connect(&here, &QAction::triggered, this, &MarkerControl::addAtCrossHair);
    bindTool(live_.overview().map(), tool_, *page_, &MarkersPage::placingChosen,
             &MarkersPage::setPlacing);
    connect(&tool_, &MarkerTool::markerWanted, this, &MarkerControl::add);
    connect(&tool_, &MarkerTool::moveWanted, this, &MarkerControl::move);
    connect(&tool_, &MarkerTool::markerPressed, page_, &MarkersPage::select);
    connectPage();
    connect(&runs_, &RunControl::begun, this, &MarkerControl::show);
    connect(&edits_, &SceneEdits::changed, this, &MarkerControl::show);
}

void MarkerControl::connectPage() {
    connect(page_, &MarkersPage::atTipChosen, this, [this] {
        if (runs_.run() != nullptr) {
            const Vector3& tip = runs_.shown().sample.output.model.tip;
            add({tip.x(), tip.y()});
        }
    });
    connect(page_, &MarkersPage::travelChosen, this, &MarkerControl::travelTo);
    connect(page_, &MarkersPage::deleteChosen, this, &MarkerControl::remove);
    connect(page_, &MarkersPage::renameChosen, this, &MarkerControl::rename);
    connect(page_, &MarkersPage::selectionChanged, &tool_, &MarkerTool::setSelected);
}

std::vector<Marker> MarkerControl::markers() const {
    return edits_.wanted() != nullptr ? edits_.wanted()->markers : std::vector<Marker>();
}

void MarkerControl::show() {
    const std::vector<Marker> all = markers();
    std::vector<double> heights;
    for (const Marker& marker : all) {
        heights.push_back(
            runs_.run() != nullptr ? runs_.scene().surface.at(marker.x, marker.y).height : 0.0);
    }
    page_->setMarkers(all, heights);
    tool_.setMarkers(all);
}

void MarkerControl::change(const QString& name, const std::vector<Marker>& markers) {
    if (edits_.wanted() != nullptr) {
        SceneDescription next = *edits_.wanted();
        next.markers = markers;
        edits_.change(name, next);
    }
    show();
}

void MarkerControl::addAtCrossHair() {
    if (const std::optional<Vector2> position = live_.crossHair()) {
        add({position->x(), position->y()});
    } else {
        host_.tell(tr("Move the pointer over a view: the marker is set there"));
    }
}

void MarkerControl::add(const QPointF& position) {
    if (edits_.wanted() == nullptr) {
        return;
    }
    std::vector<Marker> next = markers();
    next.push_back({freeName(next), position.x(), position.y()});
    change(tr("Marker %1").arg(QString::fromStdString(next.back().name)), next);
    page_->select(static_cast<int>(next.size()) - 1);
}

void MarkerControl::move(int row, const QPointF& position) {
    std::vector<Marker> next = markers();
    Marker& marker = next.at(static_cast<std::size_t>(row));
    marker.x = position.x();
    marker.y = position.y();
    change(tr("Move marker %1").arg(QString::fromStdString(marker.name)), next);
}

void MarkerControl::rename(int row, const QString& name) {
    std::vector<Marker> next = markers();
    if (isTaken(next, name.toStdString())) {
        host_.tell(tr("Another marker has the name %1").arg(name));
        return;
    }
    next.at(static_cast<std::size_t>(row)).name = name.toStdString();
    change(tr("Rename marker: %1").arg(name), next);
}

void MarkerControl::remove(int row) {
    std::vector<Marker> next = markers();
    const auto marker = next.begin() + row;
    const QString name = QString::fromStdString(marker->name);
    next.erase(marker);
    change(tr("Delete marker %1").arg(name), next);
}

void MarkerControl::travelTo(int row) {
    const Marker marker = markers().at(static_cast<std::size_t>(row));
    Q_EMIT live_.overview().positionChosen(marker.x, marker.y);
}

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
            return tr("Name of the point; it is kept in the scene");
        }
    }
    return {};
}

MarkersPage::MarkersPage(QWidget* parent)
    : QWidget(parent)
    , model_(new MarkerModel(this))
    , table_(new QTableView(this))
    , placing_(pageButton(tr("Set on the scan"), "placeMarkers",
                          tr("A double click on the whole scan sets a marker; off, or Esc: it "
                             "travels again"),
                          this))
    , atTip_(pageButton(tr("Set at the tip"), "markerAtTip", tr("Sets a marker where the tip is"),
                        this))
    , travel_(pageButton(tr("Travel there"), "travelToMarker",
                         tr("The tip rises, moves to the selected marker and comes down to just "
                            "above the sample"),
                         this))
    , delete_(pageButton(tr("Delete"), "deleteMarker", tr("Deletes the selected marker"), this)) {
    setToolTip(tr("Named points of the scene to travel to"));
    placing_->setCheckable(true);
    auto* bar = new QHBoxLayout;
    bar->setSpacing(4);
    for (QToolButton* const button : {placing_, atTip_, travel_, delete_}) {
        bar->addWidget(button);
    }
    bar->addStretch(1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(6, 4, 6, 4);
    column->setSpacing(4);
    column->addLayout(bar);
    column->addWidget(table_, 1);
    table_->setModel(model_);
    stylePageTable(*table_, "markers", tr("Markers of the scene; a double click renames"));
    table_->setSelectionMode(QAbstractItemView::SingleSelection);
    table_->horizontalHeader()->setSectionResizeMode(MarkerModel::Name, QHeaderView::Stretch);
    connect(placing_, &QToolButton::toggled, this, &MarkersPage::placingChosen);
    connect(atTip_, &QToolButton::clicked, this, &MarkersPage::atTipChosen);
    connect(travel_, &QToolButton::clicked, this, [this] { Q_EMIT travelChosen(selected()); });
    connect(delete_, &QToolButton::clicked, this, [this] { Q_EMIT deleteChosen(selected()); });
    connect(model_, &MarkerModel::renameWanted, this, &MarkersPage::renameChosen);
    connect(table_->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            &MarkersPage::showSelection);
    connect(model_, &QAbstractItemModel::modelReset, this, &MarkersPage::showSelection);
    showSelection();
}

void MarkersPage::setMarkers(const std::vector<Marker>& markers,
                             const std::vector<double>& heights) {
    model_->set(markers, heights);
}

int MarkersPage::selected() const {
    const QModelIndexList rows = table_->selectionModel()->selectedRows();
    return rows.isEmpty() ? -1 : rows.front().row();
}

void MarkersPage::select(int row) { table_->selectRow(row); }

void MarkersPage::setPlacing(bool placing) { placing_->setChecked(placing); }

void MarkersPage::showSelection() {
    const int row = selected();
    travel_->setEnabled(row >= 0);
    delete_->setEnabled(row >= 0);
    Q_EMIT selectionChanged(row);
}

}  // namespace asperity
