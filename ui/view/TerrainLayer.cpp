#include "ui/view/TerrainLayer.h"

#include "ui/widgets/Theme.h"
#include "vtkplugins/module/vtkAspSurfaceSource.h"
#include "vtkplugins/pictures/SceneParts.h"
#include "vtkplugins/pictures/Ticks.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

constexpr int kSurveySamples = 96;
constexpr int kSamplesPerPixel = 4;
constexpr int kMinSamples = 48;  // samples along each side
constexpr int kCoarse = 80;
constexpr int kFine = 384;
constexpr int kMaxGridSteps = 192;  // along a line across the window

double widthOf(const ScanWindow& window) {
    return std::max(window.right - window.left, window.top - window.bottom);
}

/// A stretch of a grid line: its position across, and where it begins and ends.
struct TerrainStroke {
    double position;
    double from;
    double to;
};

/// One axis of an area: across the lines, or along them.
struct Extent {
    double low;
    double high;
    double patchLow;
    double patchHigh;
};

/// Grid lines at round positions and along the edges, broken where they would cross the patch.
std::vector<TerrainStroke> strokes(const Extent& across, const Extent& along, double spacing) {
    std::vector<double> positions = gridPositions(across.low, across.high, spacing);
    positions.insert(positions.end(), {across.low, across.high});
    std::vector<TerrainStroke> found;
    for (const double position : positions) {
        if (position < across.patchLow || position > across.patchHigh) {
            found.push_back({position, along.low, along.high});
            continue;
        }
        if (along.low < along.patchLow) {
            found.push_back({position, along.low, along.patchLow});
        }
        if (along.patchHigh < along.high) {
            found.push_back({position, along.patchHigh, along.high});
        }
    }
    return found;
}

/// Returns whether a position on the window's border lies at the hole: between its corners, or at
/// a corner that is also the window's.
bool opensIntoHole(const Vector3& position, const ScanWindow& hole, const ScanWindow& window) {
    const double rounding = 1e-6 * widthOf(window);  // positions are single-precision numbers
    const auto isWithin = [rounding](double at, const Vector2& inner, const Vector2& outer) {
        return (at > inner.x() + rounding || inner.x() == outer.x()) &&
               (at < inner.y() - rounding || inner.y() == outer.y());
    };
    return isWithin(position.x(), {hole.left, hole.right}, {window.left, window.right}) &&
           isWithin(position.y(), {hole.bottom, hole.top}, {window.bottom, window.top});
}

/// Takes the walls away where the contact is drawn with walls of its own.
void openWalls(vtkPolyData* sides, const TerrainArea& area) {
    for (vtkIdType top = 0; top < sides->GetNumberOfPoints(); top += 2) {
        if (opensIntoHole(Vector3(sides->GetPoint(top)), area.hole, area.window)) {
            sides->GetPoints()->SetPoint(top, sides->GetPoint(top + 1));
        }
    }
}

constexpr double kLinesAcross = 25.0;
constexpr double kGridOpacity = 0.3;

}  // namespace

/// The terrain at one fineness. Its actors stay in their renderer: to take an actor out makes VTK
/// throw away the shaders of the whole window.
struct TerrainLayer::Mesh {
    vtkNew<vtkAspSurfaceSource> source;
    vtkNew<vtkPolyData> data;
    vtkNew<vtkUnsignedCharArray> rgb;
    vtkNew<vtkPolyData> wallData;
    vtkNew<vtkUnsignedCharArray> wallRgb;
    vtkSmartPointer<vtkDataArray> wallNormals;
    vtkSmartPointer<vtkActor> surface;
    vtkSmartPointer<vtkActor> walls;
    vtkSmartPointer<vtkActor> grid;
    bool built = false;          ///< for the present area
    std::vector<double> values;  ///< of the field at the surface's points
    int fieldNumber = -1;        ///< that they are of

    explicit Mesh(vtkRenderer* renderer) {
        rgb->SetNumberOfComponents(3);
        wallRgb->SetNumberOfComponents(3);
        surface = surfaceAsColored(data);
        walls = surfaceAsColored(wallData);
        vtkNew<vtkPolyData> nothing;
        grid = thinLines(nothing);
        renderer->AddActor(surface);
        renderer->AddActor(walls);
        renderer->AddActor(grid);  // last: it is blended over the others
    }

    void setVisible(bool visible, bool withGrid) const {
        surface->SetVisibility(visible ? 1 : 0);
        walls->SetVisibility(visible ? 1 : 0);
        grid->SetVisibility(visible && withGrid ? 1 : 0);
    }

    /// The values stay until the mesh or the field is another.
    void measure(const BSplineSurface& atRest, const SurfaceColors& colors) {
        if (fieldNumber == colors.fieldNumber()) {
            return;
        }
        fieldNumber = colors.fieldNumber();
        vtkPolyData* sampled = source->GetOutput();
        vtkDataArray* normals = sampled->GetPointData()->GetNormals();
        const vtkIdType count = sampled->GetNumberOfPoints();
        values.resize(static_cast<std::size_t>(count));
        for (vtkIdType id = 0; id < count; ++id) {
            values[static_cast<std::size_t>(id)] =
                valueAt(colors.field(), atRest, Vector3(sampled->GetPoint(id)),
                        Vector3(normals->GetTuple(id)));
        }
    }

    void paint(const TerrainStyle& style) const {
        for (vtkActor* actor : {surface, walls, grid}) {
            style.space.apply(actor);
        }
        vtkPolyData* sampled = source->GetOutput();
        vtkDataArray* normals = sampled->GetPointData()->GetNormals();
        const vtkIdType count = sampled->GetNumberOfPoints();
        rgb->SetNumberOfTuples(count);
        for (vtkIdType id = 0; id < count; ++id) {
            const double value = values[static_cast<std::size_t>(id)];
            const Color color =
                style.colors.isLive() ? style.colors.ofLive(value) : style.colors.ofRest(value);
            rgb->SetTypedTuple(
                id, style.shading.litSurface(color, Vector3(normals->GetTuple(id))).data());
        }
        rgb->Modified();
        paintWalls(style.shading);
    }

    void paintWalls(const Shading& shading) const {
        const vtkIdType count = wallData->GetNumberOfPoints();
        wallRgb->SetNumberOfTuples(count);
        for (vtkIdType id = 0; id < count; ++id) {
            const Vector3 normal(wallNormals->GetTuple(id));
            wallRgb->SetTypedTuple(id,
                                   shading.lit(theme::palette().side, normal, kWallMatt).data());
        }
        wallRgb->Modified();
    }
};

TerrainLayer::TerrainLayer(vtkRenderer* renderer)
    : coarse_(std::make_unique<Mesh>(renderer)), fine_(std::make_unique<Mesh>(renderer)) {
    hide();
}

TerrainLayer::~TerrainLayer() = default;

void TerrainLayer::hide() {
    coarse_->setVisible(false, false);
    fine_->setVisible(false, false);
}

void TerrainLayer::setArea(const BSplineSurface& surface, const TerrainArea& area) {
    surface_ = &surface;
    area_ = area;
    coarse_->built = false;
    fine_->built = false;
    heights_ = {surface.at(area.window.left, area.window.bottom).height, 0.0};
    heights_[1] = heights_[0];
    survey([this](const Vector2& at) {
        const double height = surface_->at(at.x(), at.y()).height;
        heights_ = {std::min(heights_[0], height), std::max(heights_[1], height)};
    });
}

void TerrainLayer::setBottom(double bottom) {
    bottom_ = bottom;
    coarse_->built = false;
    fine_->built = false;
}

void TerrainLayer::show(TerrainDetail detail, const TerrainStyle& style) {
    const int finest = fineSamples();
    const bool fine = detail == TerrainDetail::Fine && finest > kCoarse;
    Mesh& mesh = fine ? *fine_ : *coarse_;
    if (!mesh.built) {
        build(mesh, fine ? finest : std::min(finest, kCoarse));
    }
    mesh.measure(*surface_, style.colors);
    mesh.paint(style);
    fine_->setVisible(fine, style.grid);
    coarse_->setVisible(!fine, style.grid);
}

/// Calls visit(position) for positions spread evenly over the window, edges included.
template <class Visit>
void TerrainLayer::survey(const Visit& visit) const {
    const ScanWindow& window = area_.window;
    for (int row = 0; row < kSurveySamples; ++row) {
        const double y = std::lerp(window.bottom, window.top, row / (kSurveySamples - 1.0));
        for (int column = 0; column < kSurveySamples; ++column) {
            const double x = std::lerp(window.left, window.right, column / (kSurveySamples - 1.0));
            visit(Vector2(x, y));
        }
    }
}

std::vector<double> TerrainLayer::valuesOf(const SurfaceField& field) const {
    std::vector<double> values;
    values.reserve(static_cast<std::size_t>(kSurveySamples) * kSurveySamples);
    survey([&](const Vector2& at) {
        const HeightSample sample = surface_->at(at.x(), at.y());
        values.push_back(
            valueAt(field, *surface_, {at.x(), at.y(), sample.height}, sample.normal()));
    });
    return values;
}

int TerrainLayer::fineSamples() const {
    const BSplineSurface::Grid& grid = surface_->grid();
    const double pixels = widthOf(area_.window) / std::min(grid.pitchX, grid.pitchY);
    return static_cast<int>(std::clamp<double>(kSamplesPerPixel * pixels, kMinSamples, kFine));
}

void TerrainLayer::build(Mesh& mesh, int samples) const {
    const ScanWindow& window = area_.window;
    const ScanWindow& hole = area_.hole;
    mesh.source->SetSurface(surface_);
    mesh.source->SetWindow(window.left, window.right, window.bottom, window.top);
    mesh.source->SetHole(hole.left, hole.right, hole.bottom, hole.top);
    mesh.source->SetResolution(samples, samples);
    mesh.source->Update();
    vtkPolyData* sampled = mesh.source->GetOutput();
    mesh.data->SetPoints(sampled->GetPoints());
    mesh.data->SetStrips(sampled->GetStrips());
    mesh.data->GetPointData()->SetScalars(mesh.rgb);
    const auto sides = blockSides(sampled, {samples, samples}, bottom_);
    openWalls(sides, area_);
    mesh.wallData->SetPoints(sides->GetPoints());
    mesh.wallData->SetStrips(sides->GetStrips());
    mesh.wallData->GetPointData()->SetScalars(mesh.wallRgb);
    mesh.wallNormals = sides->GetPointData()->GetNormals();
    vtkPolyDataMapper::SafeDownCast(mesh.grid->GetMapper())
        ->SetInputData(drapedGrid(std::min(samples, kMaxGridSteps)));
    mesh.built = true;
    mesh.fieldNumber = -1;
}

vtkSmartPointer<vtkPolyData> TerrainLayer::drapedGrid(int stepsAcross) const {
    const ScanWindow& window = area_.window;
    const ScanWindow& patch = area_.patch;
    const double step = widthOf(window) / stepsAcross;
    const double spacing = gridSpacing(widthOf(window));
    const Extent x{window.left, window.right, patch.left, patch.right};
    const Extent y{window.bottom, window.top, patch.bottom, patch.top};
    Polylines grid;
    const auto lay = [&](const TerrainStroke& stroke, bool upwards) {
        const int steps = static_cast<int>(std::ceil((stroke.to - stroke.from) / step));
        std::vector<Vector3> points;
        for (int i = 0; i <= steps; ++i) {
            const double along = std::lerp(stroke.from, stroke.to, static_cast<double>(i) / steps);
            const Vector2 at =
                upwards ? Vector2(stroke.position, along) : Vector2(along, stroke.position);
            points.emplace_back(at.x(), at.y(), surface_->at(at.x(), at.y()).height);
        }
        grid.add(points);
    };
    for (const TerrainStroke& stroke : strokes(x, y, spacing)) {
        lay(stroke, true);
    }
    for (const TerrainStroke& stroke : strokes(y, x, spacing)) {
        lay(stroke, false);
    }
    return grid.data();
}

double gridSpacing(double width) { return niceBelow(width / kLinesAcross); }

std::vector<double> gridPositions(double low, double high, double spacing) {
    std::vector<double> positions;
    for (auto line = std::llround(std::floor(low / spacing)) + 1;; ++line) {
        const double position = static_cast<double>(line) * spacing;
        if (!(position < high)) {
            break;
        }
        positions.push_back(position);
    }
    return positions;
}

vtkSmartPointer<vtkActor> thinLines(vtkPolyData* data) {
    vtkSmartPointer<vtkActor> actor = linesAsDrawn(data, palette::kSurfaceLine, 1.0);
    actor->GetProperty()->SetOpacity(kGridOpacity);
    actor->ForceOpaqueOn();
    return actor;
}

Polylines::Polylines() : data_(vtkSmartPointer<vtkPolyData>::New()) {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    data_->SetPoints(points);
    vtkNew<vtkCellArray> cells;
    data_->SetLines(cells);
}

void Polylines::add(const std::vector<Vector3>& points) {
    vtkCellArray* cells = data_->GetLines();
    cells->InsertNextCell(static_cast<int>(points.size()));
    for (const Vector3& point : points) {
        cells->InsertCellPoint(data_->GetPoints()->InsertNextPoint(point.data()));
    }
}

}  // namespace asperity
