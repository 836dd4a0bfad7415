#pragma once

#include "core/Vector.h"
#include "core/surface/BSplineSurface.h"
#include "ui/view/Shading.h"
#include "ui/view/SurfaceColors.h"
#include "vtkplugins/pictures/OverviewPicture.h"

#include <vtkSmartPointer.h>

#include <array>
#include <memory>
#include <vector>

class vtkPolyData;
class vtkRenderer;
class vtkActor;

namespace asperity {

/// The part of a scan that a view shows, and the part of it that something else fills.
struct TerrainArea {
    ScanWindow window;
    ScanWindow hole;   ///< in the terrain
    ScanWindow patch;  ///< what fills the hole and laps over its edges; has a grid of its own
};

/// Parameters with which the terrain is drawn.
struct TerrainStyle {
    const SurfaceColors& colors;
    DrawnSpace space;
    Shading shading;
    bool grid = true;
};

/// Level of detail of the terrain.
enum class TerrainDetail : std::uint8_t {
    Coarse,  ///< at most 80 samples a side: cheap enough to be drawn again for every frame
    Fine,    ///< at most 384: what a screen shows, and no frame takes over 0.1 s
};

/// A part of the surface at rest as a block of sample: lit, in the colors of a quantity, a grid
/// draped over it; with a hole where the contact is drawn, through its walls too where it lies at
/// an edge.
class TerrainLayer {
public:
    explicit TerrainLayer(vtkRenderer* renderer);
    ~TerrainLayer();
    TerrainLayer(const TerrainLayer&) = delete;
    TerrainLayer& operator=(const TerrainLayer&) = delete;

    /// Shown from the next call of show() on. @param surface outlives its use here
    void setArea(const BSplineSurface& surface, const TerrainArea& area);
    /// World z where the block of sample ends below, from the next call of show() on [m].
    void setBottom(double bottom);
    [[nodiscard]] double bottom() const { return bottom_; }
    void hide();

    /// Shows the area; does only what has changed since.
    void show(TerrainDetail detail, const TerrainStyle& style);

    [[nodiscard]] const TerrainArea& area() const { return area_; }
    /// Lowest and highest z in the window [m].
    [[nodiscard]] const std::array<double, 2>& heightRange() const { return heights_; }
    /// A field's values at positions spread evenly over the window. There is an area.
    [[nodiscard]] std::vector<double> valuesOf(const SurfaceField& field) const;

private:
    struct Mesh;
    template <class Visit>
    void survey(const Visit& visit) const;
    [[nodiscard]] int fineSamples() const;
    void build(Mesh& mesh, int samples) const;
    [[nodiscard]] vtkSmartPointer<vtkPolyData> drapedGrid(int stepsAcross) const;

    const BSplineSurface* surface_ = nullptr;
    TerrainArea area_;
    std::unique_ptr<Mesh> coarse_;
    std::unique_ptr<Mesh> fine_;
    std::array<double, 2> heights_{};
    double bottom_ = 0.0;
};

/// Distance of grid lines for a surface of this width: a round number, some thirty lines [m].
[[nodiscard]] double gridSpacing(double width);

/// Multiples of the spacing between two positions, both excluded.
[[nodiscard]] std::vector<double> gridPositions(double low, double high, double spacing);

/// Thin lines that let the surface below them shine through. They are blended over what is drawn
/// before them, and VTK takes them for opaque: its own passes for translucent things take longer
/// than all the rest of a frame.
[[nodiscard]] vtkSmartPointer<vtkActor> thinLines(vtkPolyData* data);

/// Several lines, one after another, for drawing.
class Polylines {
public:
    Polylines();
    void add(const std::vector<Vector3>& points);
    [[nodiscard]] vtkSmartPointer<vtkPolyData> data() const { return data_; }

private:
    vtkSmartPointer<vtkPolyData> data_;
};

}  // namespace asperity
