#pragma once

#include "ui/view/FrameAxes.h"
#include "vtkplugins/pictures/Painter.h"

#include <vtkSmartPointer.h>

#include <optional>
#include <string>
#include <vector>

class vtkRenderer;

namespace asperity {

class PainterItem;

/// What is written over the view.
struct LabelContent {
    bool scaleBars = false;
    double metersPerPixel = 0.0;  ///< across the view, in the screen's coordinates
    double heightPerPixel = 0.0;  ///< the same of heights, upwards
    std::optional<FrameAxes> axes;
    std::vector<std::string> notes;   ///< on how the view is to be read
    std::string tipAbove;             ///< where the tip is above the view; empty: it is in it
    std::string force;                ///< magnitude, with its unit
    std::optional<Vector3> forceEnd;  ///< where its label belongs, as drawn; empty: no label [m]
    struct Name {
        Vector3 place = Vector3::Zero();  ///< as drawn [m]
        std::string text;
        Color color;
    };
    std::vector<Name> names;    ///< of what is in the view
    std::vector<Name> markers;  ///< of the scene, each where it is
    std::string reading;        ///< of the cross-hair; empty: none
    std::string caption;        ///< of the picture; empty: none
};

/// Scale bars, axes, notes and the force, painted over a view.
class ViewLabels {
public:
    /// @param renderer outlives this object
    explicit ViewLabels(vtkRenderer* renderer);
    ~ViewLabels();
    ViewLabels(const ViewLabels&) = delete;
    ViewLabels& operator=(const ViewLabels&) = delete;

    /// @param pixelRatio drawn pixels per pixel of the screen's coordinates
    void setPixelRatio(double pixelRatio);
    void show(const LabelContent& content) { content_ = content; }
    void hide() { content_ = {}; }

private:
    void paint(Painter& painter) const;
    void paintScaleBars(Painter& painter, double viewWidth, double viewHeight) const;
    void paintNotes(Painter& painter, double viewWidth, double viewHeight) const;
    void paintForce(Painter& painter, double viewWidth, double viewHeight) const;
    void paintNames(Painter& painter, double viewWidth, double viewHeight) const;
    void paintMarkers(Painter& painter, double viewWidth, double viewHeight) const;
    void paintReading(Painter& painter, double viewWidth, double viewHeight) const;
    void paintCaption(Painter& painter, double y, double viewWidth, double viewHeight) const;
    [[nodiscard]] PixelPoint project(const Vector3& place) const;

    vtkRenderer* renderer_;
    vtkSmartPointer<PainterItem> item_;
    double pixelRatio_ = 1.0;
    LabelContent content_;
};

}  // namespace asperity
