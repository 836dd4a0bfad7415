#include "vtkplugins/pictures/DeformationPicture.h"

#include "core/Error.h"
#include "core/SiFormat.h"
#include "vtkplugins/pictures/DeformationScene.h"
#include "vtkplugins/pictures/Panel.h"
#include "vtkplugins/pictures/Ticks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

namespace asperity {

namespace {

bool isDrawable(const SurfacePatch& patch) {
    if (patch.columns < 2 || patch.rows < 2) {
        return false;
    }
    const std::size_t count = patch.index(patch.rows, 0);
    const std::array<const std::vector<Vector3>*, 3> fields{&patch.rest, &patch.points,
                                                            &patch.normals};
    return std::all_of(fields.begin(), fields.end(), [count](const std::vector<Vector3>* field) {
        return field->size() == count &&
               std::all_of(field->begin(), field->end(),
                           [](const Vector3& vector) { return vector.allFinite(); });
    });
}

void check(const DeformationView& view) {
    const bool isFinite = view.tipCenter.allFinite() && view.contactPoint.allFinite() &&
                          view.force.allFinite() && std::isfinite(view.contactRadius) &&
                          std::isfinite(view.tipRadius);
    if (!isDrawable(view.patch) || !isFinite || !(view.tipRadius > 0.0)) {
        throw Error("The deformation picture \"" + view.title +
                    "\" needs a patch of at least 2 x 2 points with normals and a tip radius above "
                    "zero, all of them finite.");
    }
}

std::vector<LegendEntry> legendOf(const DeformationView& view) {
    std::vector<LegendEntry> entries{
        {kLightPalette.tip, "tip, radius " + formatSi(view.tipRadius, "m")}};
    if (view.contactRadius > 0.0) {
        entries.push_back(
            {palette::kContact, "contact circle, radius " + formatSi(view.contactRadius, "m")});
    }
    if (!view.force.isZero(0.0)) {
        entries.push_back({kLightPalette.force, "force on the tip"});
    }
    return entries;
}

std::string scaleNote(double heightScale) {
    return heightScale == 1.0 ? "Drawn true to scale."
                              : "Heights ×" + tickLabels({heightScale}).front() +
                                    ", of surface, displacement and tip alike.";
}

/// The i-th of `count` panels: side by side, from four on in rows of two. From the picture's lower
/// left.
PixelRect panelArea(std::size_t i, std::size_t count, const PixelRect& picture) {
    const std::size_t columns = count < 4 ? count : 2;
    const std::size_t rows = (count + columns - 1) / columns;
    const double width = picture.width / static_cast<double>(columns);
    const double height = picture.height / static_cast<double>(rows);
    return {static_cast<double>(i % columns) * width,
            static_cast<double>(rows - 1 - i / columns) * height, width, height};
}

}  // namespace

void drawDeformation(OffscreenPicture& picture, std::span<const DeformationView> views,
                     const PictureParts& parts) {
    if (views.empty()) {
        throw Error("The deformation picture needs at least one view.");
    }
    for (const DeformationView& view : views) {
        check(view);
    }
    for (std::size_t i = 0; i < views.size(); ++i) {
        const PanelLayout panel(panelArea(i, views.size(), picture.area()), parts);
        const auto scene =
            std::make_shared<DeformationScene>(picture, views[i], panel.scene(), parts);
        const PanelText text{views[i].title, legendOf(views[i]), scene->colorBar(),
                             views[i].caption + "\n" + scaleNote(scene->heightScale())};
        picture.paint([scene, panel, text](Painter& painter) {
            panel.paint(painter, text);
            scene->paintLabels(painter);
        });
    }
}

void writeDeformationPicture(const std::filesystem::path& path,
                             std::span<const DeformationView> views, PictureSize size) {
    OffscreenPicture picture(size);
    drawDeformation(picture, views);
    picture.writePng(path);
}

}  // namespace asperity
