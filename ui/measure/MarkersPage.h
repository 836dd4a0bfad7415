#pragma once

#include "ui/measure/MarkerModel.h"

#include <QWidget>

class QTableView;
class QToolButton;

namespace asperity {

/// The table of a scene's markers with what can be done to them.
class MarkersPage : public QWidget {
    Q_OBJECT

public:
    explicit MarkersPage(QWidget* parent = nullptr);

    void setMarkers(const std::vector<Marker>& markers, const std::vector<double>& heights);
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

private:
    void showSelection();

    MarkerModel* model_;
    QTableView* table_;
    QToolButton* placing_;
    QToolButton* atTip_;
    QToolButton* travel_;
    QToolButton* delete_;
};

}  // namespace asperity
