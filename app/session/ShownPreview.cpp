#include "app/session/ShownPreview.h"

#include "core/PrintableText.h"
#include "core/io/heightmap/PhysicalUnit.h"
#include "ui/NumberText.h"
#include "ui/panels/HeightPicture.h"

#include <cmath>

namespace asperity {

namespace {

QString text(const std::string& words) { return QString::fromStdString(printable(words)); }

/// Without a unit a prefix would be read as one.
QString quantity(double value, const std::string& unit) {
    if (!std::isfinite(value)) {
        return QStringLiteral("–");
    }
    const PhysicalUnit known = parseUnit(unit);  // "mV" must not become "mmV"
    return known.base.empty() ? QString::number(value, 'g', 3)
                              : siText(value * known.factor, known.base.c_str());
}

QString product(const QString& x, const QString& y) { return QStringLiteral("%1 × %2").arg(x, y); }

/// What is told of thinned heights is told so.
QString thinned(const QString& number, int step) {
    return step == 1 ? number : QObject::tr("%1 (of every %2th pixel)").arg(number).arg(step);
}

QString sizeText(const ScanPreview& preview) {
    return preview.sizeX > 0.0 ? product(quantity(preview.sizeX, "m"), quantity(preview.sizeY, "m"))
                               : QObject::tr("not known");
}

QString pitchText(const ScanPreview& preview) {
    return preview.sizeX > 0.0 ? product(quantity(preview.sizeX / preview.columns, "m"),
                                         quantity(preview.sizeY / preview.rows, "m"))
                               : QObject::tr("not known");
}

QString rangeText(const ScanPreview& preview) {
    const HeightStatistics& of = preview.whole.statistics;
    return thinned(QObject::tr("%1 to %2")
                       .arg(quantity(of.lowest, preview.unit), quantity(of.highest, preview.unit)),
                   preview.step);
}

QString rmsText(const ScanPreview& preview) {
    if (preview.leveled.map.heights.empty()) {
        return quantity(preview.whole.statistics.rms, preview.unit);
    }
    const PreviewedHeights& before =
        preview.part.map.heights.empty() ? preview.whole : preview.part;
    return QObject::tr("%1 before leveling, %2 after")
        .arg(quantity(before.statistics.rms, preview.unit),
             quantity(preview.leveled.statistics.rms, preview.unit));
}

QString missingText(const ScanPreview& preview) {
    const std::size_t missing = preview.whole.statistics.invalidPixels;
    if (missing == 0) {
        return QObject::tr("none");
    }
    const double share = 100.0 * static_cast<double>(missing) /
                         static_cast<double>(preview.whole.map.heights.size());
    const QString percent = QObject::tr("%1 %").arg(share, 0, 'g', 2);
    return preview.step == 1 ? QObject::tr("%1 (%2)").arg(missing).arg(percent) : percent;
}

std::vector<OpenFact> factsOf(const ScanPreview& preview) {
    return {{"previewFormat", QObject::tr("Format"), text(preview.format),
             QObject::tr("Type of the file, told by its content")},
            {"previewPixels", QObject::tr("Pixels"),
             product(QString::number(preview.columns), QString::number(preview.rows)),
             QObject::tr("Columns and rows of the scan")},
            {"previewSize", QObject::tr("Size"), sizeText(preview),
             QObject::tr("Width and height of the whole scan")},
            {"previewPitch", QObject::tr("Pixel"), pitchText(preview),
             QObject::tr("Width and height of a pixel")},
            {"previewRange", QObject::tr("Heights"), rangeText(preview),
             QObject::tr("Lowest and highest value of the channel, as the file gives them")},
            {"previewRms", QObject::tr("Rms"), rmsText(preview),
             QObject::tr("Root mean square of the heights about their mean, in the part to load")},
            {"previewMissing", QObject::tr("No data"), missingText(preview),
             QObject::tr("Pixels of the scan that hold no data; heights there are filled in")}};
}

std::vector<OpenChannel> channelsOf(const ScanPreview& preview) {
    std::vector<OpenChannel> channels;
    for (const PreviewedChannel& channel : preview.channels) {
        channels.push_back({.name = QString::fromStdString(channel.name),
                            .unit = text(channel.unit.empty() ? "–" : channel.unit),
                            .direction = text(channel.direction),
                            .pixels = {channel.columns, channel.rows},
                            .opens = channel.opens});
    }
    return channels;
}

QStringList notesOf(const ScanPreview& preview) {
    QStringList notes;
    for (const std::string& note : preview.notes) {
        notes << text(note);
    }
    for (const Provenance& entry : preview.provenance) {
        notes << QStringLiteral("%1: %2 (%3)")
                     .arg(text(entry.what), text(entry.value), text(entry.source));
    }
    return notes;
}

}  // namespace

OpenPreview shownPreview(const ScanPreview& preview) {
    OpenPreview shown{.format = text(preview.format),
                      .channels = channelsOf(preview),
                      .channel = QString::fromStdString(preview.channel),
                      .pixels = {preview.columns, preview.rows},
                      .size = {preview.sizeX, preview.sizeY},
                      .gap = preview.gap,
                      .isMap = !preview.channels.empty(),
                      .leveling = preview.leveling,
                      .levelPoints = preview.levelPoints,
                      .crop = preview.crop,
                      .before = heightPicture(preview.whole.map),
                      .after = {},
                      .facts = factsOf(preview),
                      .notes = notesOf(preview),
                      .refusal = text(preview.refusal)};
    if (!preview.leveled.map.heights.empty()) {
        shown.after = heightPicture(preview.leveled.map);
    }
    return shown;
}

}  // namespace asperity
