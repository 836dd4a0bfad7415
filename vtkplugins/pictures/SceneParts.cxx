#include "vtkplugins/pictures/SceneParts.h"

#include "vtkplugins/pictures/OffscreenPicture.h"

#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkClipPolyData.h>
#include <vtkCutter.h>
#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkLight.h>
#include <vtkLookupTable.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <utility>

namespace asperity {

namespace {

constexpr double kMargin = 1.04;  // of the view around the scene

constexpr double kLineOffset = -24.0;  // of depth, in VTK's units

const Vector3 kKeyLight(-0.9, 1.0, 0.6);  // rightwards, upwards, to the eye
constexpr double kKeyIntensity = 0.8;
constexpr double kFillIntensity = 0.42;

vtkSmartPointer<vtkActor> actorOf(vtkPolyData* data) {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(data);
    mapper->ScalarVisibilityOff();
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    actor->GetProperty()->SetInterpolationToPhong();
    actor->GetProperty()->SetAmbient(kPlainMatt.ambient);
    actor->GetProperty()->SetDiffuse(kPlainMatt.diffuse);
    actor->GetProperty()->SetSpecular(0.08);
    actor->GetProperty()->SetSpecularPower(20.0);
    return actor;
}

/// One side of a grid's border: its point ids and the way it faces.
struct GridSide {
    std::vector<vtkIdType> ids;
    Vector3 outward;
};

std::array<GridSide, 4> gridSides(GridSize size) {
    std::array<GridSide, 4> sides{{{{}, -Vector3::UnitY()},
                                   {{}, Vector3::UnitY()},
                                   {{}, -Vector3::UnitX()},
                                   {{}, Vector3::UnitX()}}};
    const vtkIdType lastRow = static_cast<vtkIdType>(size.rows - 1) * size.columns;
    for (int column = 0; column < size.columns; ++column) {
        sides[0].ids.push_back(column);
        sides[1].ids.push_back(lastRow + column);
    }
    for (int row = 0; row < size.rows; ++row) {
        const vtkIdType first = static_cast<vtkIdType>(row) * size.columns;
        sides[2].ids.push_back(first);
        sides[3].ids.push_back(first + size.columns - 1);
    }
    return sides;
}

void extendByActors(Eigen::AlignedBox3d& box, const Matrix3& axes, vtkRenderer* view) {
    vtkActorCollection* actors = view->GetActors();
    actors->InitTraversal();
    while (vtkActor* actor = actors->GetNextActor()) {
        vtkDataSet* data = actor->GetMapper()->GetInput();
        for (vtkIdType id = 0; id < data->GetNumberOfPoints(); ++id) {
            box.extend(Vector3(axes.transpose() * Vector3(data->GetPoint(id))));
        }
    }
}

/// Every n-th of `count` positions such that about `wanted` remain, and the last.
std::vector<int> spread(int count, int wanted) {
    std::vector<int> positions;
    const int lines = std::min(count - 1, wanted);
    for (int line = 0; line <= lines; ++line) {
        positions.push_back(line * (count - 1) / lines);
    }
    return positions;
}

vtkSmartPointer<vtkPlane> planeOf(const CutPlane& plane) {
    auto shown = vtkSmartPointer<vtkPlane>::New();
    shown->SetOrigin(plane.origin.data());
    shown->SetNormal(plane.toFront.data());
    return shown;
}

}  // namespace

vtkSmartPointer<vtkActor> coloredSurface(vtkPolyData* data, vtkLookupTable* table) {
    vtkSmartPointer<vtkActor> actor = actorOf(data);
    vtkMapper* mapper = actor->GetMapper();
    mapper->ScalarVisibilityOn();
    mapper->SetLookupTable(table);
    mapper->UseLookupTableScalarRangeOn();
    mapper->InterpolateScalarsBeforeMappingOn();
    return actor;
}

vtkSmartPointer<vtkActor> plainSurface(vtkPolyData* data, const Color& color) {
    vtkSmartPointer<vtkActor> actor = actorOf(data);
    actor->GetProperty()->SetColor(color.fractions().data());
    return actor;
}

vtkSmartPointer<vtkPolyData> blockSides(vtkPolyData* surface, GridSize size, double bottom,
                                        const BlockWalls& walls) {
    const std::array<bool, 4> wanted{walls.front, walls.back, walls.left, walls.right};
    const std::array<GridSide, 4> sides = gridSides(size);
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkFloatArray> normals;
    normals->SetNumberOfComponents(3);
    vtkNew<vtkCellArray> strips;
    for (std::size_t i = 0; i < sides.size(); ++i) {
        const GridSide& side = sides[i];
        if (!wanted[i]) {
            continue;
        }
        strips->InsertNextCell(static_cast<int>(2 * side.ids.size()));
        for (const vtkIdType id : side.ids) {
            const Vector3 top(surface->GetPoint(id));
            strips->InsertCellPoint(points->InsertNextPoint(top.data()));
            strips->InsertCellPoint(points->InsertNextPoint(top.x(), top.y(), bottom));
            normals->InsertNextTuple(side.outward.data());
            normals->InsertNextTuple(side.outward.data());
        }
    }
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points);
    data->SetStrips(strips);
    data->GetPointData()->SetNormals(normals);
    return data;
}

vtkSmartPointer<vtkActor> blockWalls(vtkPolyData* surface, GridSize size, double bottom) {
    return wallSurface(blockSides(surface, size, bottom));
}

vtkSmartPointer<vtkActor> wallSurface(vtkPolyData* data) {
    vtkSmartPointer<vtkActor> actor = plainSurface(data, kLightPalette.side);
    actor->GetProperty()->SetAmbient(kWallMatt.ambient);
    actor->GetProperty()->SetDiffuse(kWallMatt.diffuse);
    return actor;
}

vtkSmartPointer<vtkActor> lines(vtkPolyData* data, const Color& color, double width) {
    return linesAsDrawn(data, color, width * OffscreenPicture::kOversampling);
}

vtkSmartPointer<vtkActor> linesAsDrawn(vtkPolyData* data, const Color& color, double width) {
    vtkSmartPointer<vtkActor> actor = plainSurface(data, color);
    actor->GetProperty()->LightingOff();
    actor->GetProperty()->SetLineWidth(static_cast<float>(width));
    vtkMapper::SetResolveCoincidentTopologyToPolygonOffset();
    // A line is a few pixels wide; on a steep surface its lower half lies that much deeper.
    actor->GetMapper()->SetRelativeCoincidentTopologyLineOffsetParameters(0.0, kLineOffset);
    return actor;
}

vtkSmartPointer<vtkPolyData> polyline(const std::vector<Vector3>& points) {
    vtkNew<vtkPoints> positions;
    positions->SetDataTypeToDouble();
    vtkNew<vtkCellArray> cells;
    cells->InsertNextCell(static_cast<int>(points.size()));
    for (const Vector3& point : points) {
        cells->InsertCellPoint(positions->InsertNextPoint(point.data()));
    }
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(positions);
    data->SetLines(cells);
    return data;
}

vtkSmartPointer<vtkPolyData> drapedGrid(vtkPolyData* surface, GridSize size, int count) {
    vtkNew<vtkCellArray> cells;
    for (const int row : spread(size.rows, count)) {
        cells->InsertNextCell(size.columns);
        for (int c = 0; c < size.columns; ++c) {
            cells->InsertCellPoint(static_cast<vtkIdType>(row) * size.columns + c);
        }
    }
    for (const int column : spread(size.columns, count)) {
        cells->InsertNextCell(size.rows);
        for (int r = 0; r < size.rows; ++r) {
            cells->InsertCellPoint(static_cast<vtkIdType>(r) * size.columns + column);
        }
    }
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(surface->GetPoints());
    data->SetLines(cells);
    return data;
}

void addLights(vtkRenderer* renderer) {
    vtkNew<vtkLight> key;
    key->SetLightTypeToCameraLight();
    key->SetPosition(Vector3(kKeyLight).data());
    key->SetFocalPoint(0.0, 0.0, 0.0);
    key->SetIntensity(kKeyIntensity);
    vtkNew<vtkLight> fill;
    fill->SetLightTypeToHeadlight();
    fill->SetIntensity(kFillIntensity);
    renderer->AutomaticLightCreationOff();
    renderer->AddLight(key);
    renderer->AddLight(fill);
}

double brightness(const Vector3& normal, const Vector3& toLight, const Matt& matt) {
    const double key = kKeyIntensity * std::max(0.0, normal.dot(toLight));
    const double fill = kFillIntensity * std::max(0.0, normal.z());
    return matt.ambient + matt.diffuse * (key + fill);
}

void fitCamera(std::span<vtkRenderer* const> views, const Vector3& direction, double aspect) {
    const Vector3 out = direction.normalized();
    const Vector3 right = Vector3::UnitZ().cross(out).normalized();
    const Vector3 up = out.cross(right);
    Matrix3 axes;
    axes << right, up, out;
    Eigen::AlignedBox3d box;  // of all points, along these axes
    for (vtkRenderer* view : views) {
        extendByActors(box, axes, view);
    }
    const Vector3 focus = axes * box.center();
    const double half = 0.5 * std::max(box.sizes().y(), box.sizes().x() / aspect);
    const double depth = box.sizes().norm();
    vtkNew<vtkCamera> camera;
    camera->ParallelProjectionOn();
    camera->SetParallelScale(half * kMargin);
    camera->SetFocalPoint(focus.data());
    camera->SetPosition(Vector3(focus + depth * out).data());
    camera->SetViewUp(0.0, 0.0, 1.0);
    camera->SetClippingRange(0.1 * depth, 2.0 * depth);
    for (vtkRenderer* view : views) {
        view->SetActiveCamera(camera);
    }
}

vtkSmartPointer<vtkPolyData> Stretch::apply(vtkPolyData* data) const {
    auto stretched = vtkSmartPointer<vtkPolyData>::New();
    stretched->ShallowCopy(data);
    const vtkIdType count = data->GetNumberOfPoints();
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(count);
    vtkNew<vtkFloatArray> normals;
    normals->SetName("Normals");
    normals->SetNumberOfComponents(3);
    normals->SetNumberOfTuples(count);
    vtkDataArray* oldNormals = data->GetPointData()->GetNormals();
    for (vtkIdType id = 0; id < count; ++id) {
        points->SetPoint(id, point(Vector3(data->GetPoint(id))).data());
        if (oldNormals != nullptr) {
            normals->SetTuple(id, normal(Vector3(oldNormals->GetTuple(id))).data());
        }
    }
    stretched->SetPoints(points);
    if (oldNormals != nullptr) {
        stretched->GetPointData()->SetNormals(normals);
    }
    return stretched;
}

vtkSmartPointer<vtkPolyData> behind(vtkPolyData* data, const CutPlane& plane) {
    vtkNew<vtkClipPolyData> clip;
    clip->SetInputData(data);
    clip->SetClipFunction(planeOf(plane));
    clip->InsideOutOn();
    clip->Update();
    return clip->GetOutput();
}

vtkSmartPointer<vtkPolyData> cutLine(vtkPolyData* surface, const CutPlane& plane) {
    vtkNew<vtkCutter> cutter;
    cutter->SetInputData(surface);
    cutter->SetCutFunction(planeOf(plane));
    cutter->Update();
    return cutter->GetOutput();
}

vtkSmartPointer<vtkPolyData> cutFace(vtkPolyData* line, const CutPlane& plane, double bottom) {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkFloatArray> normals;
    normals->SetNumberOfComponents(3);
    vtkNew<vtkCellArray> quads;
    const auto add = [&](const Vector3& point) {
        normals->InsertNextTuple(plane.toFront.data());
        return points->InsertNextPoint(point.data());
    };
    vtkCellArray* segments = line->GetLines();
    for (vtkIdType cell = 0; cell < segments->GetNumberOfCells(); ++cell) {
        vtkIdType count = 0;
        const vtkIdType* ids = nullptr;
        segments->GetCellAtId(cell, count, ids);
        for (vtkIdType i = 0; i + 1 < count; ++i) {
            Vector3 one(line->GetPoint(ids[i]));
            Vector3 other(line->GetPoint(ids[i + 1]));
            if (plane.toFront.dot((other - one).cross(Vector3::UnitZ())) > 0.0) {
                std::swap(one, other);  // its front faces the eye
            }
            const std::array<vtkIdType, 4> corners{add(one), add(other),
                                                   add({other.x(), other.y(), bottom}),
                                                   add({one.x(), one.y(), bottom})};
            quads->InsertNextCell(static_cast<vtkIdType>(corners.size()), corners.data());
        }
    }
    auto face = vtkSmartPointer<vtkPolyData>::New();
    face->SetPoints(points);
    face->SetPolys(quads);
    face->GetPointData()->SetNormals(normals);
    return face;
}

}  // namespace asperity
