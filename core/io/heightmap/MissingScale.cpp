#include "core/io/heightmap/MissingScale.h"

#include <string>

namespace asperity {

namespace {

/// With the options and the keys of a scene that say it.
std::string missingText(const ScaleGap& gap) {
    const std::string size = "the size of the scan (say it by --size, or size_x_m and size_y_m in "
                             "a scene)";
    const std::string height = "the unit of its values (say it by --z-unit and --z-scale, or "
                               "z_scale_m in a scene)";
    const std::string isMask =
        gap.mask ? "this is a mask, not heights (material_mask of a scene takes it); " : "";
    if (gap.size && gap.height) {
        return isMask + "the file holds neither " + size + " nor " + height;
    }
    return isMask + "the file does not hold " + (gap.size ? size : height);
}

}  // namespace

MissingScale::MissingScale(const std::filesystem::path& path, const ScaleGap& gap)
    : InputError(path.string(), "channel '" + gap.channel + "'", missingText(gap))
    , path_(path)
    , gap_(gap) {}

void requireScale(const ScanChannel& channel, const std::filesystem::path& path) {
    const ScaleGap gap{.channel = channel.name,
                       .columns = channel.map.columns,
                       .rows = channel.map.rows,
                       .size = !channel.hasSize(),
                       .height = channel.unit.empty(),
                       .mask = channel.unit.empty() && channel.isMask};
    if (gap.size || gap.height) {
        throw MissingScale(path, gap);
    }
}

}  // namespace asperity
