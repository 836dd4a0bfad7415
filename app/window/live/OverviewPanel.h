#pragma once

#include "core/deformation/SurfaceField.h"
#include "core/surface/BSplineSurface.h"
#include "ui/shell/RunPanel.h"
#include "ui/view/ColorScale.h"
#include "ui/widgets/Card.h"

#include <QPolygonF>
#include <QRectF>

class QLabel;
class QVBoxLayout;

namespace asperity {

class ColorBarWidget;
class OverviewMap;

/// The whole scan from above with the tip's position and the frame of the zoomed view. Positions
/// are world x, y [m], y up.
class OverviewPanel : public Card, public RunPanel {
    Q_OBJECT

public:
    explicit OverviewPanel(QWidget* parent = nullptr);

    /// The surface of a new scene; forgets what was shown over the old one.
    void setSurface(const BSplineSurface& surface);
    /// Shows a note on the scan as a whole: in a few words, and for the tool tip.
    void setScanNote(const QString& words, const QString& whole);
    /// Colors the surface. @param field values of the look's quantity on the surface
    void setLook(const SurfaceLook& look, const SurfaceField& field);
    /// Marks the part that the zoomed view shows.
    void showFrame(const QRectF& frame);
    /// The way a scripted device goes; empty: none.
    void showPath(const QPolygonF& path);
    void clear() override;
    void begin(const Scene& scene) override;
    void show(const Snapshot& snapshot) override;
    using QWidget::show;
    [[nodiscard]] const char* slowName() const override { return "overview"; }

    [[nodiscard]] OverviewMap& map() { return *map_; }
    [[nodiscard]] ColorBarWidget& colorBar() { return *colorBar_; }

Q_SIGNALS:
    /// A user wants to go there [m].
    void positionChosen(double x, double y);

private:
    void addLegend(QVBoxLayout& side);
    void showFilledLegend();

    OverviewMap* map_;
    ColorBarWidget* colorBar_;
    QLabel* scanNote_;
    QWidget* filledLegend_;
    QLabel* filledWords_;
};

}  // namespace asperity
