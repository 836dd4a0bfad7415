#pragma once

#include "core/EnumTable.h"

#include <QSize>
#include <QString>

#include <cstdint>
#include <map>
#include <vector>

namespace asperity {

/// What the window can write to a file.
enum class ExportSubject : std::uint8_t { View, Window, Forces, Cycle, Deformation, Surface, Film };

template <>
inline constexpr auto kEnumTable<ExportSubject> = std::to_array<EnumRow<ExportSubject>>(
    {{ExportSubject::View, "view", "Large view"},
     {ExportSubject::Window, "window", "Whole window"},
     {ExportSubject::Forces, "forces", "Plot: forces over time"},
     {ExportSubject::Cycle, "cycle", "Plot: force over distance"},
     {ExportSubject::Deformation, "deformation", "Deformed surface at the contact"},
     {ExportSubject::Surface, "surface", "Surface of the scan"},
     {ExportSubject::Film, "film", "Film of a recording"}});

/// What a user chooses of a film.
struct FilmChoices {
    QString recording;                       ///< the folder of a run, or a bundle
    QString view = QStringLiteral("3d");     ///< key of one that is offered
    QString from = QStringLiteral("start");  ///< key of a moment that is offered, or seconds
    QString to = QStringLiteral("end");      ///< likewise
    double speed = 1.0;                      ///< seconds of the run per second
    int fps = 25;                            ///< frames a second
};

/// What a user chooses of an export; kept from one session to the next.
struct ExportChoices {
    ExportSubject subject = ExportSubject::View;
    std::map<ExportSubject, QString> formats;  ///< of each subject, "png"; none: its first one
    QString column;                            ///< of a journal; empty: the width in pixels counts
    QSize size{1280, 800};                     ///< of the picture [pixel]
    int dpi = 96;                              ///< [dots an inch]
    bool transparent = false;
    bool bars = true;    ///< scale bars, color bars, axes
    bool labels = true;  ///< titles, notes, values
    bool clean = false;  ///< nothing of these, and no grid
    FilmChoices film;
    QString folder;
    QString name = QStringLiteral("{file}_{view}_{n}");
};

/// A journal's column.
struct ExportColumn {
    QString name;
    double width = 0.0;  ///< [mm]
};

/// One of several.
struct ExportOption {
    QString name;  ///< for people
    QString key;
};

/// A format of files.
struct OfferedFormat {
    QString key;  ///< extension without its dot, or "frames"
    /// Its pictures have the chosen size; neither those of the window nor data have.
    bool isSized = false;
};

/// What there is to choose from.
struct ExportOffer {
    std::map<ExportSubject, std::vector<OfferedFormat>> formats;
    std::vector<ExportColumn> columns;
    std::vector<ExportOption> filmViews;
    std::vector<ExportOption> moments;  ///< of a run
};

/// Whether there is a picture of it that a clipboard can hold.
[[nodiscard]] constexpr bool isPicture(ExportSubject subject) {
    return subject <= ExportSubject::Cycle;
}

}  // namespace asperity
