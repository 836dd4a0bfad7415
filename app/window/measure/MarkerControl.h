#pragma once

#include "app/window/Stage.h"
#include "app/window/measure/MeasuredHeights.h"
#include "core/scene/SceneDescription.h"
#include "ui/view/MapTool.h"

#include <QAbstractTableModel>
#include <QWidget>

#include <functional>
#include <vector>

class QCheckBox;
class QLabel;
class QTableView;
class QToolButton;

namespace asperity {

class MarkersPage;

/// Named positions on the whole scan. While it is active a double click sets one, and a drag moves
/// one.
class MarkerTool : public MapTool {
    Q_OBJECT

public:
    using MapTool::MapTool;

    void setMarkers(const std::vector<Marker>& markers);
    /// Drawn in strong colors; -1: none.
    void setSelected(int row);

    void paint(QPainter& painter, const OverviewMap& map) const override;
    void press(const MapPointer& pointer, const OverviewMap& map) override;
    void drag(const MapPointer& pointer, const OverviewMap& map) override;
    void release(const MapPointer& pointer, const OverviewMap& map) override;
    void doubleClick(const MapPointer& pointer, const OverviewMap& map) override;
    [[nodiscard]] Qt::CursorShape cursor(const MapPointer& pointer,
                                         const OverviewMap& map) const override;
    [[nodiscard]] QString hint() const override;

Q_SIGNALS:
    void markerWanted(QPointF position);         ///< [m]
    void moveWanted(int row, QPointF position);  ///< [m]
    void markerPressed(int row);

private:
    [[nodiscard]] int markerAt(const MapPointer& pointer, const OverviewMap& map) const;

    std::vector<Marker> markers_;
    int selected_ = -1;
    int held_ = -1;    ///< that a drag moves
    QPointF pressed_;  ///< pixel
    bool moved_ = false;
};

/// The markers of the scene: each change of them is one of the scene's, with undo.
class MarkerControl : public Feature {
public:
    /// @param stage has MeasuredHeights
    explicit MarkerControl(Stage& stage);

    [[nodiscard]] MarkersPage& page() { return *page_; }
    /// Sets a marker at the cross-hair, where there is one.
    void addAtCrossHair();

private:
    void connectPage();
    void show();
    [[nodiscard]] std::vector<Marker> markers() const;
    void add(const QPointF& position);
    void move(int row, const QPointF& position);
    void rename(int row, const QString& name);
    void remove(int row);
    void travelTo(int row);
    void change(const QString& name, const std::vector<Marker>& markers);

    MeasuredHeights& heights_;
    MarkersPage* page_;  ///< the window's
    MarkerTool tool_;
};

/// The markers of a scene as a table; their names can be edited in the table. A change of a name is
/// only asked for: the scene has the last word.
class MarkerModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Name, X, Y, Z, kColumns };

    using QAbstractTableModel::QAbstractTableModel;

    /// @param heights under each; NaN: not known [m]
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

/// The table of a scene's markers with what can be done to them.
class MarkersPage : public QWidget {
    Q_OBJECT

public:
    explicit MarkersPage(QWidget* parent = nullptr);

    /// @param words smoothing of the heights, or why there are none
    void setMarkers(const std::vector<Marker>& markers, const std::vector<double>& heights,
                    const QString& words);
    /// The choice whether the heights are those that the tip meets, else of the leveled scan.
    [[nodiscard]] QCheckBox& smoothed() { return *smoothed_; }
    [[nodiscard]] const MarkerModel& model() const { return *model_; }
    /// The row that is selected; -1: none.
    [[nodiscard]] int selected() const;
    void select(int row);
    /// Shows whether a double click on the whole scan sets a marker.
    void setPlacing(bool placing);

Q_SIGNALS:
    void placingChosen(bool placing);
    void atTipChosen();
    void travelChosen(int row);
    void deleteChosen(int row);
    void renameChosen(int row, QString name);
    void selectionChanged(int row);
    /// The user looks at it now.
    void shown();

protected:
    void showEvent(QShowEvent* event) override;

private:
    void showSelection();

    MarkerModel* model_;
    QTableView* table_;
    QToolButton* placing_;
    QToolButton* atTip_;
    QToolButton* travel_;
    QToolButton* delete_;
    QCheckBox* smoothed_;
    QLabel* hint_;
};

}  // namespace asperity
