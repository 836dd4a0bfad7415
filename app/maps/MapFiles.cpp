#include "app/maps/MapFiles.h"

#include "app/program/ProgramParts.h"
#include "core/Error.h"
#include "core/FormattedText.h"
#include "core/SiFormat.h"
#include "core/TemporaryFile.h"
#include "core/Version.h"
#include "core/io/FileBytes.h"
#include "core/io/TextValue.h"
#include "core/io/heightmap/ScanFile.h"
#include "core/io/heightmap/exr/ExrWriter.h"
#include "core/io/heightmap/gwy/GwyWriter.h"
#include "core/io/heightmap/vti/VtiWriter.h"
#include "core/io/scene/SceneFile.h"
#include "core/map/PixelCycle.h"
#include "core/scene/BelievedModel.h"
#include "core/scene/SceneDescription.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <exception>
#include <limits>
#include <map>
#include <utility>

namespace asperity {

namespace {

std::string textOf(const MapPlan& plan) {
    std::string text = std::string(keyOf(plan.mode)) + (plan.truth ? " truth" : " belief");
    for (const double value : {plan.region.left, plan.region.bottom, plan.region.right,
                               plan.region.top, plan.setpoint}) {
        text += " " + exactText(value);
    }
    text += " " + std::to_string(plan.grid.columns) + " " + std::to_string(plan.grid.rows);
    for (const MapQuantity quantity : plan.quantities) {
        text += " " + std::string(keyOf(quantity));
    }
    return text;
}

}  // namespace

std::string mapKey(const LoadedScene& loaded, const MapPlan& plan) {
    SceneDescription scene = settled(loaded.scene.description, loaded.scene.model);
    forEachFile(scene, [](std::string& file) { file.clear(); });  // contents count, not paths
    Sha256 hash;
    for (const std::string& part :
         {versionWithCommit(), loaded.sha256, sceneText(scene), textOf(plan)}) {
        hash.add(part + "\n");
    }
    return hash.digits();
}

namespace {

constexpr const char* kMapKey = "key of the map";

std::map<std::string, std::string> metadataOf(const LoadedScene& loaded, const MapPlan& plan) {
    std::map<std::string, std::string> texts{{"program", std::string("Asperity ") + kVersion},
                                             {"mode", std::string(keyOf(plan.mode))},
                                             {"setpoint", formatSi(plan.setpoint, "N")},
                                             {"instrument", plan.truth ? "true" : "believed"},
                                             {kMapKey, mapKey(loaded, plan)}};
    if (!loaded.sha256.empty()) {
        texts["sha256 of the scan"] = loaded.sha256;
    }
    return texts;
}

/// Name of a channel in a file.
enum class Naming : std::uint8_t { ByKey, ByName };

/// The channels of a map as images, all of the same pixels.
class MapImages {
public:
    MapImages(const LoadedScene& loaded, const MapPlan& plan)
        : plan_(plan)
        , originX_(loaded.originX + plan.region.left)
        , originY_(loaded.originY + plan.region.bottom)
        , metadata_(metadataOf(loaded, plan)) {}

    /// @param remark on the channel; empty: none
    void add(const std::string& title, const char* unit, RowReader readRow,
             const std::string& remark = {}) {
        images_.push_back({.rows = {.columns = plan_.grid.columns,
                                    .rows = plan_.grid.rows,
                                    .pitchX = plan_.pitchX(),
                                    .pitchY = plan_.pitchY(),
                                    .readRow = std::move(readRow)},
                           .meta = {.title = title,
                                    .originX = originX_,
                                    .originY = originY_,
                                    .unit = unit,
                                    .metadata = metadata_}});
        if (!remark.empty()) {
            images_.back().meta.metadata["remark"] = remark;
        }
    }
    [[nodiscard]] std::vector<WrittenImage> take() { return std::move(images_); }

private:
    const MapPlan& plan_;
    double originX_;  ///< of the region in the instrument's frame [m]
    double originY_;  ///< its y [m]
    std::map<std::string, std::string> metadata_;
    std::vector<WrittenImage> images_;
};

std::vector<WrittenImage> imagesOf(const LoadedScene& loaded, const MapPlan& plan,
                                   const MapPart& part, std::span<const ComparedMap> compared,
                                   Naming naming) {
    MapImages images(loaded, plan);
    for (std::size_t i = 0; i < plan.quantities.size(); ++i) {
        const MapQuantityRow& quantity = *rowOf(plan.quantities[i]);
        images.add(
            naming == Naming::ByKey ? quantity.key : quantity.name, quantity.unit,
            [&part, i](int row, double* values) { part.read(row, i, values); },
            unknownDeviations(plan, part, i));
    }
    for (const ComparedMap& map : compared) {
        for (ComparisonLayer& layer : layersOf(map, part)) {
            images.add(naming == Naming::ByKey ? layer.key : layer.name, rowOf(map.quantity)->unit,
                       std::move(layer.readRow));
        }
    }
    return images.take();
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

bool mapFits(const MapPlan& plan, std::size_t compared) {
    constexpr double kChannelAndMask = 2.0 * sizeof(double);
    const double bytes = kChannelAndMask * plan.grid.columns * plan.grid.rows *
                         static_cast<double>(plan.quantities.size() + 2 * compared);
    return bytes <= static_cast<double>(std::numeric_limits<std::uint32_t>::max());
}

void requireMapFits(const MapPlan& plan, std::size_t compared) {
    if (!mapFits(plan, compared)) {
        throw Error("a .gwy file holds at most 4 GiB, and these channels with their masks may need "
                    "more: ask for fewer --quantities, a coarser --grid or a --region");
    }
}

bool holdsMap(const MapFiles& files, const LoadedScene& loaded, const MapPlan& plan) {
    try {
        const ScanFile file(files.gwy());
        return std::ranges::any_of(file.contents().channels, [&](const ScanChannel& channel) {
            const auto found = channel.metadata.find(kMapKey);
            return found != channel.metadata.end() && found->second == mapKey(loaded, plan);
        });
    } catch (const Error&) {
        return false;
    }
}

void writeMapFiles(const MapFiles& files, const LoadedScene& loaded, const MapPlan& plan,
                   const MapPart& part, Progress* progress, std::span<const ComparedMap> compared) {
    const std::vector<WrittenImage> byKey = imagesOf(loaded, plan, part, compared, Naming::ByKey);
    const std::vector<WrittenImage> byName = imagesOf(loaded, plan, part, compared, Naming::ByName);
    ProgressPart first(progress, 0.0, 0.3);
    writeImages(files.vti(), byKey, writeVtiImages, &first);
    ProgressPart second(progress, 0.3, 0.6);
    writeImages(files.exr(), byKey, writeExrImages, &second);
    ProgressPart third(progress, 0.6, 1.0);
    writeImages(files.gwy(), byName, writeGwyImages, &third);
}

std::string unknownDeviations(const MapPlan& plan, const MapPart& part, std::size_t index) {
    if (!isDeviation(plan.quantities[index])) {
        return {};
    }
    std::vector<double> values(static_cast<std::size_t>(plan.grid.columns));
    long unknown = 0;
    long computed = 0;
    for (int row = 0; row < plan.grid.rows; ++row) {
        if (part.has(row)) {
            part.read(row, index, values.data());
            unknown +=
                std::ranges::count_if(values, [](double value) { return std::isnan(value); });
            computed += plan.grid.columns;
        }
    }
    return unknown == 0 ? std::string()
                        : formatted("unknown in %ld of %ld pixels, not 0: several contacts carry "
                                    "there, or there is no such value",
                                    unknown, computed);
}

std::vector<std::string> unknownDeviations(const MapPlan& plan, const MapPart& part) {
    std::vector<std::string> sentences;
    for (std::size_t index = 0; index < plan.quantities.size(); ++index) {
        const std::string sentence = unknownDeviations(plan, part, index);
        if (!sentence.empty()) {
            sentences.push_back(std::string(rowOf(plan.quantities[index])->name) + ": " + sentence);
        }
    }
    return sentences;
}

}  // namespace asperity
