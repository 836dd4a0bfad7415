#include "app/window/export/ExportChoices.h"

#include <QSettings>

namespace asperity {

namespace {

QString key(const char* name) { return QStringLiteral("export/") + QString::fromLatin1(name); }

QString formatKey(ExportSubject subject) {
    return key("format/") + QString::fromLatin1(keyOf(subject));
}

}  // namespace

ExportChoices keptChoices(const QSettings& settings) {
    ExportChoices choices;
    choices.subject =
        fromKey<ExportSubject>(settings.value(key("subject")).toString().toStdString())
            .value_or(choices.subject);
    for (const auto& row : kEnumTable<ExportSubject>) {
        const QString format = settings.value(formatKey(row.value)).toString();
        if (!format.isEmpty()) {
            choices.formats[row.value] = format;
        }
    }
    choices.column = settings.value(key("column")).toString();
    choices.size = settings.value(key("size"), choices.size).toSize();
    choices.dpi = settings.value(key("dpi"), choices.dpi).toInt();
    choices.transparent = settings.value(key("transparent"), choices.transparent).toBool();
    choices.bars = settings.value(key("bars"), choices.bars).toBool();
    choices.labels = settings.value(key("labels"), choices.labels).toBool();
    choices.clean = settings.value(key("clean"), choices.clean).toBool();
    choices.dent = settings.value(key("dent"), choices.dent).toBool();
    FilmChoices& film = choices.film;
    film.recording = settings.value(key("recording")).toString();
    film.view = settings.value(key("film_view"), film.view).toString();
    film.from = settings.value(key("from"), film.from).toString();
    film.to = settings.value(key("to"), film.to).toString();
    film.speed = settings.value(key("speed"), film.speed).toDouble();
    film.fps = settings.value(key("fps"), film.fps).toInt();
    choices.folder = settings.value(key("folder")).toString();
    choices.name = settings.value(key("name"), choices.name).toString();
    return choices;
}

void keepChoices(QSettings& settings, const ExportChoices& choices) {
    settings.setValue(key("subject"), QString::fromLatin1(keyOf(choices.subject)));
    for (const auto& [subject, format] : choices.formats) {
        settings.setValue(formatKey(subject), format);
    }
    settings.setValue(key("column"), choices.column);
    settings.setValue(key("size"), choices.size);
    settings.setValue(key("dpi"), choices.dpi);
    settings.setValue(key("transparent"), choices.transparent);
    settings.setValue(key("bars"), choices.bars);
    settings.setValue(key("labels"), choices.labels);
    settings.setValue(key("clean"), choices.clean);
    settings.setValue(key("dent"), choices.dent);
    settings.setValue(key("recording"), choices.film.recording);
    settings.setValue(key("film_view"), choices.film.view);
    settings.setValue(key("from"), choices.film.from);
    settings.setValue(key("to"), choices.film.to);
    settings.setValue(key("speed"), choices.film.speed);
    settings.setValue(key("fps"), choices.film.fps);
    settings.setValue(key("folder"), choices.folder);
    settings.setValue(key("name"), choices.name);
}

}  // namespace asperity
