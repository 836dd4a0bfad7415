#include "app/exports/FieldFile.h"

#include "app/exports/CurveTables.h"
#include "core/io/fields/PatchExr.h"
#include "vtkplugins/io/PatchFormats.h"

namespace asperity {

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
