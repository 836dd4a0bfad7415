#include "core/io/HeightMapWriter.h"

#include "core/Error.h"
#include "core/TemporaryFile.h"
#include "core/io/HeightMapEncoders.h"
#include "core/io/ScanImage.h"
#include "core/io/TextValue.h"

#include <algorithm>
#include <array>
#include <limits>

namespace asperity {

namespace {

using Writer = void (*)(const std::filesystem::path&, const HeightMap&, const HeightMapMeta&);

struct Format {
    const char* extension;
    Writer write;
};

constexpr std::array<Format, 7> kFormats = {{{".gwy", writeGwy},
                                             {".gsf", writeGsf},
                                             {".exr", writeExr},
                                             {".tiff", writeTiff},
                                             {".tif", writeTiff},
                                             {".png", writePng},
                                             {".txt", writeText}}};

Writer findWriter(const std::filesystem::path& path) {
    const std::string extension = lowerCase(path.extension().string());
    const auto* const found =
        std::find_if(kFormats.begin(), kFormats.end(),
                     [&](const Format& format) { return format.extension == extension; });
    return found == kFormats.end() ? nullptr : found->write;
}

std::string knownExtensions() {
    std::string text;
    for (const std::string& extension : heightMapExtensions()) {
        text += (text.empty() ? "" : " ") + extension;
    }
    return text;
}

}  // namespace

const std::vector<std::string>& heightMapExtensions() {
    static const std::vector<std::string> kExtensions = [] {
        std::vector<std::string> extensions;
        extensions.reserve(kFormats.size());
        for (const Format& format : kFormats) {
            extensions.emplace_back(format.extension);
        }
        return extensions;
    }();
    return kExtensions;
}

bool canWriteHeightMap(const std::filesystem::path& path) { return findWriter(path) != nullptr; }

void writeHeightMap(const std::filesystem::path& path, const HeightMap& map,
                    const HeightMapMeta& meta) {
    const Writer write = findWriter(path);
    if (write == nullptr) {
        throw Error(path.string() +
                    ": no height map can be written with this extension; known are " +
                    knownExtensions());
    }
    requireUsable(map);
    HeightMap marked = map;
    invalidateNonFinite(marked);
    const TemporaryFile temporary(path);
    try {
        write(temporary.path(), marked, meta);
    } catch (const std::exception& error) {
        throw Error(path.string() + ": cannot be written: " + error.what());
    }
    temporary.commit();
}

void writeBytes(const std::filesystem::path& target, const std::string& bytes) {
    std::ofstream stream(target, std::ios::binary);
    stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    stream.close();
    if (!stream) {
        throw Error("writing stopped half-way (disk full?)");
    }
}

HeightRange heightRange(const HeightMap& map) {
    HeightRange range{std::numeric_limits<double>::infinity(),
                      -std::numeric_limits<double>::infinity()};
    for (std::size_t i = 0; i < map.heights.size(); ++i) {
        const bool valid = map.invalid.empty() || map.invalid[i] == 0;
        if (!valid) {
            continue;
        }
        range.lowest = std::min(range.lowest, map.heights[i]);
        range.highest = std::max(range.highest, map.heights[i]);
    }
    return range.lowest <= range.highest ? range : HeightRange{};
}

std::vector<float> floatHeights(const HeightMap& map) {
    std::vector<float> heights(map.heights.size());
    for (std::size_t i = 0; i < heights.size(); ++i) {
        const bool valid = map.invalid.empty() || map.invalid[i] == 0;
        heights[i] =
            valid ? static_cast<float>(map.heights[i]) : std::numeric_limits<float>::quiet_NaN();
    }
    return heights;
}

}  // namespace asperity
