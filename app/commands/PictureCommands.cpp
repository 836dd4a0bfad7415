#include "app/commands/Commands.h"
#include "app/commands/OptionChecks.h"
#include "app/commands/ProgressLine.h"
#include "app/commands/VirtualDisplay.h"
#include "app/exports/ExportView.h"
#include "app/exports/Film.h"
#include "app/exports/PictureExport.h"
#include "app/exports/PictureFile.h"
#include "app/exports/RunMoment.h"
#include "app/exports/VideoFile.h"
#include "app/runs/RunFolder.h"
#include "core/Error.h"
#include "core/PrintableText.h"
#include "core/TemporaryFile.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace asperity {

namespace {

/// Options of commands that draw, as they were given.
struct PictureOptions {
    std::string view = keyOf(ExportView::Spatial);
    std::string size;    ///< WxH [pixel]; empty: the usual one, or as `column` says
    std::string column;  ///< of a journal; empty: none
    double aspect = 4.0 / 3.0;
    double dpi = 0.0;  ///< 0: the usual one [dots an inch]
    bool transparent = false;
    bool noBars = false;
    bool noLabels = false;
    bool grid = false;
    bool clean = false;
    double width = 0.0;        ///< of the frame; 0: the usual one [m]
    double heightScale = 0.0;  ///< 0: the usual one
    std::string color;         ///< key of a quantity; empty: the usual one
};

constexpr PictureSize kUsualSize{.width = 1280, .height = 800};
constexpr double kScreenDpi = 96.0;
constexpr double kPrintDpi = 300.0;
constexpr int kMaxDpi = 2400;

std::string viewList() {
    std::string list;
    for (const auto& row : kEnumTable<ExportView>) {
        list += std::string("\n  ") + row.key + ": " + row.name;
    }
    return list;
}

std::string colorList() {
    std::string list;
    for (const SurfaceQuantity quantity : exportColors()) {
        list.append(list.empty() ? "" : ", ").append(keyOf(quantity));
    }
    return list;
}

/// @throw Error naming those that there are
SurfaceQuantity colorOf(const std::string& key) {
    const auto quantity = fromKey<SurfaceQuantity>(key);
    const auto colors = exportColors();
    if (!quantity || std::ranges::find(colors, *quantity) == colors.end()) {
        throw Error("'" + key + "' does not color a surface; expected one of " + colorList());
    }
    return *quantity;
}

/// All of the text as a whole number above zero.
std::optional<int> side(std::string_view text) {
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool isWhole = error == std::errc() && end == text.data() + text.size();
    return isWhole && value > 0 ? std::optional(value) : std::nullopt;
}

PictureSize sizeFrom(const std::string& text) {
    const std::size_t cross = text.find('x');
    const auto width = side(std::string_view(text).substr(0, cross));
    const auto height =
        cross == std::string::npos ? std::nullopt : side(std::string_view(text).substr(cross + 1));
    if (!width || !height) {
        throw CLI::ValidationError(
            "--size", "expected width and height in pixels, as 1280x800, not '" + text + "'");
    }
    return {.width = *width, .height = *height};
}

PictureSize columnSize(const PictureOptions& options, double dpi) {
    constexpr double kMillimetersPerInch = 25.4;
    const double width = journalColumn(options.column).width / kMillimetersPerInch * dpi;
    return {.width = static_cast<int>(std::lround(width)),
            .height = static_cast<int>(std::lround(width / options.aspect))};
}

std::optional<double> ifGiven(double value) {
    return value > 0.0 ? std::optional(value) : std::nullopt;
}

void addPictureOptions(CLI::App& command, PictureOptions& options) {
    command.add_option("--view", options.view, "what is shown:" + viewList())
        ->capture_default_str();
    auto* size =
        command.add_option("--size", options.size, "width and height in pixels; default: 1280x800");
    auto* column = command
                       .add_option("--column", options.column,
                                   "as wide as a journal's column: " + journalColumnList())
                       ->check(acceptedBy(journalColumn))
                       ->excludes(size);
    command.add_option("--aspect", options.aspect, "width over height with --column; default: 4/3")
        ->check(CLI::Range(0.2, 5.0))
        ->check(finiteNumber())
        ->needs(column);
    command
        .add_option("--dpi", options.dpi,
                    "dots per inch: resolution in the file; text and lines grow with it; "
                    "default: 96, or 300 with --column")
        ->check(CLI::Range(24, kMaxDpi))
        ->check(finiteNumber());
    command.add_flag("--transparent", options.transparent, "transparent background");
    command.add_flag("--no-bars", options.noBars, "without scale bars, color bars and axes");
    command.add_flag("--no-labels", options.noLabels, "without titles, captions, notes and values");
    auto* grid = command.add_flag("--grid", options.grid, "with lines on the surface");
    command.add_flag("--clean", options.clean, "without bars and labels")->excludes(grid);
    command.add_option("--width", options.width, "width of the frame [m]")->check(positiveNumber());
    command
        .add_option("--height-scale", options.heightScale,
                    "factor of all heights; 1: true to scale")
        ->check(CLI::Range(1.0, kMaxHeightScale))
        ->check(finiteNumber());
    command
        .add_option("--color", options.color,
                    "what colors the surface of a 3-D view: " + colorList() +
                        "; default: displacement of a tip in contact and in films, else height")
        ->check(acceptedBy(colorOf));
}

/// @throw CLI::ValidationError where the view is none
ExportView viewOf(const PictureOptions& options) {
    const auto view = fromKey<ExportView>(options.view);
    if (!view) {
        throw CLI::ValidationError("--view", "'" + options.view + "' is no view; expected one of " +
                                                 keyList<ExportView>());
    }
    return *view;
}

PictureSpec specOf(const PictureOptions& options) {
    const double usualDpi = options.column.empty() ? kScreenDpi : kPrintDpi;
    const double dpi = options.dpi > 0.0 ? options.dpi : usualDpi;
    const PictureSize size = !options.column.empty() ? columnSize(options, dpi)
                             : options.size.empty()  ? kUsualSize
                                                     : sizeFrom(options.size);
    return {.size = size,
            .dpi = dpi,
            .transparent = options.transparent,
            .parts = {.bars = !options.noBars && !options.clean,
                      .labels = !options.noLabels && !options.clean,
                      .grid = !options.clean,
                      .surfaceGrid = options.grid},
            .width = ifGiven(options.width),
            .heightScale = ifGiven(options.heightScale),
            .color = options.color.empty() ? std::nullopt : std::optional(colorOf(options.color))};
}

struct RenderOptions {
    std::string input;
    std::string out;
    std::string at;
    bool force = false;
    PictureOptions picture;
};

PictureRequest requestOf(const RenderOptions& options) {
    const bool hasRun = holdsRun(options.input);
    if (!options.at.empty() && !hasRun) {
        throw CLI::ValidationError("--at", options.input +
                                               " is no run; give the folder of one, or a bundle");
    }
    PictureRequest request{
        .view = viewOf(options.picture),
        .moment = runMoment(options.at.empty() ? keyOf(NamedMoment::Deepest) : options.at),
        .spec = specOf(options.picture)};
    requireDrawable(request, hasRun);
    return request;
}

ExportInput readInput(const std::filesystem::path& path) {
    ProgressLine line("loading");
    return ExportInput(path, &line);
}

void render(const RenderOptions& options) {
    const CancelOnSignal cancel;
    const PictureRequest request = requestOf(options);
    // The name of the input is known before it is read: what is wrong with --out comes first.
    const OutputNameParts parts{exportName(options.input), keyOf(request.view)};
    const std::filesystem::path path = outputPath(options.out, parts, options.force);
    const ExportFormat format = formatOf(path, request.view);
    requireWritable(path);
    std::optional<VirtualDisplay> display;
    std::optional<OffscreenApplication> application;
    if (isPlot(request.view)) {
        application.emplace();
    } else if (isRaster(format)) {
        display.emplace();
    }
    ExportInput input = readInput(options.input);
    if (!input.note().empty()) {
        std::cerr << "note: " << input.note() << '\n';
    }
    {
        ProgressLine line("drawing");
        writeExport(input, request, path, format, &line);
    }
    std::cout << printable(path.string()) << '\n';
}

struct FilmOptions {
    std::string run;
    std::string out;
    std::string from = keyOf(NamedMoment::Start);
    std::string to = keyOf(NamedMoment::End);
    double fps = 25.0;
    double speed = 1.0;
    double duration = 0.0;  ///< 0: as the speed says [s]
    bool force = false;
    PictureOptions picture;
};

FilmRequest requestOf(const FilmOptions& options) {
    FilmRequest request{.view = viewOf(options.picture),
                        .from = runMoment(options.from),
                        .to = runMoment(options.to),
                        .fps = options.fps,
                        .speed = options.speed,
                        .spec = specOf(options.picture)};
    if (options.duration > 0.0) {
        request.duration = options.duration;
    }
    return request;
}

std::filesystem::path outOf(const FilmOptions& options, const FilmRequest& request) {
    return filledPath(options.out, {.file = exportName(options.run), .view = keyOf(request.view)});
}

void requireUsable(const FilmOptions& options, const std::filesystem::path& out) {
    if (!holdsRun(options.run)) {
        throw InputError(options.run, "",
                         "is no folder of a run: a film needs one that explore or a recording "
                         "wrote, or a bundle of it");
    }
    if (isVideo(out)) {
        requireFree(out, options.force);
    } else if (out.has_extension() && !std::filesystem::is_directory(out)) {
        throw Error(out.string() + ": a film is a folder of pictures, or a video " +
                    videoExtensionList());
    }
}

void film(const FilmOptions& options) {
    const CancelOnSignal cancel;
    const FilmRequest request = requestOf(options);
    const std::filesystem::path out = outOf(options, request);
    requireUsable(options, out);
    const VirtualDisplay display;
    ExportInput input = [&] {
        ProgressLine line("loading");
        return ExportInput(options.run, &line);
    }();
    if (!input.note().empty()) {
        std::cerr << "note: " << input.note() << '\n';
    }
    std::vector<std::size_t> ticks;
    {
        ProgressLine line("drawing");
        ProgressPart finding(&line, 0.0, 0.1);
        ticks = filmTicks(*input.run(), request, &finding);
        ProgressPart drawing(&line, 0.1, 1.0);
        const std::unique_ptr<FilmArtist> artist = filmArtist(input.scene(), filmLook(request));
        const FilmWork film{*input.run(), *artist, ticks};
        isVideo(out) ? writeVideo(film, request, out, &drawing)
                     : writeFrames(film, request, out, options.force, &drawing);
    }
    std::cout << ticks.size() << " frames in " << printable(out.string()) << '\n';
}

}  // namespace

void addRenderCommand(CLI::App& program) {
    CLI::App* command = program.add_subcommand(
        "render", "Draw a scene, or a moment of a run, as a picture, a plot, or a field");
    const auto options = std::make_shared<RenderOptions>();
    command
        ->add_option("INPUT", options->input,
                     "height map, scene.toml, folder that explore or a recording wrote, or a "
                     "bundle of one")
        ->required();
    command
        ->add_option("--out", options->out,
                     "file: " + extensionHelp() +
                         ". A folder, or a name with {file}, {view}, {n}: a new file of such a "
                         "name")
        ->required()
        ->check(notEmpty());
    command
        ->add_option("--at", options->at,
                     "moment of a run: seconds since its first tick, or " + keyList<NamedMoment>() +
                         "; default: deepest")
        ->check(acceptedBy(runMoment));
    addPictureOptions(*command, options->picture);
    command->add_flag("--force", options->force, "replace the file");
    command->callback([options] { render(*options); });
}

void addFilmCommand(CLI::App& program) {
    CLI::App* command = program.add_subcommand("film", "Draw a run as a film");
    const auto options = std::make_shared<FilmOptions>();
    command
        ->add_option("RUN", options->run,
                     "folder that explore or a recording wrote, or a bundle of one")
        ->required();
    command
        ->add_option(
            "--out", options->out,
            "folder for frame_00001.png ... and frames.csv, or a video " + videoExtensionList() +
                " (by the program ffmpeg); {file}, {view} and {n} of its name are replaced")
        ->required()
        ->check(notEmpty());
    command
        ->add_option("--from", options->from,
                     "first moment: seconds since its first tick, or " + keyList<NamedMoment>())
        ->capture_default_str()
        ->check(acceptedBy(runMoment));
    command->add_option("--to", options->to, "last moment, in the same form")
        ->capture_default_str()
        ->check(acceptedBy(runMoment));
    command->add_option("--fps", options->fps, "frame rate [1/s]")
        ->check(CLI::Range(1.0, 240.0))
        ->check(finiteNumber())
        ->capture_default_str();
    auto* speed =
        command->add_option("--speed", options->speed, "seconds of the run per second of the film")
            ->check(positiveNumber())
            ->capture_default_str();
    command->add_option("--duration", options->duration, "length of the film [s]; sets the speed")
        ->check(positiveNumber())
        ->excludes(speed);
    addPictureOptions(*command, options->picture);
    command->add_flag("--force", options->force, "replace an earlier film");
    command->callback([options] { film(*options); });
}

}  // namespace asperity
