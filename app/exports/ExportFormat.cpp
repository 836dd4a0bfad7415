#include "app/exports/ExportFormat.h"

#include "core/Error.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace asperity {

namespace {

struct FormatRow {
    ExportFormat format;
    const char* extension;
};

constexpr std::array<FormatRow, 9> kFormats{{{ExportFormat::Png, ".png"},
                                             {ExportFormat::Tiff, ".tif"},
                                             {ExportFormat::Tiff, ".tiff"},
                                             {ExportFormat::Svg, ".svg"},
                                             {ExportFormat::Pdf, ".pdf"},
                                             {ExportFormat::Csv, ".csv"},
                                             {ExportFormat::Exr, ".exr"},
                                             {ExportFormat::Vtp, ".vtp"},
                                             {ExportFormat::Vts, ".vts"}}};

bool isWritten(ExportView view, ExportFormat format) {
    switch (format) {
    case ExportFormat::Png:
    case ExportFormat::Tiff:
        return true;
    case ExportFormat::Svg:
    case ExportFormat::Pdf:
        return isPlot(view);
    case ExportFormat::Csv:
        return isPlot(view) || view == ExportView::Deformation;
    case ExportFormat::Exr:
    case ExportFormat::Vtp:
    case ExportFormat::Vts:
        return view == ExportView::Deformation;
    }
    return false;
}

}  // namespace

std::string extensionsOf(ExportView view) {
    std::string list;
    for (const FormatRow& row : kFormats) {
        if (isWritten(view, row.format)) {
            list.append(list.empty() ? "" : ", ").append(row.extension);
        }
    }
    return list;
}

ExportFormat formatOf(const std::filesystem::path& file, ExportView view) {
    std::string extension = file.extension().string();
    std::ranges::transform(extension, extension.begin(),
                           [](unsigned char letter) { return std::tolower(letter); });
    const auto* const row = std::ranges::find(kFormats, extension, &FormatRow::extension);
    if (row == kFormats.end() || !isWritten(view, row->format)) {
        throw Error(file.string() + ": the view " + keyOf(view) +
                    " is written with one of the extensions " + extensionsOf(view));
    }
    return row->format;
}

}  // namespace asperity
