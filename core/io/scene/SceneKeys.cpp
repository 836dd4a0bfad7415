#include "core/io/scene/SceneKeys.h"

#include "core/Error.h"
#include "core/PrintableText.h"
#include "core/io/scene/TomlFile.h"
#include "core/scene/SceneFieldChange.h"
#include "core/scene/SceneFieldOf.h"
#include "core/scene/SettingFields.h"
#include "core/surface/fit/GaussianFilter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace asperity {

namespace {

std::string readChoice(TomlSection& section, const SceneField& field) {
    std::string given = section.text(field.key, "");
    if (!field.choices.empty() &&
        std::ranges::find(field.choices, given, &SceneChoice::key) == field.choices.end()) {
        std::string known;
        for (const SceneChoice& choice : field.choices) {
            known += (known.empty() ? "" : ", ") + choice.key;
        }
        section.refuse(field.key, "one of " + known + ", not '" + given + "'");
    }
    return given;
}

SceneValue readValue(TomlSection& section, const SceneField& field) {
    switch (field.input) {
    case SceneInput::Number:
        return readNumber(section, field, 0.0);
    case SceneInput::Whole:
        return static_cast<double>(section.count(field.key, 0));
    case SceneInput::Switch:
        return section.flag(field.key, false);
    case SceneInput::File:
        return section.path(field.key).string();
    default:
        return readChoice(section, field);
    }
}

/// Here and not with the other ranges: a description holds whole numbers only.
int readButton(TomlSection& section, const char* key, int otherwise) {
    const double button = section.number(key, otherwise);
    if (!(button >= kNoButton && button <= kLastButton) || button != std::floor(button)) {
        section.refuse(key, "a whole number from 0 to 31, or -1 for none");
    }
    return static_cast<int>(button);
}

template <class Value>
Value readSetting(TomlSection& section, const char* key, Value otherwise) {
    if constexpr (HasEnumTable<Value>) {
        return choice(section, key, otherwise);
    } else if constexpr (std::is_same_v<Value, int>) {
        return readButton(section, key, otherwise);
    } else {
        return static_cast<Value>(section.number(key, otherwise));
    }
}

/// A direction of any length; one of unit length keeps its bits.
Vector3 unitAxis(const TomlSection& section, const Vector3& axis) {
    const double length = axis.stableNorm();
    if (!(length > 0.0 && std::isfinite(length))) {
        section.refuse("guide_axis_z", "with guide_axis_x and guide_axis_y a direction, not 0");
    }
    const bool isUnit = std::abs(length - 1.0) <= 4.0 * std::numeric_limits<double>::epsilon();
    return isUnit ? axis : Vector3(axis / length);
}

double requiredNumber(TomlSection& section, const char* key) {
    if (!section.has(key)) {
        section.refuse(key, "the marker's position, in meters");
    }
    return section.number(key, 0.0);
}

Marker readMarker(const toml::table& table, const std::filesystem::path& path) {
    TomlSection section(table, path, "");
    Marker marker;
    marker.name = section.text("name", "");
    marker.x = requiredNumber(section, "x_m");
    marker.y = requiredNumber(section, "y_m");
    section.refuseUnknownKeys();
    return marker;
}

constexpr const char* kMask = "material_mask";

/// One that a single quantity has.
struct MapKey {
    const char* key;
    const char* number;  ///< key of the same quantity where it is the same everywhere
    std::optional<MapSource> MaterialSources::*source;
};
constexpr std::array<MapKey, 3> kMaps{{
    {"youngs_modulus_map", "youngs_modulus_pa", &MaterialSources::youngsModulus},
    {"work_of_adhesion_map", "work_of_adhesion_j_m2", &MaterialSources::workOfAdhesion},
    {"friction_map", "friction_coefficient", &MaterialSources::friction},
}};

MapSource readSource(TomlSection& section) {
    MapSource source{.file = section.path("file").string(),
                     .channel = section.text("channel", ""),
                     .sha256 = section.text("sha256", "")};
    if (source.file.empty()) {
        section.refuse("file", "the path of a file with the map");
    }
    return source;
}

/// A number of a material that must be there.
double required(TomlSection& numbers, const char* key) {
    if (!numbers.has(key)) {
        numbers.refuse(key, "a number");
    }
    return readNumber(numbers, sceneField(SceneGroup::Material, key), 0.0);
}

/// A material file, or its three numbers.
MaskedMaterial readMasked(TomlSection& mask, const char* key, const MaterialReader& read) {
    if (mask.isText(key)) {
        return read(mask.path(key));
    }
    std::optional<TomlSection> numbers = mask.table(key);
    if (!numbers) {
        mask.refuse(key, "a material file, or a table with the three numbers of a material");
    }
    const MaskedMaterial material{.youngsModulus = required(*numbers, "youngs_modulus_pa"),
                                  .workOfAdhesion = required(*numbers, "work_of_adhesion_j_m2"),
                                  .frictionCoefficient =
                                      required(*numbers, "friction_coefficient")};
    numbers->refuseUnknownKeys();
    return material;
}

toml::table sourceTable(const MapSource& source) {
    toml::table table{{"file", pathText(source.file)}};
    if (!source.channel.empty()) {
        table.insert("channel", source.channel);
    }
    if (!source.sha256.empty()) {
        table.insert("sha256", source.sha256);
    }
    table.is_inline(true);
    return table;
}

toml::table maskedTable(const MaskedMaterial& material) {
    toml::table table{{"youngs_modulus_pa", material.youngsModulus},
                      {"work_of_adhesion_j_m2", material.workOfAdhesion},
                      {"friction_coefficient", material.frictionCoefficient}};
    table.is_inline(true);
    return table;
}

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
    const std::vector<Vector2> positions = section.positions(kPoints);
    if (!section.has(kPoints)) {
        return;
    }
    LevelPoints points;
    if (positions.size() != points.size()) {
        section.refuse(kPoints, "three points, [[x, y], [x, y], [x, y]]");
    }
    std::ranges::copy(positions, points.begin());
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
        section.refuse("file", "the path of a height map, or 'shape' instead");
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

double readNumber(TomlSection& section, const SceneField& field, double otherwise) {
    const double value = section.number(field.key, otherwise);
    if (section.has(field.key) && !field.limits.hold(value)) {
        section.complain(field.key, std::string("must ") + field.limits.words);
    }
    return value;
}

void readKey(TomlSection& section, const SceneField& field, SceneDescription& scene) {
    section.allow(field.key);
    if (section.has(field.key)) {
        field.set(scene, readValue(section, field));
    }
}

void readKeys(TomlSection& section, SceneGroup group, SceneDescription& scene) {
    for (const SceneField& field : sceneFields()) {
        if (field.group != group || field.ownForm) {
            continue;
        }
        const std::string idle = whyNotOfSample(field, scene);
        if (section.has(field.key) && !idle.empty()) {
            section.complain(field.key, idle);
        }
        readKey(section, field, scene);
    }
}

void insertKey(const SceneField& field, const SceneDescription& scene, toml::table& table) {
    if (field.isStated != nullptr && !field.isStated(scene)) {
        return;
    }
    const SceneValue value = field.get(scene);
    if (const auto* const number = std::get_if<double>(&value)) {
        if (field.input == SceneInput::Whole) {
            table.insert(field.key, static_cast<std::int64_t>(*number));
        } else {
            table.insert(field.key, *number);
        }
    } else if (const auto* const on = std::get_if<bool>(&value)) {
        table.insert(field.key, *on);
    } else {
        const auto& text = std::get<std::string>(value);
        table.insert(field.key, field.input == SceneInput::File ? pathText(text) : text);
    }
}

void insertKeys(SceneGroup group, const SceneDescription& scene, toml::table& table) {
    for (const SceneField& field : sceneFields()) {
        if (field.group == group && !field.ownForm && whyNotOfSample(field, scene).empty()) {
            insertKey(field, scene, table);
        }
    }
}

void readHaptics(TomlSection section, SceneDescription& scene) {
    scene.tickRate = section.number("rate_hz", scene.tickRate);
    listSettings(scene.settings, [&section](const SettingField& field, auto& value) {
        if (field.key != nullptr) {
            value = readSetting(section, field.key, value);
        }
    });
    scene.settings.guide.axis = unitAxis(section, scene.settings.guide.axis);
    section.refuseUnknownKeys();
}

toml::table hapticsTable(const SceneDescription& scene) {
    toml::table table{{"rate_hz", scene.tickRate}};
    listSettings(scene.settings, [&table](const SettingField& field, const auto& value) {
        if (field.key == nullptr) {
            return;
        }
        if constexpr (HasEnumTable<std::decay_t<decltype(value)>>) {
            table.insert(field.key, keyOf(value));
        } else {
            table.insert(field.key, value);
        }
    });
    return table;
}

std::vector<Marker> readMarkers(const toml::table& scene, const std::filesystem::path& path) {
    const toml::node* const node = scene.get(kMarkers);
    if (node == nullptr) {
        return {};
    }
    const toml::array* const list = node->as_array();
    if (list == nullptr || !(list->empty() || list->is_array_of_tables())) {
        throw InputError(path.string(), "line " + std::to_string(node->source().begin.line),
                         "'marker' must be a list of tables, each written [[marker]]");
    }
    std::vector<Marker> markers;
    for (const toml::node& one : *list) {
        markers.push_back(readMarker(*one.as_table(), path));
    }
    return markers;
}

void insertMarkers(const std::vector<Marker>& markers, toml::table& scene) {
    if (markers.empty()) {
        return;
    }
    toml::array list;
    for (const Marker& marker : markers) {
        list.push_back(toml::table{{"name", marker.name}, {"x_m", marker.x}, {"y_m", marker.y}});
    }
    scene.insert(kMarkers, std::move(list));
}

MaterialSources readMaterialSources(TomlSection& section, const MaterialReader& read) {
    MaterialSources sources;
    for (const auto& [key, number, member] : kMaps) {
        if (std::optional<TomlSection> table = section.table(key)) {
            sources.*member = readSource(*table);
            table->refuseUnknownKeys();
        }
    }
    if (std::optional<TomlSection> table = section.table(kMask)) {
        if (sources.any()) {
            section.refuse(kMask, "a mask, or maps of single quantities, not both");
        }
        const MapSource source = readSource(*table);
        sources.mask = MaterialMask{.source = source,
                                    .zero = readMasked(*table, "zero", read),
                                    .one = readMasked(*table, "one", read)};
        table->refuseUnknownKeys();
    }
    return sources;
}

MaterialSources trueSources(const TomlSection& section, MaterialSources own,
                            const MaterialSources& believed) {
    if (section.has("material") || own.mask) {
        return own;
    }
    const auto numbers =
        std::ranges::count_if(kMaps, [&](const MapKey& map) { return section.has(map.number); });
    if (numbers == 0 && !own.any()) {
        return believed;
    }
    if (believed.mask && numbers < std::ssize(kMaps)) {
        section.refuse(kMask, "a mask of its own, or all of youngs_modulus_pa, "
                              "work_of_adhesion_j_m2 and friction_coefficient, since [sample] has "
                              "a mask: a part of it cannot be told");
    }
    for (const auto& [key, number, member] : kMaps) {
        if (!section.has(number) && !section.has(key)) {
            own.*member = believed.*member;
        }
    }
    return own;
}

void insertMaterialSources(const MaterialSources& sources, toml::table& table) {
    for (const auto& [key, number, member] : kMaps) {
        if (sources.*member) {
            table.insert(key, sourceTable(*(sources.*member)));
        }
    }
    if (sources.mask) {
        toml::table mask = sourceTable(sources.mask->source);
        mask.insert("zero", maskedTable(sources.mask->zero));
        mask.insert("one", maskedTable(sources.mask->one));
        table.insert(kMask, std::move(mask));
    }
}

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
