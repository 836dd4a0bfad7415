#include "core/io/heightmap/HeightMapWriter.h"

#include "core/Error.h"
#include "core/TemporaryFile.h"
#include "core/io/TextValue.h"
#include "core/io/heightmap/HeightMapEncoders.h"

#include <algorithm>
#include <fstream>
#include <limits>

namespace asperity {

namespace {

/// Null when no format that is written has the path's extension.
const HeightMapFormat* findFormat(const std::filesystem::path& path, HeightMapFormats formats) {
    const std::string extension = lowerCase(path.extension().string());
    for (const HeightMapFormat* format : formats) {
        if (format->write != nullptr && std::ranges::count(format->extensions, extension) > 0) {
            return format;
        }
    }
    return nullptr;
}

}  // namespace

std::vector<std::string> heightMapExtensions(HeightMapFormats formats) {
    std::vector<std::string> extensions;
    for (const HeightMapFormat* format : formats) {
        if (format->write != nullptr) {
            extensions.insert(extensions.end(), format->extensions.begin(),
                              format->extensions.end());
        }
    }
    return extensions;
}

std::string writeRefusal(const std::filesystem::path& path, HeightMapFormats formats) {
    if (findFormat(path, formats) != nullptr) {
        return "";
    }
    std::string text =
        path.string() + ": no height map can be written with this extension; known are";
    for (const std::string& extension : heightMapExtensions(formats)) {
        text += " " + extension;
    }
    return text;
}

void writeHeightMap(const std::filesystem::path& path, const HeightRows& map,
                    const HeightMapMeta& meta, Progress* progress, HeightMapFormats formats) {
    const HeightMapFormat* const format = findFormat(path, formats);
    if (format == nullptr) {
        throw Error(writeRefusal(path, formats));
    }
    const TemporaryFile temporary(path);
    try {
        format->write(temporary.path(), map, meta, progress);
    } catch (const Canceled&) {
        throw;
    } catch (const std::exception& error) {
        throw Error(path.string() + ": cannot be written: " + error.what());
    }
    temporary.commit();
}

void writeHeightMap(const std::filesystem::path& path, const HeightMap& map,
                    const HeightMapMeta& meta) {
    writeHeightMap(path, rowsOf(map), meta);
}

void finish(std::ofstream& stream) {
    stream.close();
    if (!stream) {
        throw Error("writing stopped half-way (disk full?)");
    }
}

HeightRange heightRange(const HeightRows& map, Progress* progress) {
    HeightRange range{std::numeric_limits<double>::infinity(),
                      -std::numeric_limits<double>::infinity(), 0};
    bool isEmpty = true;
    forEachRow(map, progress, [&](int, const std::vector<double>& heights) {
        for (const double height : heights) {
            if (isFiniteHeight(height)) {
                range.lowest = std::min(range.lowest, height);
                range.highest = std::max(range.highest, height);
                isEmpty = false;
            } else {
                ++range.missing;
            }
        }
    });
    if (isEmpty) {
        range.lowest = range.highest = 0.0;
    }
    return range;
}

}  // namespace asperity
