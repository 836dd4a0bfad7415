#include "core/io/heightmap/HeightMapWriter.h"

#include "core/Error.h"
#include "core/PrintableText.h"
#include "core/TemporaryFile.h"
#include "core/io/TextValue.h"

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
        throw;  // of the source of the rows
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

void finish(std::ofstream& stream) {
    stream.close();
    if (!stream) {
        throw Error(kStoppedHalfWay);
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

std::string oneLine(std::string text) {
    static constexpr std::string_view kBlanks("\n\r\t\0", 4);
    std::ranges::replace_if(
        text, [](char c) { return kBlanks.find(c) != std::string_view::npos; }, ' ');
    return printable(text);
}

std::map<std::string, std::string> writtenMetadata(const HeightMapMeta& meta, std::size_t most) {
    constexpr std::size_t kMaxBytes = 60000;
    std::size_t total = 0;
    std::map<std::string, std::string> written;
    for (const auto& [given, text] : meta.metadata) {
        const std::string name(trimmed(oneLine(given)));
        const std::string value(trimmed(oneLine(text)));
        const std::size_t bytes = name.size() + value.size();
        const bool fits = !name.empty() && !value.empty() && name.size() <= kMaxBytes &&
                          value.size() <= kMaxBytes && total + bytes <= most;
        if (fits && !name.starts_with("Gwy::") && !name.starts_with("Asperity::")) {
            written.emplace(name, value);
            total += bytes;
        }
    }
    return written;
}

std::string metadataLines(const HeightMapMeta& meta, std::string_view between,
                          std::span<const std::string_view> reserved, std::size_t most) {
    std::string lines;
    for (const auto& [name, value] : writtenMetadata(meta, most)) {
        if (name.find(trimmed(between)) == std::string::npos &&
            std::ranges::count(reserved, name) == 0) {
            lines.append(name).append(between).append(value).append("\n");
        }
    }
    return lines;
}

}  // namespace asperity
