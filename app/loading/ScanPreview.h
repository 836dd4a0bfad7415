#pragma once

#include "app/loading/SceneLoader.h"
#include "core/io/heightmap/ThinnedMap.h"
#include "core/surface/GivenScale.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace asperity {

/// A channel of a file, for a list of them.
struct PreviewedChannel {
    std::string name;
    std::string unit;       ///< of its values; empty: none given
    std::string direction;  ///< "forward", "backward", or empty
    int columns = 0;
    int rows = 0;
    bool opens = false;  ///< it is a height, or may be one
};

/// Heights with the facts shown of them.
struct PreviewedHeights {
    HeightMap map;  ///< in the channel's unit
    HeightStatistics statistics;
};

/// Content of a file, and what would be opened of it, before it is opened.
struct ScanPreview {
    std::string format;  ///< for people; "shape" without a file
    std::vector<PreviewedChannel> channels;
    std::string channel;  ///< the one that is shown
    std::string unit;     ///< of its values, with the scale that was given; empty: none
    int columns = 0;
    int rows = 0;
    double sizeX = 0.0;           ///< [m]; 0: not known
    double sizeY = 0.0;           ///< [m]; 0: not known
    std::optional<ScaleGap> gap;  ///< missing scale of file and scene, given or not
    GivenScale scale;             ///< that is used
    LevelingSteps leveling;       ///< the same
    std::optional<LevelPoints> levelPoints;
    std::optional<PixelRectangle> crop;
    PreviewedHeights whole;    ///< as the file gives them
    PreviewedHeights part;     ///< of the crop, before leveling; empty: there is none
    PreviewedHeights leveled;  ///< the same, after it
    int step = 1;      ///< distance of the pixels read, along each axis of the whole [pixels]
    int partStep = 1;  ///< of the part
    std::vector<std::string> notes;
    std::vector<Provenance> provenance;
    std::string refusal;  ///< why it cannot be opened so, a sentence; empty: it can, but for a gap
};

/// Looks into files that may be opened. It keeps what it read last, so that other leveling of the
/// same heights is there at once.
class ScanPreviewer {
public:
    ScanPreviewer();
    ~ScanPreviewer();
    ScanPreviewer(const ScanPreviewer&) = delete;
    ScanPreviewer& operator=(const ScanPreviewer&) = delete;

    /// @param input a height map or a scene
    /// @throw InputError where the file or its scene cannot be read; Canceled
    [[nodiscard]] ScanPreview preview(const std::filesystem::path& input,
                                      const SceneOverrides& overrides,
                                      Progress* progress = nullptr);

private:
    struct Source;

    /// All but what leveling makes of it. @param said of the scale, by the scene
    /// @throw InputError; Canceled
    [[nodiscard]] const ScanPreview& readPreview(const SampleDescription& sample,
                                                 const GivenScale& said, Progress* progress);

    std::unique_ptr<Source> source_;
};

}  // namespace asperity
