#include "core/io/heightmap/HeightMapWriter.h"

#include "core/Error.h"
#include "core/TemporaryFile.h"
#include "core/io/TextValue.h"
#include "core/io/heightmap/HeightMapEncoders.h"

#include <algorithm>

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

/// The file appears whole or not at all.
/// @param write (path of the file to write)
template <class Write>
void writeWhole(const std::filesystem::path& path, const Write& write) {
    const TemporaryFile temporary(path);
    try {
        write(temporary.path());
    } catch (const Canceled&) {
        throw;
    } catch (const InputError&) {
        throw;  // of what is read meanwhile
    } catch (const std::exception& error) {
        throw Error(path.string() + ": cannot be written: " + error.what());
    }
    temporary.commit();
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

std::string writeAllRefusal(const std::filesystem::path& path) {
    const HeightMapFormat* const format = findFormat(path, kHeightMapFormats);
    if (format != nullptr && format->writeAll != nullptr) {
        return "";
    }
    std::string text = path.string() + ": a file of this type holds one image; several go into";
    for (const HeightMapFormat* each : kHeightMapFormats) {
        if (each->writeAll != nullptr) {
            text.append(" ").append(each->extensions.front());
        }
    }
    return text;
}

void writeHeightMap(const std::filesystem::path& path, const HeightRows& map,
                    const HeightMapMeta& meta, Progress* progress, HeightMapFormats formats) {
    const HeightMapFormat* const format = findFormat(path, formats);
    if (format == nullptr) {
        throw Error(writeRefusal(path, formats));
    }
    writeWhole(path, [&](const std::filesystem::path& target) {
        format->write(target, map, meta, progress);
    });
}

void writeHeightMaps(const std::filesystem::path& path, std::span<const WrittenImage> images,
                     Progress* progress) {
    if (const std::string refusal = writeAllRefusal(path); !refusal.empty()) {
        throw Error(refusal);
    }
    writeWhole(path, [&](const std::filesystem::path& target) {
        findFormat(path, kHeightMapFormats)->writeAll(target, images, progress);
    });
}

void writeHeightMap(const std::filesystem::path& path, const HeightMap& map,
                    const HeightMapMeta& meta) {
    writeHeightMap(path, rowsOf(map), meta);
}

}  // namespace asperity
