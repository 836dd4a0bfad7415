#include "core/scene/SampleFields.h"

#include "core/FormattedText.h"
#include "core/scene/SceneFieldOf.h"
#include "core/surface/fit/GaussianFilter.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace asperity {

namespace {

using scene_field::at;
using scene_field::kDegree;
using scene_field::kMicro;
using scene_field::kNano;

constexpr double kMaxSlope = 85.0 * kDegree;  ///< a picture shows no more of a plane [rad]

constexpr const char* kNoShape = "none";

SceneField row(const char* key, const SceneWords& words, SceneInput input, const Limits& limits,
               SceneValue (*get)(const SceneDescription&),
               void (*set)(SceneDescription&, const SceneValue&)) {
    return {.group = SceneGroup::Sample,
            .key = key,
            .words = words,
            .limits = limits,
            .input = input,
            .get = get,
            .set = set};
}

/// A row that files write in a form of its own, see core/io/scene/SceneKeys.cpp.
SceneField inOwnForm(SceneField field) {
    field.ownForm = true;
    return field;
}

/// Both sides or none: a first one makes the scan square.
void setSide(double& side, double& other, double value) {
    side = value;
    other = value == 0.0 || other == 0.0 ? value : other;
}

/// All numbers of a text, with anything between them.
std::vector<double> numbersIn(std::string_view text) {
    std::vector<double> numbers;
    while (!text.empty()) {
        double number = 0.0;
        const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), number);
        if (problem == std::errc()) {
            numbers.push_back(number);
            text.remove_prefix(static_cast<std::size_t>(end - text.data()));
        } else {
            text.remove_prefix(1);
        }
    }
    return numbers;
}

bool isBlank(const std::string& text) { return text.find_first_not_of(' ') == std::string::npos; }

std::string pointsText(const std::optional<LevelPoints>& points) {
    std::string text;
    if (points) {
        for (const Vector2& point : *points) {
            text += (text.empty() ? "" : ", ") + formatted("%.12g", point.x() / kNano) + " " +
                    formatted("%.12g", point.y() / kNano);
        }
    }
    return text;
}

/// None where there are fewer numbers than those of three positions, or more.
std::optional<LevelPoints> pointsOf(const std::string& text) {
    const std::vector<double> numbers = numbersIn(text);
    LevelPoints points;
    if (numbers.size() != 2 * points.size()) {
        return std::nullopt;
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
        points[i] = Vector2(fromUnit(numbers[2 * i], kNano), fromUnit(numbers[2 * i + 1], kNano));
    }
    return points;
}

std::string cropText(const std::optional<PixelRectangle>& crop) {
    return crop ? formatted("%d, %d, %d, %d", crop->column, crop->row, crop->columns, crop->rows)
                : std::string();
}

/// None where the text says no rectangle.
std::optional<PixelRectangle> cropOf(const std::string& text) {
    constexpr double kMax = 1e9;  // pixels along a side
    const std::vector<double> numbers = numbersIn(text);
    const bool arePixels = std::ranges::all_of(numbers, [](double number) {
        return isWithin(number, 0.0, kMax) && number == std::floor(number);
    });
    if (numbers.size() != 4 || !arePixels || numbers[2] == 0.0 || numbers[3] == 0.0) {
        return std::nullopt;
    }
    return PixelRectangle{.column = static_cast<int>(numbers[0]),
                          .row = static_cast<int>(numbers[1]),
                          .columns = static_cast<int>(numbers[2]),
                          .rows = static_cast<int>(numbers[3])};
}

SceneField cropField() {
    SceneField field = inOwnForm(row(
        "crop_px",
        {"Part", "Of the scan that is loaded: left column, top row, columns, rows; empty: all",
         "px"},
        SceneInput::Text, {},
        [](const SceneDescription& scene) -> SceneValue { return cropText(scene.sample.crop); },
        [](SceneDescription& scene, const SceneValue& value) {
            scene.sample.crop = cropOf(std::get<std::string>(value));
        }));
    field.refusal = [](const std::string& text) {
        return isBlank(text) || cropOf(text)
                   ? std::string()
                   : std::string("four whole numbers, column, row, columns, rows, or nothing");
    };
    return field;
}

std::vector<SceneField> scaleFields() {
    constexpr Limits kSize{0.0, 1e3, "lie between 0 and 1e3"};
    std::vector<SceneField> fields{
        row(
            "size_x_m", {"Width", "Of the whole scan; 0: that of the file", "µm", kMicro},
            SceneInput::Number, kSize,
            [](const SceneDescription& scene) -> SceneValue { return scene.sample.scale.sizeX; },
            [](SceneDescription& scene, const SceneValue& value) {
                GivenScale& scale = scene.sample.scale;
                setSide(scale.sizeX, scale.sizeY, std::get<double>(value));
            }),
        row(
            "size_y_m", {"Height", "Of the whole scan along y; 0: that of the file", "µm", kMicro},
            SceneInput::Number, kSize,
            [](const SceneDescription& scene) -> SceneValue { return scene.sample.scale.sizeY; },
            [](SceneDescription& scene, const SceneValue& value) {
                GivenScale& scale = scene.sample.scale;
                setSide(scale.sizeY, scale.sizeX, std::get<double>(value));
            }),
        at<&SceneDescription::sample, &SampleDescription::scale, &GivenScale::heightPerValue>(
            SceneGroup::Sample, "z_scale_m",
            {"Height of 1", "Height of a value of 1 in the file; 0: as in the file", "nm", kNano},
            {0.0, 1e6, "lie between 0 and 1e6"}),
    };
    for (SceneField& field : fields) {
        field.isStated = [](const SceneDescription& scene) { return scene.sample.scale.hasSize(); };
    }
    fields.back().isStated = [](const SceneDescription& scene) {
        return scene.sample.scale.hasHeight();
    };
    return fields;
}

std::vector<SceneField> levelingFields() {
    std::vector<SceneField> fields{
        row(
            "level", {"Leveling", "Steps in order, such as “plane, scars, zero”, or none"},
            SceneInput::Steps, {},
            [](const SceneDescription& scene) -> SceneValue {
                return textOf(scene.sample.leveling);
            },
            [](SceneDescription& scene, const SceneValue& value) {
                scene.sample.leveling =
                    levelingSteps(std::get<std::string>(value)).value_or(scene.sample.leveling);
            }),
        row(
            "level_points_m",
            {"Level points",
             "Three points of the step “three points”: x y, x y, x y from the lower "
             "left corner",
             "nm", kNano},
            SceneInput::Positions, {},
            [](const SceneDescription& scene) -> SceneValue {
                return pointsText(scene.sample.levelPoints);
            },
            [](SceneDescription& scene, const SceneValue& value) {
                scene.sample.levelPoints = pointsOf(std::get<std::string>(value));
            }),
    };
    fields[0].ownForm = fields[1].ownForm = true;
    fields[0].refusal = [](const std::string& text) {
        return levelingSteps(text) ? std::string() : "steps of " + levelingKeys();
    };
    fields[1].refusal = [](const std::string& text) {
        return isBlank(text) || pointsOf(text) ? std::string() : std::string("x y of three points");
    };
    return fields;
}

std::string smoothingText(const SampleDescription& sample) {
    return sample.smoothingPixels ? formatted("%.12g", *sample.smoothingPixels)
                                  : std::string(kLeftOpen);
}

/// None where the text is no width.
std::optional<double> smoothingIn(std::string_view text) {
    double pixels = 0.0;
    const char* const last = text.data() + text.size();
    const auto [end, problem] = std::from_chars(text.data(), last, pixels);
    const bool isWidth =
        problem == std::errc() && end == last && isWithin(pixels, 0.0, kMaxSmoothing);
    return isWidth ? std::optional(pixels) : std::nullopt;
}

/// A number, or the word by which it is left to the program.
SceneField smoothingField() {
    SceneField field = inOwnForm(row(
        "smoothing_px",
        {"Smoothing",
         "Standard deviation of the Gaussian low-pass; 0: none; auto: chosen once, by the scan's "
         "noise and the tip",
         "px"},
        SceneInput::Text, {},
        [](const SceneDescription& scene) -> SceneValue { return smoothingText(scene.sample); },
        [](SceneDescription& scene, const SceneValue& value) {
            scene.sample.smoothingPixels = smoothingIn(std::get<std::string>(value));
            scene.sample.smoothingLength = 0.0;
        }));
    field.refusal = [](const std::string& text) {
        return text == kLeftOpen || smoothingIn(text)
                   ? std::string()
                   : "a number from 0 to 100, or " + std::string(kLeftOpen);
    };
    return field;
}

std::vector<SceneField> filterFields() {
    return {
        smoothingField(),
        inOwnForm(row(
            "smoothing_m",
            {"… as a length",
             "Standard deviation of the low-pass as a length, in place of pixels; "
             "0: in pixels",
             "nm", kNano},
            SceneInput::Number, {0.0, 1.0, "lie between 0 and 1"},
            [](const SceneDescription& scene) -> SceneValue {
                return scene.sample.smoothingLength;
            },
            [](SceneDescription& scene, const SceneValue& value) {
                scene.sample.smoothingLength = std::get<double>(value);
                scene.sample.smoothingPixels =
                    std::get<double>(value) > 0.0 ? std::optional(0.0) : std::nullopt;
            })),
        at<&SceneDescription::sample, &SampleDescription::imagingTipRadius>(
            SceneGroup::Sample, "imaging_tip_radius_m",
            {"Imaging tip radius", "Of the tip that recorded the scan; 0: not known", "nm", kNano},
            {1e-12, 1.0, "be 0 or lie between 1e-12 and 1", true}),
        at<&SceneDescription::sample, &SampleDescription::erode>(
            SceneGroup::Sample, "erode",
            {"Remove the imaging tip", "Takes that tip's shape out of the scan, after smoothing"},
            {}),
    };
}

/// A shape has none of the keys of a scan, and each kind only its own.
void setKind(SampleDescription& sample, const std::string& key) {
    const std::optional<ShapeKind> kind = fromKey<ShapeKind>(key);
    if (!kind) {
        sample.shape.reset();
        return;
    }
    ShapeDescription shape = sample.shape.value_or(ShapeDescription{});
    shape.kind = *kind;
    if (*kind == ShapeKind::Plane) {
        shape.radius = ShapeDescription{}.radius;
    } else {
        shape.slope = ShapeDescription{}.slope;
        shape.size = std::min(shape.size, shape.radius);  // a window that fits on all of them
    }
    SampleDescription shaped;
    shaped.material = sample.material;
    shaped.shape = shape;
    sample = std::move(shaped);
}

template <double ShapeDescription::*part>
SceneField ofShape(const char* key, const SceneWords& words, const Limits& limits) {
    SceneField field = row(
        key, words, SceneInput::Number, limits,
        [](const SceneDescription& scene) -> SceneValue {
            return scene.sample.shape.value_or(ShapeDescription{}).*part;
        },
        [](SceneDescription& scene, const SceneValue& value) {
            if (scene.sample.shape) {
                (*scene.sample.shape).*part = std::get<double>(value);
            }
        });
    field.group = SceneGroup::Shape;
    return field;
}

}  // namespace

std::vector<SceneField> sampleFields() {
    std::vector<SceneField> fields{
        at<&SceneDescription::sample, &SampleDescription::file>(
            SceneGroup::Sample, "file", {"File", "The height map of the scan"}, {}),
        at<&SceneDescription::sample, &SampleDescription::channel>(
            SceneGroup::Sample, "channel", {"Channel", "Of the file, that is shown"}, {})};
    fields[0].input = SceneInput::File;
    fields[1].input = SceneInput::Choice;  // of those that the file has
    fields.push_back(cropField());
    for (std::vector<SceneField> part : {scaleFields(), levelingFields(), filterFields()}) {
        std::ranges::move(part, std::back_inserter(fields));
    }
    return fields;
}

std::vector<SceneField> shapeFields() {
    constexpr SceneGroup kGroup = SceneGroup::Shape;
    constexpr Limits kLength{1e-9, 1e-3, "lie between 1e-9 and 1e-3"};
    SceneField kind = row(
        "shape", {"Shape", "An exact shape in place of the scan"}, SceneInput::Choice, {},
        [](const SceneDescription& scene) -> SceneValue {
            return std::string(scene.sample.shape ? keyOf(scene.sample.shape->kind) : kNoShape);
        },
        [](SceneDescription& scene, const SceneValue& value) {
            setKind(scene.sample, std::get<std::string>(value));
        });
    kind.group = kGroup;
    kind.ownForm = true;
    kind.choices = scene_field::choicesOf<ShapeKind>(false);
    kind.choices.insert(kind.choices.begin(), {kNoShape, "none"});
    return {
        kind,
        ofShape<&ShapeDescription::radius>(
            "shape_radius_m", {"Radius", "Of the sphere or cylinder", "nm", kNano}, kLength),
        ofShape<&ShapeDescription::slope>(
            "shape_slope_rad", {"Slope", "Of the plane, along x", "°", kDegree},
            {-kMaxSlope, kMaxSlope, "lie between -1.4835 and 1.4835 (85 degrees)"}),
        ofShape<&ShapeDescription::size>(
            "shape_size_m", {"Window", "Side of the square that is looked at", "nm", kNano},
            kLength),
    };
}

}  // namespace asperity
