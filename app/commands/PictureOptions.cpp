#include "app/commands/PictureOptions.h"

#include "app/commands/OptionChecks.h"
#include "app/exports/JournalColumn.h"

#include <charconv>
#include <cmath>

namespace asperity {

namespace {

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

}  // namespace

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
                    "dots an inch: resolution in the file, and letters and lines grow with it; "
                    "default: 96, or 300 with --column")
        ->check(CLI::Range(24, kMaxDpi))
        ->check(finiteNumber());
    command.add_flag("--transparent", options.transparent, "nothing behind what is drawn");
    command.add_flag("--no-bars", options.noBars, "without scale bars, color bars and axes");
    command.add_flag("--no-labels", options.noLabels, "without titles, captions, notes and values");
    command.add_flag("--clean", options.clean, "without bars, labels and grid");
    command.add_option("--width", options.width, "width of the frame [m]")->check(positiveNumber());
    command
        .add_option("--height-scale", options.heightScale,
                    "factor of all heights; 1: true to scale")
        ->check(CLI::Range(1.0, kMaxHeightScale))
        ->check(finiteNumber());
}

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
                      .grid = !options.clean},
            .width = ifGiven(options.width),
            .heightScale = ifGiven(options.heightScale)};
}

}  // namespace asperity
