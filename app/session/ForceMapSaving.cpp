#include "app/session/ForceMapSaving.h"

#include "app/maps/MapFiles.h"
#include "app/maps/MapSheets.h"
#include "core/Error.h"
#include "core/PrintableText.h"
#include "core/TemporaryFile.h"
#include "core/io/TextValue.h"
#include "core/scene/SceneFiles.h"
#include "ui/ShownPath.h"
#include "ui/window/Dialogs.h"
#include "ui/window/MainWindow.h"

#include <QFile>

namespace asperity {

namespace {

/// @throw Error where a file is an input of the scene, or cannot be written
void requireTargets(const HeldMap& map, const MapFiles& files) {
    for (const std::filesystem::path& target : filesOf(files, map.plan(), true)) {
        forEachFile(map.loaded().scene.description, [&target](const std::string& input) {
            std::error_code none;
            if (std::filesystem::equivalent(input, target, none)) {
                throw Error(target.string() + ": the scene is made of this; give another name");
            }
        });
        requireWritable(target);
    }
}

/// Beside the scan, named after it.
QString suggestionFor(const HeldMap& map) {
    const std::filesystem::path scan = map.loaded().scene.description.sample.file;
    const std::string stem = scan.empty() ? std::string("force") : scan.stem().string();
    return QFile::decodeName((stem + "_map.gwy").c_str());
}

}  // namespace

ForceMapSaving::ForceMapSaving(MainWindow& window)
    : window_(window)
    , work_(loadingLine(window), {.finished = [&window](QString& told) { window.tell(told); },
                                  .failed =
                                      [&window](const std::exception_ptr& reason) {
                                          window.complain(reasonOf(reason));
                                      }}) {}

void ForceMapSaving::ask(const std::shared_ptr<const HeldMap>& map) {
    const QString file = askForForceMap(&window_, suggestionFor(*map));
    if (!file.isEmpty()) {
        saveTo(map, pathOf(file));
    }
}

void ForceMapSaving::saveTo(const std::shared_ptr<const HeldMap>& map,
                            const std::filesystem::path& gwy) {
    const std::filesystem::path path =
        gwy.has_extension() ? gwy : std::filesystem::path(gwy.string() + ".gwy");
    if (lowerCase(path.extension().string()) != ".gwy") {
        window_.complain(QObject::tr("%1: expected the name of a .gwy file").arg(shownPath(path)));
        return;
    }
    const MapFiles files(path);
    for (const std::filesystem::path& file : filesOf(files, map->plan(), true)) {
        std::error_code none;
        if (file != path && std::filesystem::exists(file, none)) {  // the dialog asked for that one
            askWhether(&window_,
                       QObject::tr("%1 is there already, beside the map. Replace it and the other "
                                   "files of the map?")
                           .arg(shownPath(file)),
                       QObject::tr("Replace"), [this, map, path] { write(map, path); });
            return;
        }
    }
    write(map, path);
}

void ForceMapSaving::write(const std::shared_ptr<const HeldMap>& map,
                           const std::filesystem::path& gwy) {
    const MapFiles files(gwy);
    try {
        requireTargets(*map, files);
        writeMapSheets(files, map->plan(), map->part());  // what draws needs the window's thread
    } catch (const Error& error) {
        window_.complain(QString::fromStdString(printable(error.what())));
        return;
    }
    work_.start(
        QObject::tr("Writing %1 …").arg(shownPath(gwy.filename())),
        [map, files, told = QObject::tr("Saved as %1").arg(shownPath(gwy))](Progress& progress) {
            writeMapFiles(files, map->loaded(), map->plan(), map->part(), &progress);
            return told;
        });
}

}  // namespace asperity
