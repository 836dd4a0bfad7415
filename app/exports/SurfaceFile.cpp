#include "app/exports/SurfaceFile.h"

#include "app/exports/CurveTables.h"
#include "core/io/fields/PatchExr.h"
#include "vtkplugins/io/VtkFormats.h"

namespace asperity {

HeightMapFormats surfaceFormats() {
    static const std::vector<const HeightMapFormat*> all = [] {
        std::vector<const HeightMapFormat*> list(kHeightMapFormats.begin(),
                                                 kHeightMapFormats.end());
        list.insert(list.end(), kVtkFormats.begin(), kVtkFormats.end());
        return list;
    }();
    return HeightMapFormats(all);
}

std::vector<std::string> surfaceExtensions() {
    std::vector<std::string> extensions;
    for (const HeightMapFormat* const format : surfaceFormats()) {
        if (format->write != nullptr) {
            extensions.emplace_back(format->extensions.front());
        }
    }
    return extensions;
}

void writeField(const std::filesystem::path& path, const SurfacePatch& patch, ExportFormat format) {
    switch (format) {
    case ExportFormat::Exr:
        return writePatchExr(path, patch);
    case ExportFormat::Vtp:
        return writePatchVtp(path, patch);
    case ExportFormat::Vts:
        return writePatchVts(path, patch);
    default:
        return writePatchTable(path, patch);
    }
}

}  // namespace asperity
