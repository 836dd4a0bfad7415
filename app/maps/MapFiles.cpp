#include "app/maps/MapFiles.h"

#include "core/Error.h"
#include "core/SiFormat.h"
#include "core/TemporaryFile.h"
#include "core/Version.h"
#include "core/io/heightmap/exr/ExrWriter.h"
#include "core/io/heightmap/gwy/GwyWriter.h"
#include "core/io/heightmap/vti/VtiWriter.h"

#include <exception>
#include <limits>
#include <map>
#include <span>

namespace asperity {

namespace {

using Title = const char* MapQuantityRow::*;

std::map<std::string, std::string> metadataOf(const LoadedScene& loaded, const MapPlan& plan) {
    std::map<std::string, std::string> texts{{"program", std::string("Asperity ") + kVersion},
                                             {"mode", std::string(keyOf(plan.mode))},
                                             {"setpoint", formatSi(plan.setpoint, "N")},
                                             {"instrument", plan.truth ? "true" : "believed"}};
    if (!loaded.sha256.empty()) {
        texts["sha256 of the scan"] = loaded.sha256;
    }
    return texts;
}

/// The quantities of a map as images.
/// @param title by name, for people, or by key
std::vector<WrittenImage> imagesOf(const LoadedScene& loaded, const MapPlan& plan,
                                   const MapPart& part, Title title) {
    std::vector<WrittenImage> images;
    for (std::size_t i = 0; i < plan.quantities.size(); ++i) {
        const MapQuantityRow& quantity = *rowOf(plan.quantities[i]);
        images.push_back(
            {.rows = {.columns = plan.grid.columns,
                      .rows = plan.grid.rows,
                      .pitchX = plan.pitchX(),
                      .pitchY = plan.pitchY(),
                      .readRow = [&part, i](int row,
                                            double* values) { part.read(row, i, values); }},
             .meta = {.title = quantity.*title,
                      .originX = plan.region.left,
                      .originY = plan.region.bottom,
                      .unit = quantity.unit,
                      .metadata = metadataOf(loaded, plan)}});
    }
    return images;
}

using ImagesWriter = void (*)(const std::filesystem::path&, std::span<const WrittenImage>,
                              Progress*);

void writeImages(const std::filesystem::path& path, std::span<const WrittenImage> images,
                 ImagesWriter write, Progress* progress) {
    const TemporaryFile temporary(path);
    try {
        write(temporary.path(), images, progress);
    } catch (const Canceled&) {
        throw;
    } catch (const std::exception& error) {
        throw Error(path.string() + ": cannot be written: " + error.what());
    }
    temporary.commit();
}

}  // namespace

bool mapFits(const MapPlan& plan) {
    constexpr double kChannelAndMask = 2.0 * sizeof(double);
    const double bytes = kChannelAndMask * plan.grid.columns * plan.grid.rows *
                         static_cast<double>(plan.quantities.size());
    return bytes <= static_cast<double>(std::numeric_limits<std::uint32_t>::max());
}

void requireMapFits(const MapPlan& plan) {
    if (!mapFits(plan)) {
        throw Error("a .gwy file holds at most 4 GiB, and these channels with their masks may need "
                    "more: ask for fewer --quantities, a coarser --grid or a --region");
    }
}

void writeMapFiles(const MapFiles& files, const LoadedScene& loaded, const MapPlan& plan,
                   const MapPart& part, Progress* progress) {
    const std::vector<WrittenImage> byKey = imagesOf(loaded, plan, part, &MapQuantityRow::key);
    const std::vector<WrittenImage> byName = imagesOf(loaded, plan, part, &MapQuantityRow::name);
    ProgressPart first(progress, 0.0, 0.3);
    writeImages(files.vti(), byKey, writeVtiImages, &first);
    ProgressPart second(progress, 0.3, 0.6);
    writeImages(files.exr(), byKey, writeExrImages, &second);
    ProgressPart third(progress, 0.6, 1.0);
    writeImages(files.gwy(), byName, writeGwyImages, &third);
}

}  // namespace asperity
