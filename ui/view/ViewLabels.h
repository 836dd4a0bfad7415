#pragma once

#include "core/Vector.h"
#include "vtkplugins/pictures/OverviewPicture.h"
#include "vtkplugins/pictures/Painter.h"

#include <vtkSmartPointer.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

class vtkRenderer;

namespace asperity {

class Painter;
class PainterItem;
struct PixelPoint;

/// Axes along the two lower edges of a frame that face the eye.
struct FrameAxes {
    ScanWindow window;
    double bottom = 0.0;               ///< z of the edges, as drawn [m]
    Vector3 toEye = Vector3::UnitZ();  ///< unit
};

/// Paints edges, ticks and positions in the scan with their unit.
/// @param project where a position as drawn [m] is in the picture
void paintAxes(Painter& painter, const FrameAxes& axes,
               const std::function<PixelPoint(const Vector3&)>& project);

/// Texts and bars that are written over the view.
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
        Vector3 position = Vector3::Zero();  ///< as drawn [m]
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
    /// Lengths and positions of both bars.
    struct ScaleBars {
        double across = 0.0;  ///< [m]
        std::string acrossText;
        double right = 0.0;    ///< end of the bar across [px]
        double upwards = 0.0;  ///< 0: there is none [m]
        std::string upwardsText;
        double top = 0.0;  ///< end of the bar upwards [px]
        PixelRect area;    ///< of the bars with their numbers [px]
    };

    void paint(Painter& painter);
    [[nodiscard]] ScaleBars scaleBars(Painter& painter, double viewWidth, double viewHeight) const;
    static void paintScaleBars(Painter& painter, const ScaleBars& bars);
    /// A label that keeps off the scale bars.
    void paintLabel(Painter& painter, const PixelPoint& at, const std::string& text,
                    const TextStyle& style) const;
    void paintNotes(Painter& painter, double viewWidth, double viewHeight) const;
    void paintForce(Painter& painter) const;
    void paintNames(Painter& painter) const;
    void paintMarkers(Painter& painter) const;
    void paintReading(Painter& painter) const;
    void paintCaption(Painter& painter, double y, double viewWidth, double viewHeight) const;
    [[nodiscard]] PixelPoint project(const Vector3& position) const;

    vtkRenderer* renderer_;
    vtkSmartPointer<PainterItem> item_;
    double pixelRatio_ = 1.0;
    LabelContent content_;
    PixelRect view_;  ///< the whole picture [px]
    PixelRect bars_;  ///< of the scale bars; empty: there are none [px]
};

/// Returns where a label may be: in the view, and where it would lie over the scale bars, above
/// them.
/// @param plate of the label, where it is wanted [px] @param bars empty: there are none [px]
[[nodiscard]] PixelRect labelBounds(const PixelRect& plate, const PixelRect& view,
                                    const PixelRect& bars);

/// Facts that the notes of a view depend on.
struct ViewNoteFacts {
    double heightScale = 1.0;
    bool hasPerspective = false;
    bool isFromBelow = false;       ///< the underside of the surface is seen
    bool missesTrueTip = false;     ///< its ghost is asked for, and the instrument does not know it
    bool hidesDeformation = false;  ///< the surface is drawn at rest
    bool showsLever = false;
    bool showsCap = false;   ///< only the lowest part of a large tip is drawn
    double tipRadius = 0.0;  ///< [m]
    double pixel = 0.0;      ///< of the scan [m]
    double width = 0.0;      ///< of the frame [m]
};

/// Returns what a picture does not show by itself: a stretched height, coarse pixels.
[[nodiscard]] std::vector<std::string> viewNotes(const ViewNoteFacts& facts);

/// Returns the note of a tip above the view. @param gap to the surface [m]
[[nodiscard]] std::string tipAboveNote(double gap);

}  // namespace asperity
