#include "ui/measure/MarkersPage.h"

#include "ui/measure/PageParts.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QItemSelectionModel>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>

namespace asperity {

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
    setToolTip(tr("Named places of the scene to travel to"));
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
