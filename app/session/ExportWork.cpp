#include "app/session/ExportWork.h"

#include "app/exports/CurveTables.h"
#include "app/exports/FieldFile.h"
#include "app/exports/PictureFile.h"
#include "app/exports/PlotFile.h"
#include "app/exports/SurfaceFile.h"
#include "app/reports/ContactView.h"
#include "core/io/heightmap/HeightMapWriter.h"
#include "core/surface/measure/Roughness.h"

#include <utility>

namespace asperity {

namespace {

ExportFormat formatOf(const ExportOrder& order) {
    return formatOf("a." + order.format.toStdString(), viewOf(order.subject));
}

void writePlot(const ExportOrder& order, const ExportMoment& moment) {
    const ExportFormat format = formatOf(order);
    const std::vector<Chart> charts = chartsOf(moment, order.subject);
    if (format != ExportFormat::Csv) {
        writePlotPage(order.path, charts, order.spec, format);
    } else if (order.subject == ExportSubject::Forces) {
        writeForcesTable(order.path, moment.ticks);
    } else {
        writeForceCurvesTable(order.path, charts.front().curves, moment.distance);
    }
}

}  // namespace

ExportView viewOf(ExportSubject subject) {
    switch (subject) {
    case ExportSubject::Forces:
        return ExportView::Forces;
    case ExportSubject::Cycle:
        return ExportView::Cycle;
    case ExportSubject::Deformation:
        return ExportView::Deformation;
    default:
        return ExportView::Spatial;
    }
}

ExportWork pictureWork(const ExportOrder& order, RasterImage image) {
    return [order, image = std::move(image)](Progress&) {
        writePicture(order.path, image, formatOf(order), order.spec.dpi);
    };
}

ExportWork dataWork(const ExportOrder& order, std::shared_ptr<const ExportMoment> moment) {
    return [order, moment = std::move(moment)](Progress& progress) {
        const Scene& scene = moment->loaded->scene;
        if (order.subject == ExportSubject::Deformation) {
            writeField(order.path, zoomPatch(scene, moment->sample, moment->patch),
                       formatOf(order));
        } else if (order.subject == ExportSubject::Surface) {
            writeHeightMap(order.path, rowsOf(scene.surface), {.title = moment->name}, &progress,
                           surfaceFormats());
        } else {
            writePlot(order, *moment);
        }
    };
}

}  // namespace asperity
