#include "core/io/heightmap/exr/ExrAttribute.h"

#include "core/Error.h"

#include <algorithm>
#include <array>

// Source: openexr.com, "OpenEXR File Layout", Attribute Layout.

namespace asperity {

namespace {

struct TypeSize {
    std::string_view type;
    std::uint64_t bytes;
};

constexpr std::array kFixed{TypeSize{"box2f", 16},
                            TypeSize{"box2i", 16},
                            TypeSize{"chromaticities", 32},
                            TypeSize{"compression", 1},
                            TypeSize{"deepImageState", 1},
                            TypeSize{"double", 8},
                            TypeSize{"envmap", 1},
                            TypeSize{"float", 4},
                            TypeSize{"int", 4},
                            TypeSize{"keycode", 28},
                            TypeSize{"lineOrder", 1},
                            TypeSize{"m33d", 72},
                            TypeSize{"m33f", 36},
                            TypeSize{"m44d", 128},
                            TypeSize{"m44f", 64},
                            TypeSize{"rational", 8},
                            TypeSize{"tiledesc", 9},
                            TypeSize{"timecode", 8},
                            TypeSize{"v2d", 16},
                            TypeSize{"v2f", 8},
                            TypeSize{"v2i", 8},
                            TypeSize{"v3d", 24},
                            TypeSize{"v3f", 12},
                            TypeSize{"v3i", 12}};

/// Takes a list of channels: names with 16 bytes after each, ended by an empty one.
/// @return how many there are @throw InputError when it does not end
std::size_t takeChannels(ByteReader& reader) {
    constexpr std::uint64_t kChannelBytes = 16;
    std::size_t count = 0;
    while (!reader.takeName("a channel's name").empty()) {
        (void)reader.take(kChannelBytes, "a channel");
        ++count;
    }
    return count;
}

bool isChannelList(const ByteSource& bytes, const ByteSpan& value) {
    try {
        ByteReader reader(bytes, value);
        (void)takeChannels(reader);
        return reader.atEnd();
    } catch (const InputError&) {
        return false;
    }
}

/// Columns, rows and four bytes for each pixel.
bool isPreview(const ByteSource& bytes, const ByteSpan& value) {
    constexpr std::uint64_t kSizeBytes = 8;
    constexpr std::uint64_t kPixelBytes = 4;
    if (value.count < kSizeBytes) {
        return false;
    }
    const std::uint64_t columns = numberIn<std::uint32_t>(bytes, {value.place, 4});
    const std::uint64_t rows = numberIn<std::uint32_t>(bytes, {value.place + 4, 4});
    const std::uint64_t pixels = (value.count - kSizeBytes) / kPixelBytes;
    const bool fits = rows == 0 || columns <= pixels / rows;
    return fits && value.count == kSizeBytes + columns * rows * kPixelBytes;
}

}  // namespace

bool fitsExrType(const ByteSource& bytes, std::string_view type, const ByteSpan& value) {
    if (type == "chlist") {
        return isChannelList(bytes, value);
    }
    if (type == "preview") {
        return isPreview(bytes, value);
    }
    const auto* const fixed = std::ranges::find(kFixed, type, &TypeSize::type);
    return fixed == kFixed.end() || fixed->bytes == value.count;
}

std::size_t exrChannelCount(const ByteSource& bytes, const ByteSpan& value) {
    ByteReader reader(bytes, value);
    return takeChannels(reader);
}

}  // namespace asperity
