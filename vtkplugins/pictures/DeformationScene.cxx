#include "vtkplugins/pictures/DeformationScene.h"

#include "core/SiFormat.h"
#include "vtkplugins/module/DeformedTip.h"
#include "vtkplugins/module/vtkAspForceGlyphSource.h"
#include "vtkplugins/module/vtkAspPatchSource.h"
#include "vtkplugins/module/vtkAspTipSource.h"
#include "vtkplugins/pictures/RestingPatch.h"
#include "vtkplugins/pictures/Ticks.h"

#include <vtkActor.h>
#include <vtkLookupTable.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity {

namespace {

const Vector3 kDeformationEye(-0.28, -0.78,
                              0.5);  // from the contact: into the dent, and the neck in profile

// Parts of the patch's width.
constexpr double kSeenDisplacement = 0.012;  // about six pixels
constexpr double kTipHeight = 0.5;
constexpr double kTipRadius = 0.42;  // of the part that is drawn: the surface shows around it
constexpr double kArrowLength = 0.42;
constexpr double kPatchDepth = 0.07;

constexpr int kGridLines = 24;
constexpr double kHiddenOpacity = 0.3;  // of the contact circle behind the surface

/// On a slope the eye looks across it, so that dent, neck and force show from the side.
Vector3 eyeFor(const Vector3& outward) {
    const double tilt = std::hypot(outward.x(), outward.y());
    if (tilt == 0.0) {
        return kDeformationEye;
    }
    constexpr double kPlainSlope = 0.25;  // from here on the slope alone decides
    Vector3 across = Vector3(-outward.y(), outward.x(), 0.0) / tilt;
    across *= across.dot(kDeformationEye) < 0.0 ? -1.0 : 1.0;
    const Vector3 level(kDeformationEye.x(), kDeformationEye.y(), 0.0);
    const double weight = std::min(1.0, tilt / kPlainSlope);
    const Vector3 chosen = (1.0 - weight) * level.normalized() + weight * across;
    return level.norm() * chosen.normalized() + kDeformationEye.z() * Vector3::UnitZ();
}

/// The edge of the flat end of an upright tip.
vtkSmartPointer<vtkPolyData> topEdge(vtkPolyData* tip, const Stretch& stretch) {
    constexpr int kPoints = 160;
    const double* bounds = tip->GetBounds();
    const Vector3 center(0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3]), bounds[5]);
    std::vector<Vector3> edge;
    for (int i = 0; i <= kPoints; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / kPoints;
        edge.push_back(stretch.point(center + 0.5 * (bounds[1] - bounds[0]) *
                                                  Vector3(std::cos(angle), std::sin(angle), 0.0)));
    }
    return polyline(edge);
}

/// Exaggeration of all heights: 1 where the displacement is seen true to scale, else the smallest
/// round factor that shows it; 1 again where none does that leaves the tip its shape.
double heightScaleFor(double displacement, double width) {
    for (const double factor : {1.0, 2.0, 5.0, 10.0}) {
        if (factor * displacement >= kSeenDisplacement * width) {
            return factor;
        }
    }
    return 1.0;
}

/// Returns where the axis of the contact meets the deformed surface.
Vector3 contactOn(const SurfacePatch& patch, const Vector3& point, const Vector3& outward) {
    const RestingPatch resting(patch);
    const Vector3 rest = resting.closest(point, outward);
    return resting.at(patch.points, rest.x(), rest.y());
}

}  // namespace

DeformationScene::DeformationScene(OffscreenPicture& picture, const DeformationView& view,
                                   const PixelRect& area, const PictureParts& parts)
    : picture_(picture)
    , data_(view)
    , area_(area)
    , parts_(parts)
    , solid_(picture.addView(area, 1))
    , through_(picture.addView(area, 2))
    , width_((view.patch.rest.back() - view.patch.rest.front()).head<2>().maxCoeff()) {
    vtkNew<vtkAspPatchSource> source;
    source->SetPatch(view.patch);
    source->Update();
    std::array<double, 2> range{};
    source->GetOutput()->GetScalarRange(range.data());
    const double limit = std::max(std::abs(range[0]), std::abs(range[1]));
    low_ = std::min(range[0], 0.0);
    high_ = limit > 0.0 ? std::max(range[1], 0.0) : 1e-12;
    colors_ = divergingTable(limit > 0.0 ? limit : high_);
    stretch_ = Stretch(view.heightScale.value_or(heightScaleFor(limit, width_)));
    const Vector3 toCenter = view.tipCenter - view.contactPoint;
    outward_ = toCenter.isZero(0.0) ? Vector3::UnitZ() : toCenter.stableNormalized();

    contact_ = stretch_.point(contactOn(view.patch, view.contactPoint, outward_));

    findContactLine();
    addSample(source->GetOutput());
    addTip();
    addContactCircle();
    addForce();
    if (parts.bars) {
        addScaleBars();
    }
    addLights(solid_);
    addLights(through_);
    const std::array<vtkRenderer*, 2> views{solid_, through_};
    fitCamera(views, eyeFor(outward_), area.width / area.height);
}

void DeformationScene::addSample(vtkPolyData* surface) {
    const GridSize size{data_.patch.columns, data_.patch.rows};
    const vtkSmartPointer<vtkPolyData> shown = stretch_.apply(surface);
    bottom_ = shown->GetBounds()[4] - kPatchDepth * width_;
    if (isContactHidden()) {
        const Vector3 eye = eyeFor(outward_);
        cut_ = {contact_, Vector3(eye.x(), eye.y(), 0.0).normalized()};
        addCutFace(shown);
    }
    const auto left = [this](vtkPolyData* data) {
        return cut_ ? behind(data, *cut_) : vtkSmartPointer<vtkPolyData>(data);
    };
    solid_->AddActor(coloredSurface(left(shown), colors_));
    solid_->AddActor(wallSurface(left(blockSides(shown, size, bottom_))));
    if (!parts_.surfaceGrid) {
        return;
    }
    const vtkSmartPointer<vtkActor> grid =
        lines(left(drapedGrid(shown, size, kGridLines)), kLightPalette.ink, 0.7);
    grid->GetProperty()->SetOpacity(0.35);
    solid_->AddActor(grid);
}

void DeformationScene::addCutFace(vtkPolyData* surface) {
    const vtkSmartPointer<vtkPolyData> edge = cutLine(surface, *cut_);
    solid_->AddActor(wallSurface(cutFace(edge, *cut_, bottom_)));
    solid_->AddActor(lines(edge, kLightPalette.ink, 1.2));
    const Vector3 right = Vector3::UnitZ().cross(cut_->toFront);
    double first = 0.0;
    double last = 0.0;
    for (vtkIdType i = 0; i < edge->GetNumberOfPoints(); ++i) {
        const double along = right.dot(Vector3(edge->GetPoint(i)) - cut_->origin);
        first = std::min(first, along);
        last = std::max(last, along);
    }
    const Vector3 middle(cut_->origin.x(), cut_->origin.y(), bottom_);
    cutLeft_ = middle + first * right;
    cutRight_ = middle + last * right;
}

void DeformationScene::findContactLine() {
    if (!(data_.contactRadius > 0.0)) {
        return;
    }
    contactLine_ = contactCircle(data_.patch, {data_.contactPoint, outward_, data_.contactRadius});
    for (std::vector<Vector3>& piece : contactLine_) {
        std::ranges::transform(piece, piece.begin(),
                               [this](const Vector3& point) { return stretch_.point(point); });
    }
}

bool DeformationScene::isHidden(const RestingPatch& sample, const Vector3& point) const {
    constexpr int kSteps = 100;
    const Vector3 eye = eyeFor(outward_);
    const Vector3 way = eye / std::hypot(eye.x(), eye.y());  // over a level way of 1
    for (int i = 1; i <= kSteps; ++i) {
        const Vector3 seen = point + (i * width_ / kSteps) * way;
        const Vector3 above = sample.at(data_.patch.points, seen.x(), seen.y());
        if (stretch_.point(above).z() > seen.z() + kSeenDisplacement * width_) {
            return true;
        }
    }
    return false;
}

bool DeformationScene::isContactHidden() const {
    constexpr double kMuch = 0.25;  // of the contact's edge
    const RestingPatch sample(data_.patch);
    const Vector3 rest = sample.closest(data_.contactPoint, outward_);
    if (outward_.dot(data_.contactPoint - rest) >= 0.0) {
        return false;  // a neck stands out of the sample
    }
    long points = 0;
    long hidden = 0;
    for (const std::vector<Vector3>& piece : contactLine_) {
        points += static_cast<long>(piece.size());
        hidden += std::ranges::count_if(
            piece, [&](const Vector3& point) { return isHidden(sample, point); });
    }
    return points > 0 ? static_cast<double>(hidden) > kMuch * static_cast<double>(points)
                      : isHidden(sample, contact_);
}

/// From the apex, in the world: no wider than the patch, and no higher than the picture has room,
/// but out of the hole that it makes.
double DeformationScene::shownTipHeight() const {
    constexpr double kOutOfHole = 0.1;  // of the patch's width
    const double apex = data_.tipCenter.z() - data_.tipRadius;
    const double deep = RestingPatch(data_.patch).closest(data_.contactPoint, outward_).z() - apex;
    const double highest = std::max(kTipHeight * width_ / stretch_.factor(),
                                    deep + (kOutOfHole * width_ / stretch_.factor()));
    const double wide = kTipRadius * width_;
    const double radius = data_.tipRadius;
    if (data_.paraboloidReach > 0.0) {
        return std::min(highest, 0.5 * wide * wide / radius);
    }
    return wide < radius ? std::min(highest, radius - std::sqrt(radius * radius - wide * wide))
                         : highest;
}

void DeformationScene::addTip() {
    vtkNew<vtkAspTipSource> tip;
    tip->SetRadius(data_.tipRadius);
    tip->SetHalfAngle(data_.shankHalfAngle);
    tip->SetParaboloidReach(data_.paraboloidReach);
    tip->SetCenter(data_.tipCenter.x(), data_.tipCenter.y(), data_.tipCenter.z());
    tip->SetHeight(shownTipHeight());
    tip->SetResolution(160);
    tip->Update();
    vtkNew<vtkPolyData> deformed;
    deformed->DeepCopy(tip->GetOutput());
    deformTip(*deformed, data_.tipCenter, outward_, data_.tipDisplacement);
    const vtkSmartPointer<vtkPolyData> shown = stretch_.apply(deformed);
    solid_->AddActor(lines(topEdge(tip->GetOutput(), stretch_), kLightPalette.tip, 1.2));
    for (const bool back : {true, false}) {  // the far wall first: it shows through the near one
        const vtkSmartPointer<vtkActor> wall = plainSurface(shown, kLightPalette.tip);
        wall->GetProperty()->SetFrontfaceCulling(back ? 1 : 0);
        wall->GetProperty()->SetBackfaceCulling(back ? 0 : 1);
        wall->GetProperty()->SetOpacity(0.34);
        wall->GetProperty()->SetSpecular(0.4);
        solid_->AddActor(wall);
    }
}

void DeformationScene::addContactCircle() {
    for (const std::vector<Vector3>& piece : contactLine_) {
        const vtkSmartPointer<vtkPolyData> line = polyline(piece);
        solid_->AddActor(lines(line, palette::kContact, 2.2));
        const vtkSmartPointer<vtkActor> hidden = lines(line, palette::kContact, 2.2);
        hidden->GetProperty()->SetOpacity(kHiddenOpacity);
        through_->AddActor(hidden);
    }
}

void DeformationScene::addForce() {
    forceEnd_ = contact_;
    const double magnitude = data_.force.stableNorm();
    if (!(magnitude > 0.0)) {
        return;
    }
    const double scale = kArrowLength * width_ / magnitude;
    forceEnd_ += scale * data_.force;
    vtkNew<vtkAspForceGlyphSource> arrow;
    arrow->SetContactPoint(contact_.x(), contact_.y(), contact_.z());
    arrow->SetForce(data_.force.x(), data_.force.y(), data_.force.z());
    arrow->SetMetersPerNewton(scale);
    arrow->SetResolution(48);
    arrow->Update();
    if (arrow->GetOutput()->GetNumberOfPoints() > 0) {
        through_->AddActor(plainSurface(arrow->GetOutput(), kLightPalette.force));
    }
}

void DeformationScene::addScaleBars() {
    const Vector3& low = data_.patch.rest.front();
    const Vector3& high = data_.patch.rest.back();
    const double gap = 0.05 * width_;
    const Vector3 eye = eyeFor(outward_);
    const Vector3 right = Vector3(-eye.y(), eye.x(), 0.0).normalized();
    if (cut_) {
        addHorizontalBar(cutLeft_ + gap * cut_->toFront, right);
        addVerticalBar(cutRight_, right);
        return;
    }
    const double frontX = eye.x() < 0.0 ? low.x() : high.x();
    const double frontY = eye.y() < 0.0 ? low.y() : high.y();

    // Along the lower edge that faces the eye most, from its left end.
    const bool alongX = std::abs(right.x()) >= std::abs(right.y());
    const Vector3 along = alongX ? Vector3(std::copysign(1.0, right.x()), 0.0, 0.0)
                                 : Vector3(0.0, std::copysign(1.0, right.y()), 0.0);
    const Vector3 outside = alongX ? Vector3(0.0, std::copysign(gap, eye.y()), 0.0)
                                   : Vector3(std::copysign(gap, eye.x()), 0.0, 0.0);
    const Vector3 leftEnd = alongX ? Vector3(right.x() > 0.0 ? low.x() : high.x(), frontY, bottom_)
                                   : Vector3(frontX, right.y() > 0.0 ? low.y() : high.y(), bottom_);
    addHorizontalBar(leftEnd + outside, along);

    // Beside the rightmost lower corner.
    addVerticalBar(Vector3(right.x() > 0.0 ? high.x() : low.x(),
                           right.y() > 0.0 ? high.y() : low.y(), bottom_),
                   right);
}

void DeformationScene::addHorizontalBar(const Vector3& start, const Vector3& along) {
    horizontalBar_ = niceBelow(0.3 * width_);
    const Vector3 end = start + horizontalBar_ * along;
    horizontalBarAt_ = 0.5 * (start + end);
    solid_->AddActor(lines(polyline({start, end}), kLightPalette.ink, 3.0));
}

void DeformationScene::addVerticalBar(const Vector3& corner, const Vector3& right) {
    verticalBar_ = niceBelow(0.2 * width_ / stretch_.factor());
    const Vector3 rise = stretch_.factor() * verticalBar_ * Vector3::UnitZ();
    constexpr double kLabelRoom = 0.09;  // of the width: half of the label lies on the block's side
    const Vector3 closest = corner + kLabelRoom * width_ * right;
    const Vector3 top = closest + rise;
    verticalBarAt_ = top;
    solid_->AddActor(lines(polyline({closest, top}), kLightPalette.ink, 3.0));
}

void DeformationScene::paintLabels(Painter& painter) const {
    const auto position = [this](const Vector3& point, double right, double up) {
        const PixelPoint at = picture_.project(solid_, point);
        return PixelPoint{at.x + right, at.y + up};
    };
    if (parts_.bars) {
        painter.text(position(horizontalBarAt_, 0.0, -26.0), formatSi(horizontalBar_, "m"),
                     {.align = Align::Center});
        painter.text(position(verticalBarAt_, 0.0, 16.0), formatSi(verticalBar_, "m"),
                     {.align = Align::Center});
    }
    const double magnitude = data_.force.stableNorm();
    if (parts_.labels && magnitude > 0.0) {
        painter.label(position(forceEnd_, 16.0, 0.0), formatSi(magnitude, "N"),
                      {.size = 20.0, .bold = true, .color = kLightPalette.force}, area_);
    }
}

ColorBar DeformationScene::colorBar() const { return {"displacement", "m", low_, high_, colors_}; }

}  // namespace asperity
