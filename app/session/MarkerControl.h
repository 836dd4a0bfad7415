#pragma once

#include "app/session/RunControl.h"
#include "app/session/SceneEdits.h"
#include "core/scene/Marker.h"
#include "ui/measure/MarkerTool.h"

#include <vector>

namespace asperity {

class MarkersPage;

/// The markers of the scene: each change of them is one of the scene's, with undo.
class MarkerControl : public QObject {
public:
    MarkerControl(MainWindow& window, RunControl& runs, SceneEdits& edits);

    [[nodiscard]] MarkersPage& page() { return *page_; }
    /// Sets a marker at the cross-hair, where there is one.
    void addAtCrossHair();

private:
    void connectPage();
    void show();
    [[nodiscard]] std::vector<Marker> markers() const;
    void add(const QPointF& place);
    void move(int row, const QPointF& place);
    void rename(int row, const QString& name);
    void remove(int row);
    void travelTo(int row);
    void change(const QString& name, const std::vector<Marker>& markers);

    MainWindow& window_;
    RunControl& runs_;
    SceneEdits& edits_;
    MarkersPage* page_;  ///< the window's
    MarkerTool tool_;
};

}  // namespace asperity
