#include "vtkplugins/pictures/OverviewPicture.h"

#include "core/SiFormat.h"
#include "vtkplugins/pictures/OverviewScene.h"
#include "vtkplugins/pictures/Panel.h"
#include "vtkplugins/pictures/Ticks.h"

#include <memory>
#include <vector>

namespace asperity {

namespace {

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
