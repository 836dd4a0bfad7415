#include "app/session/MarkerControl.h"

#include "app/session/ToolBinding.h"
#include "ui/measure/MarkersPage.h"
#include "ui/panels/OverviewPanel.h"
#include "ui/window/MainWindow.h"

#include <algorithm>

namespace asperity {

namespace {

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

}  // namespace

MarkerControl::MarkerControl(MainWindow& window, RunControl& runs, SceneEdits& edits)
    : window_(window), runs_(runs), edits_(edits), page_(new MarkersPage(&window)) {
    window.addTool(page_, tr("Markers"));
    bindTool(window.overview().map(), tool_, *page_, &MarkersPage::placingChosen,
             &MarkersPage::setPlacing);
    connect(&tool_, &MarkerTool::markerWanted, this, &MarkerControl::add);
    connect(&tool_, &MarkerTool::moveWanted, this, &MarkerControl::move);
    connect(&tool_, &MarkerTool::markerPressed, page_, &MarkersPage::select);
    connectPage();
    connect(&runs, &RunControl::begun, this, &MarkerControl::show);
    connect(&edits, &SceneEdits::changed, this, &MarkerControl::show);
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
        heights.push_back(runs_.run() != nullptr
                              ? runs_.run()->scene().surface.at(marker.x, marker.y).height
                              : 0.0);
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
    if (const std::optional<Vector2> place = window_.crossHair()) {
        add({place->x(), place->y()});
    } else {
        window_.tell(tr("Move the pointer over a view: the marker is set there"));
    }
}

void MarkerControl::add(const QPointF& place) {
    if (edits_.wanted() == nullptr) {
        return;
    }
    std::vector<Marker> next = markers();
    next.push_back({freeName(next), place.x(), place.y()});
    change(tr("Marker %1").arg(QString::fromStdString(next.back().name)), next);
    page_->select(static_cast<int>(next.size()) - 1);
}

void MarkerControl::move(int row, const QPointF& place) {
    std::vector<Marker> next = markers();
    Marker& marker = next.at(static_cast<std::size_t>(row));
    marker.x = place.x();
    marker.y = place.y();
    change(tr("Move marker %1").arg(QString::fromStdString(marker.name)), next);
}

void MarkerControl::rename(int row, const QString& name) {
    std::vector<Marker> next = markers();
    if (isTaken(next, name.toStdString())) {
        window_.tell(tr("Another marker has the name %1").arg(name));
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
    Q_EMIT window_.overview().placeChosen(marker.x, marker.y);
}

}  // namespace asperity
