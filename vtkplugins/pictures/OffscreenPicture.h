#pragma once

#include "core/Vector.h"
#include "vtkplugins/pictures/DrawnWindow.h"
#include "vtkplugins/pictures/Painter.h"
#include "vtkplugins/pictures/RasterImage.h"

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <filesystem>
#include <functional>

class vtkAbstractContextItem;
class vtkContextActor;
class vtkRenderWindow;
class vtkRenderer;

namespace asperity {

/// A window that nobody sees, drawn at twice the size and averaged down: smooth edges, and the same
/// bytes every time. Layers lie over each other; the painting lies over all of them. Positions are
/// in pixels of its letters (PictureLook), from the lower left corner.
class OffscreenPicture {
public:
    /// Pixels drawn per pixel written, along each side.
    static constexpr int kOversampling = 2;

    /// @throw Error when there is no X display to draw with or too little memory, or the size is
    /// unreasonable
    explicit OffscreenPicture(PictureSize size, const PictureLook& look = {});
    ~OffscreenPicture();
    OffscreenPicture(const OffscreenPicture&) = delete;
    OffscreenPicture& operator=(const OffscreenPicture&) = delete;

    /// All of the picture, in pixels of its letters.
    [[nodiscard]] PixelRect area() const;

    /// A 3-D view in a part of the picture. Views of layer 1 hide nothing of each other; what is in
    /// layer 2 shows through everything in layer 1.
    vtkRenderer* addView(const PixelRect& area, int layer);

    /// Adds a flat item (a chart) below the painting; its units are drawn pixels.
    void addItem(vtkAbstractContextItem* item);
    /// Draws over all views and items.
    void paint(std::function<void(Painter&)> draw);

    /// Returns the position in the picture of a point of the view's world.
    [[nodiscard]] PixelPoint project(vtkRenderer* view, const Vector3& point) const;

    /// @throw Error when drawing fails
    [[nodiscard]] RasterImage image();

    /// @throw Error when drawing or writing fails
    void writePng(const std::filesystem::path& path);

private:
    PictureSize size_;
    PictureLook look_;
    vtkNew<vtkRenderWindow> window_;
    vtkSmartPointer<vtkRenderer> flat_;
    vtkSmartPointer<vtkContextActor> flatActor_;
};

}  // namespace asperity
