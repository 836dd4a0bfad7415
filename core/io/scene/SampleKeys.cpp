#include "core/io/scene/SampleKeys.h"

#include "core/io/scene/NamedChoice.h"
#include "core/io/scene/SceneKeys.h"
#include "core/scene/SceneFieldOf.h"
#include "core/surface/fit/GaussianFilter.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace asperity {

namespace {

constexpr const char* kShape = "shape";
constexpr const char* kCrop = "crop_px";
constexpr const char* kLevel = "level";
constexpr const char* kPoints = "level_points_m";
constexpr const char* kSmoothing = "smoothing_px";
constexpr const char* kSmoothingLength = "smoothing_m";

std::optional<PixelRectangle> readCrop(TomlSection& section) {
    const std::vector<std::int64_t> given = section.integers(kCrop);
    if (!section.has(kCrop)) {
        return std::nullopt;
    }
    constexpr std::size_t kNumbers = 4;
    const auto isPixel = [](std::int64_t number) {
        return number >= 0 && number <= std::numeric_limits<int>::max();
    };
    if (given.size() != kNumbers || !std::ranges::all_of(given, isPixel) || given[2] == 0 ||
        given[3] == 0) {
        section.refuse(kCrop,
                       "[column, row, columns, rows]: the first from 0 at the upper left, and how "
                       "many of each");
    }
    return PixelRectangle{.column = static_cast<int>(given[0]),
                          .row = static_cast<int>(given[1]),
                          .columns = static_cast<int>(given[2]),
                          .rows = static_cast<int>(given[3])};
}

LevelingSteps stepsOf(const TomlSection& section, const std::vector<std::string>& texts) {
    if (texts.size() == 1 && texts.front() == kNoLeveling) {
        return {};
    }
    LevelingSteps steps;
    for (const std::string& text : texts) {
        const auto step = fromKey<LevelingStep>(text);
        if (!step) {
            section.refuse(kLevel, text == kNoLeveling
                                       ? "'none' alone, or a list of steps without it"
                                       : "steps of " + levelingKeys() + ", not '" + text + "'");
        }
        steps.push_back(*step);
    }
    return steps;
}

void readLeveling(TomlSection& section, SampleDescription& sample) {
    if (const auto texts = section.texts(kLevel)) {
        sample.leveling = stepsOf(section, *texts);
    }
    const std::vector<Vector2> places = section.places(kPoints);
    if (!section.has(kPoints)) {
        return;
    }
    LevelPoints points;
    if (places.size() != points.size()) {
        section.refuse(kPoints, "three places, [[x, y], [x, y], [x, y]]");
    }
    std::ranges::copy(places, points.begin());
    sample.levelPoints = points;
}

/// By pixels or by length; kLeftOpen leaves it to the program.
void readSmoothing(TomlSection& section, SceneDescription& scene) {
    section.allow(kSmoothing);
    const SceneField& length = sceneField(SceneGroup::Sample, kSmoothingLength);
    if (section.has(kSmoothingLength) && section.has(kSmoothing)) {
        section.refuse(kSmoothingLength, "one of smoothing_px and smoothing_m, not both");
    }
    if (section.has(kSmoothingLength)) {
        scene.sample.smoothingLength = readNumber(section, length, 0.0);
        scene.sample.smoothingPixels = 0.0;
        return;
    }
    section.allow(kSmoothingLength);
    if (!section.has(kSmoothing)) {
        return;
    }
    const bool isText = section.isText(kSmoothing);
    if (isText && section.text(kSmoothing, "") == kLeftOpen) {
        scene.sample.smoothingPixels.reset();
        return;
    }
    const double pixels = isText ? -1.0 : section.number(kSmoothing, 0.0);
    if (!isWithin(pixels, 0.0, kMaxSmoothing)) {
        section.refuse(kSmoothing, "a number from 0 to 100, or \"auto\"");
    }
    scene.sample.smoothingPixels = pixels;
}

void readMapKeys(TomlSection& section, SceneDescription& scene) {
    if (section.path("file").empty()) {
        section.refuse("file", "the path of a height map, or 'shape' in its place");
    }
    if (section.has("size_x_m") != section.has("size_y_m")) {
        section.refuse(section.has("size_x_m") ? "size_y_m" : "size_x_m",
                       "both sides of the scan, size_x_m and size_y_m");
    }
    readKeys(section, SceneGroup::Sample, scene);
    scene.sample.crop = readCrop(section);
    readLeveling(section, scene.sample);
    readSmoothing(section, scene);
}

/// The window of a shape is as wide as its radius unless the file says otherwise.
void readShapeKeys(TomlSection& section, SceneDescription& scene) {
    ShapeDescription& shape = scene.sample.shape.emplace();
    shape.kind = choice(section, kShape, shape.kind);
    readKeys(section, SceneGroup::Shape, scene);
    if (!section.has("shape_size_m")) {
        shape.size = shape.radius;
    }
}

toml::array pairOf(const Vector2& point) { return toml::array{point.x(), point.y()}; }

void insertLeveling(const SampleDescription& sample, toml::table& table) {
    if (sample.leveling.size() == 1) {
        table.insert(kLevel, keyOf(sample.leveling.front()));
    } else if (sample.leveling.empty()) {
        table.insert(kLevel, kNoLeveling);
    } else {
        toml::array steps;
        for (const LevelingStep step : sample.leveling) {
            steps.push_back(keyOf(step));
        }
        table.insert(kLevel, std::move(steps));
    }
    if (sample.levelPoints) {
        const auto& [first, second, third] = *sample.levelPoints;
        table.insert(kPoints, toml::array{pairOf(first), pairOf(second), pairOf(third)});
    }
}

void insertSmoothing(const SampleDescription& sample, toml::table& table) {
    if (sample.smoothingLength != 0.0) {
        table.insert(kSmoothingLength, sample.smoothingLength);
    } else if (sample.smoothingPixels) {
        table.insert(kSmoothing, *sample.smoothingPixels);
    } else {
        table.insert(kSmoothing, kLeftOpen);
    }
}

}  // namespace

void readSampleKeys(TomlSection& section, SceneDescription& scene) {
    if (!section.has(kShape)) {
        readMapKeys(section, scene);
    } else if (section.has("file")) {
        section.refuse(kShape, "a shape or a height map ('file'), not both");
    } else {
        readShapeKeys(section, scene);
    }
}

void insertSampleKeys(const SceneDescription& scene, toml::table& table) {
    const SampleDescription& sample = scene.sample;
    if (sample.shape) {
        table.insert(kShape, keyOf(sample.shape->kind));
        insertKeys(SceneGroup::Shape, scene, table);
        return;
    }
    insertKeys(SceneGroup::Sample, scene, table);
    if (sample.crop) {
        table.insert(kCrop, toml::array{sample.crop->column, sample.crop->row, sample.crop->columns,
                                        sample.crop->rows});
    }
    insertLeveling(sample, table);
    insertSmoothing(sample, table);
}

}  // namespace asperity
