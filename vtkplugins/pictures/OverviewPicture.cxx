#include "vtkplugins/pictures/OverviewPicture.h"

#include "core/SiFormat.h"
#include "vtkplugins/module/vtkAspSurfaceSource.h"
#include "vtkplugins/pictures/OffscreenPicture.h"
#include "vtkplugins/pictures/Panel.h"
#include "vtkplugins/pictures/SceneParts.h"
#include "vtkplugins/pictures/Ticks.h"

#include <vtkActor.h>
#include <vtkDataArray.h>
#include <vtkLookupTable.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkSphereSource.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>

namespace asperity {

namespace {

/// The 3-D part of the overview picture, and what its labels need to know.
class OverviewScene {
public:
    /// @param picture, view live as long as this
    OverviewScene(OffscreenPicture& picture, const OverviewView& view, const PixelRect& area,
                  const PictureParts& parts);

    /// Label of the scale bar.
    void paintLabels(Painter& painter) const;
    [[nodiscard]] ColorBar colorBar() const;
    /// Returns the vertical exaggeration of heights; 1: to scale.
    [[nodiscard]] double magnification() const { return magnification_; }
    /// Returns whether the scan holds no data somewhere.
    [[nodiscard]] bool hasFilled() const { return hasFilled_; }

private:
    void addSurface();
    void markFilled(vtkPolyData* surface);
    void addZoomFrame();
    void addPath();
    void addPin();
    void addScaleBar();
    /// A colored line with a light rim, plain to see on any background.
    static void addRimmedLine(vtkRenderer* view, const std::vector<Vector3>& points,
                              const Color& color);
    /// Just above the drawn surface, straight from one position to another.
    [[nodiscard]] std::vector<Vector3> draped(double fromX, double fromY, double toX,
                                              double toY) const;

    const OffscreenPicture& picture_;
    const OverviewView& data_;
    PictureParts parts_;
    vtkRenderer* solid_;    ///< the surface and what it may hide
    vtkRenderer* through_;  ///< pin and zoom, which nothing hides
    vtkSmartPointer<vtkLookupTable> colors_;
    double side_ = 0.0;  ///< longer side of the scan [m]
    double low_ = 0.0;   ///< heights shown [m]
    double high_ = 0.0;
    double magnification_ = 1.0;
    bool hasFilled_ = false;
    double bottom_ = 0.0;    ///< of the drawn block, world z [m]
    double scaleBar_ = 0.0;  ///< length that it shows [m]
    Vector3 scaleBarAt_ = Vector3::Zero();
};

const Vector3 kOverviewEye(-0.38, -0.78, 0.52);  // from the scan's middle

constexpr int kMaxSamples = 512;

// Parts of the scan's longer side.
constexpr double kShownRelief = 0.15;
constexpr double kPinHeight = 0.2;
constexpr double kPinHead = 0.012;
constexpr double kCrossHair = 0.03;
constexpr double kLift = 0.003;
constexpr double kScanDepth = 0.04;
constexpr double kPathCeiling = 0.22;

OverviewScene::OverviewScene(OffscreenPicture& picture, const OverviewView& view,
                             const PixelRect& area, const PictureParts& parts)
    : picture_(picture)
    , data_(view)
    , parts_(parts)
    , solid_(picture.addView(area, 1))
    , through_(picture.addView(area, 2))
    , side_(std::max(view.surface.sizeX(), view.surface.sizeY())) {
    addSurface();
    addZoomFrame();
    addPath();
    addPin();
    if (parts.bars) {
        addScaleBar();
    }
    addLights(solid_);
    addLights(through_);
    const std::array<vtkRenderer*, 2> views{solid_, through_};
    fitCamera(views, kOverviewEye, area.width / area.height);
}

void OverviewScene::addSurface() {
    const BSplineSurface& surface = data_.surface;
    const GridSize size{std::clamp(surface.grid().columns, 2, kMaxSamples),
                        std::clamp(surface.grid().rows, 2, kMaxSamples)};
    vtkNew<vtkAspSurfaceSource> source;
    source->SetSurface(&surface);
    source->SetWindow(0.0, surface.sizeX(), 0.0, surface.sizeY());
    source->SetResolution(size.columns, size.rows);
    source->Update();
    std::array<double, 2> range{};
    source->GetOutput()->GetScalarRange(range.data());
    low_ = range[0];
    high_ = range[1] > range[0] ? range[1] : range[0] + 1e-12;
    const double wanted = range[1] > range[0] ? kShownRelief * side_ / (high_ - low_) : 1.0;
    magnification_ = data_.heightScale.value_or(wanted >= 2.0 ? niceBelow(wanted) : 1.0);
    bottom_ = magnification_ * low_ - kScanDepth * side_;
    colors_ = heightTable(low_, high_);
    markFilled(source->GetOutput());
    const auto drawn = Stretch(magnification_).apply(source->GetOutput());
    solid_->AddActor(coloredSurface(drawn, colors_));
    solid_->AddActor(blockWalls(drawn, size, bottom_));
}

void OverviewScene::markFilled(vtkPolyData* surface) {
    vtkDataArray* heights = surface->GetPointData()->GetScalars();
    for (vtkIdType id = 0; id < surface->GetNumberOfPoints(); ++id) {
        const double* position = surface->GetPoint(id);
        if (!data_.surface.isMeasured(position[0], position[1])) {
            heights->SetTuple1(id, std::numeric_limits<double>::quiet_NaN());
            hasFilled_ = true;
        }
    }
    const std::array<double, 3> gray = palette::kNoData.fractions();
    colors_->SetNanColor(gray[0], gray[1], gray[2], 1.0);
}

std::vector<Vector3> OverviewScene::draped(double fromX, double fromY, double toX,
                                           double toY) const {
    constexpr int kSteps = 96;
    std::vector<Vector3> points;
    for (int step = 0; step <= kSteps; ++step) {
        const double part = static_cast<double>(step) / kSteps;
        const double x = std::lerp(fromX, toX, part);
        const double y = std::lerp(fromY, toY, part);
        points.emplace_back(x, y, magnification_ * data_.surface.at(x, y).height + kLift * side_);
    }
    return points;
}

void OverviewScene::addRimmedLine(vtkRenderer* view, const std::vector<Vector3>& points,
                                  const Color& color) {
    const vtkSmartPointer<vtkPolyData> line = polyline(points);
    view->AddActor(lines(line, kLightPalette.paper, 4.4));
    view->AddActor(lines(line, color, 2.2));
}

void OverviewScene::addZoomFrame() {
    if (!data_.zoom) {
        return;
    }
    const ScanWindow& zoom = *data_.zoom;
    std::vector<Vector3> frame = draped(zoom.left, zoom.bottom, zoom.right, zoom.bottom);
    for (const auto& side : {draped(zoom.right, zoom.bottom, zoom.right, zoom.top),
                             draped(zoom.right, zoom.top, zoom.left, zoom.top),
                             draped(zoom.left, zoom.top, zoom.left, zoom.bottom)}) {
        frame.insert(frame.end(), side.begin(), side.end());
    }
    addRimmedLine(through_, frame, kLightPalette.zoom);
}

void OverviewScene::addPath() {
    const double ceiling = magnification_ * high_ + kPathCeiling * side_;
    const double floor = magnification_ * low_ - kPathCeiling * side_;
    std::vector<Vector3> run;  // of neighboring points below the ceiling
    const auto finish = [this, &run] {
        if (run.size() > 1) {
            addRimmedLine(solid_, run, kLightPalette.path);
        }
        run.clear();
    };
    for (const Vector3& point : data_.path) {
        const double height = magnification_ * point.z();
        if (height >= floor && height <= ceiling) {
            run.emplace_back(point.x(), point.y(), height + kLift * side_);
        } else {
            finish();
        }
    }
    finish();
}

void OverviewScene::addPin() {
    if (!data_.tip || !data_.tip->allFinite()) {
        return;
    }
    const double x = data_.tip->x();
    const double y = data_.tip->y();
    const double arm = kCrossHair * side_;
    if (!data_.zoom) {  // whose frame shows the position already
        addRimmedLine(through_, draped(x - arm, y, x + arm, y), kLightPalette.marker);
        addRimmedLine(through_, draped(x, y - arm, x, y + arm), kLightPalette.marker);
    }
    const Vector3 closest(x, y, magnification_ * data_.surface.at(x, y).height);
    const Vector3 head = closest + kPinHeight * side_ * Vector3::UnitZ();
    through_->AddActor(lines(polyline({closest, head}), kLightPalette.marker, 2.5));
    vtkNew<vtkSphereSource> ball;
    ball->SetCenter(head.x(), head.y(), head.z());
    ball->SetRadius(kPinHead * side_);
    ball->SetThetaResolution(48);
    ball->SetPhiResolution(32);
    ball->Update();
    through_->AddActor(plainSurface(ball->GetOutput(), kLightPalette.marker));
}

void OverviewScene::addScaleBar() {
    scaleBar_ = niceBelow(0.3 * data_.surface.sizeX());
    const Vector3 start(0.0, -0.04 * side_, bottom_);
    const Vector3 end = start + scaleBar_ * Vector3::UnitX();
    scaleBarAt_ = 0.5 * (start + end);
    solid_->AddActor(lines(polyline({start, end}), kLightPalette.ink, 3.0));
}

void OverviewScene::paintLabels(Painter& painter) const {
    if (parts_.bars) {
        const PixelPoint at = picture_.project(solid_, scaleBarAt_);
        painter.text({at.x, at.y - 20.0}, formatSi(scaleBar_, "m"), {.align = Align::Center});
    }
}

ColorBar OverviewScene::colorBar() const { return {"height", "m", low_, high_, colors_}; }

std::vector<LegendEntry> legendOf(const OverviewView& view, bool hasFilled) {
    std::vector<LegendEntry> entries;
    if (view.tip) {
        entries.push_back({kLightPalette.marker, "tip", LegendMark::Point});
    }
    if (view.path.size() > 1) {
        entries.push_back({kLightPalette.path, "path of the tip"});
    }
    if (view.zoom) {
        const ScanWindow& zoom = *view.zoom;
        entries.push_back({kLightPalette.zoom, "zoom, " + formatSi(zoom.right - zoom.left, "m") +
                                                   " × " + formatSi(zoom.top - zoom.bottom, "m")});
    }
    if (hasFilled) {
        entries.push_back({palette::kNoData, "no data: filled in", LegendMark::Point});
    }
    return entries;
}

std::string scaleNote(const BSplineSurface& surface, double magnification) {
    const std::string size =
        "Scan " + formatSi(surface.sizeX(), "m") + " × " + formatSi(surface.sizeY(), "m") + ". ";
    if (magnification == 1.0) {
        return size + "Drawn to scale.";
    }
    return size + "Heights are drawn ×" + tickLabels({magnification}).front() + ".";
}

}  // namespace

void drawOverview(OffscreenPicture& picture, const OverviewView& view, const PictureParts& parts) {
    const PanelLayout panel(picture.area(), parts);
    const auto scene = std::make_shared<const OverviewScene>(picture, view, panel.scene(), parts);
    const PanelText text{view.title, legendOf(view, scene->hasFilled()), scene->colorBar(),
                         view.caption + "\n" + scaleNote(view.surface, scene->magnification())};
    picture.paint([scene, panel, text](Painter& painter) {
        panel.paint(painter, text);
        scene->paintLabels(painter);
    });
}

void writeOverviewPicture(const std::filesystem::path& path, const OverviewView& view,
                          PictureSize size) {
    OffscreenPicture picture(size);
    drawOverview(picture, view);
    picture.writePng(path);
}

}  // namespace asperity
