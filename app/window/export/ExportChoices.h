#pragma once

#include "core/EnumTable.h"

#include <QSize>
#include <QString>

#include <cstdint>
#include <map>
#include <vector>

class QSettings;

namespace asperity {

/// Subjects that the window can write to a file.
enum class ExportSubject : std::uint8_t {
    View,
    Window,
    Forces,
    Cycle,
    Deformation,
    Section,
    Surface,
    Film
};

template <>
inline constexpr auto kEnumTable<ExportSubject> = std::to_array<EnumRow<ExportSubject>>(
    {{ExportSubject::View, "view", "Large view"},
     {ExportSubject::Window, "window", "Whole window"},
     {ExportSubject::Forces, "forces", "Plot: forces over time"},
     {ExportSubject::Cycle, "cycle", "Plot: force over distance"},
     {ExportSubject::Deformation, "deformation", "Deformed surface at the contact"},
     {ExportSubject::Section, "section", "Section through the contact"},
     {ExportSubject::Surface, "surface", "Surface of the scan"},
     {ExportSubject::Film, "film", "Film of a recording"}});

/// Choices of a user for a film.
struct FilmChoices {
    QString recording;                       ///< the folder of a run, or a bundle
    QString view = QStringLiteral("3d");     ///< key of one that is offered
    QString from = QStringLiteral("start");  ///< key of a moment that is offered, or seconds
    QString to = QStringLiteral("end");      ///< same
    double speed = 1.0;                      ///< seconds of the run per second
    int fps = 25;                            ///< frames a second
};

/// Choices of a user for an export; kept from one session to the next.
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
    bool dent = true;    ///< a contact is colored by displacement, whatever colors the window
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

/// Options of the export dialog.
struct ExportOffer {
    std::map<ExportSubject, std::vector<OfferedFormat>> formats;
    std::vector<ExportColumn> columns;
    std::vector<ExportOption> filmViews;
    std::vector<ExportOption> moments;  ///< of a run
};

/// Returns whether a clipboard can hold a picture of it.
[[nodiscard]] constexpr bool isPicture(ExportSubject subject) {
    return subject <= ExportSubject::Cycle;
}

/// Returns the choices of the last export; where there are none, the usual ones.
[[nodiscard]] ExportChoices keptChoices(const QSettings& settings);
void keepChoices(QSettings& settings, const ExportChoices& choices);

}  // namespace asperity
