#include "app/loading/ScanPreview.h"

#include "core/Error.h"
#include "core/io/heightmap/ImageScale.h"
#include "core/io/heightmap/ScanFile.h"
#include "core/io/scene/SceneFile.h"
#include "core/scene/ShapeSample.h"
#include "core/surface/leveling/Leveling.h"

#include <algorithm>
#include <system_error>
#include <utility>

namespace asperity {

namespace {

std::filesystem::file_time_type timeOf(const std::filesystem::path& file) {
    std::error_code unknown;
    return std::filesystem::last_write_time(file, unknown);
}

/// Any channel, of a name or the default one: it is looked at, too, where it cannot be opened.
const ScanChannel& channelToShow(const ScanFile& file, const std::filesystem::path& path,
                                 const std::string& name) {
    const HeightMapFile& contents = file.contents();
    return name.empty() ? contents.channels.at(contents.defaultChannel)
                        : channelNamed(contents, path, name);
}

/// Lists, of several with one name, the one that the name opens.
std::vector<PreviewedChannel> channelsOf(const HeightMapFile& file,
                                         const std::filesystem::path& path) {
    std::vector<PreviewedChannel> channels;
    for (const ScanChannel& channel : file.channels) {
        if (&channelNamed(file, path, channel.name) == &channel) {
            channels.push_back({.name = channel.name,
                                .unit = channel.unit,
                                .direction = channel.direction,
                                .columns = channel.map.columns,
                                .rows = channel.map.rows,
                                .opens = channel.isHeight() || mayBeTopography(channel)});
        }
    }
    return channels;
}

PreviewedHeights heightsOf(HeightMap map) {
    const HeightStatistics statistics = heightStatistics(map);
    return {std::move(map), statistics};
}

/// Why a channel cannot be opened, but for a scale that is missing.
std::string channelRefusal(const HeightMapFile& file, const std::filesystem::path& path,
                           const std::string& name) {
    try {
        (void)heightChannel(file, path, name);
    } catch (const MissingScale&) {
        return {};
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

/// Makes pixels of unknown size 1 m wide, for leveling.
HeightMap levelable(HeightMap map) {
    if (!(map.pitchX > 0.0 && map.pitchY > 0.0)) {
        map.pitchX = 1.0;
        map.pitchY = 1.0;
    }
    return map;
}

/// Says why where it cannot.
void level(ScanPreview& preview, Progress* progress) {
    try {
        preview.leveled = heightsOf(
            leveled(levelable(preview.part.map), preview.leveling, preview.levelPoints, progress));
    } catch (const Error& error) {
        preview.refusal = error.what();
    }
}

ScanPreview shapePreview(const SampleDescription& sample) {
    ScanPreview preview;
    preview.format = "shape";
    preview.unit = "m";
    preview.whole = heightsOf(shapeMap(*sample.shape));
    preview.columns = preview.whole.map.columns;
    preview.rows = preview.whole.map.rows;
    preview.sizeX = preview.whole.map.sizeX();
    preview.sizeY = preview.whole.map.sizeY();
    preview.leveled = preview.whole;
    preview.notes = {"the sample is an exact shape; there is nothing to level"};
    return preview;
}

}  // namespace

/// Data read of a file.
struct ScanPreviewer::Source {
    std::filesystem::path path;
    std::filesystem::file_time_type time;
    std::string channel;  ///< as it was asked for
    GivenScale said;      ///< by the scene
    GivenScale scale;     ///< that is used
    std::optional<PixelRectangle> crop;
    ScanPreview preview;  ///< but for leveling

    [[nodiscard]] bool isOf(const SampleDescription& sample, const GivenScale& byScene) const {
        return path == sample.file && time == timeOf(path) && channel == sample.channel &&
               said == byScene && scale == sample.scale && crop == sample.crop;
    }
    /// @throw InputError; Canceled
    void read(Progress* progress);

private:
    void describe(const HeightMapFile& file, const ScanChannel& shown);
    /// Returns the missing scale, if any; none where the channel cannot be opened anyway.
    [[nodiscard]] std::optional<ScaleGap> findGap() const;
};

void ScanPreviewer::Source::describe(const HeightMapFile& file, const ScanChannel& shown) {
    preview.format = file.format;
    preview.channels = channelsOf(file, path);
    preview.channel = shown.name;
    preview.unit = shown.unit;
    preview.columns = shown.map.columns;
    preview.rows = shown.map.rows;
    preview.sizeX = shown.hasSize() ? shown.map.sizeX() : 0.0;
    preview.sizeY = shown.hasSize() ? shown.map.sizeY() : 0.0;
    preview.notes = notesOn(file, shown);
    preview.provenance = provenanceOf(file, shown);
    preview.scale = scale;
    const bool isAll = crop == PixelRectangle{0, 0, preview.columns, preview.rows};
    preview.crop = isAll ? std::nullopt : crop;
    preview.refusal = channelRefusal(file, path, channel);
    if (preview.crop && preview.refusal.empty()) {
        preview.refusal = cropRefusal(shown, *preview.crop);
    }
}

std::optional<ScaleGap> ScanPreviewer::Source::findGap() const {
    const ScanFile file(path, said);
    try {
        (void)heightChannel(file.contents(), path, channel);
    } catch (const MissingScale& missing) {
        return missing.gap();
    } catch (const InputError&) {  // reported as the refusal
    }
    return std::nullopt;
}

void ScanPreviewer::Source::read(Progress* progress) {
    const ScanFile file(path, scale);
    const ScanChannel& shown = channelToShow(file, path, channel);
    describe(file.contents(), shown);
    preview.gap = findGap();
    ProgressPart reading(progress, 0.0, 0.6);
    ThinnedMap whole = thinnedMap(file, shown, {0, 0, preview.columns, preview.rows}, &reading);
    preview.step = whole.step;
    preview.whole = heightsOf(std::move(whole.map));
    if (!preview.refusal.empty()) {
        return;
    }
    preview.partStep = preview.step;
    preview.part = preview.whole;
    if (preview.crop) {
        ProgressPart again(progress, 0.6, 0.8);
        ThinnedMap part = thinnedMap(file, shown, *preview.crop, &again);
        preview.partStep = part.step;
        preview.part = heightsOf(std::move(part.map));
    }
}

ScanPreviewer::ScanPreviewer() = default;
ScanPreviewer::~ScanPreviewer() = default;

const ScanPreview& ScanPreviewer::readPreview(const SampleDescription& sample,
                                              const GivenScale& said, Progress* progress) {
    if (source_ && source_->isOf(sample, said)) {
        return source_->preview;
    }
    source_.reset();  // first, so that two of them are never in memory
    auto source = std::make_unique<Source>(Source{.path = sample.file,
                                                  .time = timeOf(sample.file),
                                                  .channel = sample.channel,
                                                  .said = said,
                                                  .scale = sample.scale,
                                                  .crop = sample.crop,
                                                  .preview = {}});
    source->read(progress);
    source_ = std::move(source);
    return source_->preview;
}

ScanPreview ScanPreviewer::preview(const std::filesystem::path& input,
                                   const SceneOverrides& overrides, Progress* progress) {
    const SampleDescription said = sceneFromInput(input).sample;
    if (said.shape) {
        return shapePreview(said);
    }
    const SampleDescription sample = withOverrides(said, overrides);
    ScanPreview preview = readPreview(sample, said.scale, progress);
    preview.leveling = sample.leveling;
    preview.levelPoints = sample.levelPoints;
    if (preview.refusal.empty()) {
        ProgressPart leveling(progress, 0.8, 1.0);
        level(preview, &leveling);
    }
    return preview;
}

}  // namespace asperity
