#pragma once

#include "ui/panels/MapTool.h"

#include <QSet>
#include <QVector>

namespace asperity {

/// A touch as it is marked on the whole scan.
struct MarkedTouch {
    int number = 0;  ///< as the table counts it
    QPointF place;   ///< world [m]
};

/// Numbered dots where the tip touched, with those that are selected in the table in strong colors.
class TouchMarks : public MapTool {
    Q_OBJECT

public:
    using MapTool::MapTool;

    void setTouches(const QVector<MarkedTouch>& touches);
    void setSelected(const QSet<int>& numbers);
    void setShown(bool shown);
    [[nodiscard]] bool isShown() const { return shown_; }

    void paint(QPainter& painter, const OverviewMap& map) const override;

private:
    void paintOne(QPainter& painter, const OverviewMap& map, const MarkedTouch& touch) const;

    QVector<MarkedTouch> touches_;
    QSet<int> selected_;
    bool shown_ = true;
};

}  // namespace asperity
