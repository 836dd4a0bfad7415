#include "ui/window/Dialogs.h"

#include "core/Version.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>
#include <QMessageBox>

namespace asperity {

namespace {

QString controlsText() {
    return QObject::tr(
        "<table cellpadding='3'>"
        "<tr><td><b>Left drag</b></td><td>move the tip along the sample</td></tr>"
        "<tr><td><b>Wheel</b>, <b>Page Up</b>, <b>Page Down</b></td><td>away from the sample and "
        "into it</td></tr>"
        "<tr><td><b>Arrow keys</b></td><td>along the sample, as seen on the screen</td></tr>"
        "<tr><td><b>Shift</b></td><td>one tenth of the step or speed</td></tr>"
        "<tr><td><b>Ctrl + arrows</b></td><td>five times as fast</td></tr>"
        "<tr><td><b>Right drag</b></td><td>turn the view</td></tr>"
        "<tr><td><b>Ctrl + wheel</b>, <b>+</b>, <b>−</b></td><td>zoom</td></tr>"
        "<tr><td><b>Double click</b> on the scan</td><td>move the tip there</td></tr>"
        "<tr><td><b>Space</b></td><td>pause and continue</td></tr>"
        "<tr><td><b>Esc</b></td><td>close a menu, a message or Fidelity, "
        "otherwise stop loading; with a force-feedback device: switch off its forces"
        "</td></tr></table>");
}

void openBox(QWidget* window, QMessageBox::Icon icon, const QString& title, const QString& text,
             Qt::TextFormat format) {
    const auto button = icon == QMessageBox::Warning ? QMessageBox::Ok : QMessageBox::Close;
    auto* box = new QMessageBox(icon, title, text, button, window);
    box->setTextFormat(format);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->open();
}

}  // namespace

QStringList scanFilters(const std::vector<ScanFileType>& types) {
    const QChar blank(' ');
    QStringList all{QStringLiteral("*.toml")};
    QStringList single{QObject::tr("Scenes (*.toml)")};
    for (const ScanFileType& type : types) {
        all << type.patterns;
        const QString name = type.name.left(1).toUpper() + type.name.mid(1);
        single << QStringLiteral("%1 (%2)").arg(name, type.patterns.join(blank));
    }
    all.removeDuplicates();  // some types share theirs
    return QStringList{QObject::tr("Scans and scenes (%1)").arg(all.join(blank))}
           << single << QObject::tr("All files (*)");
}

QString askForScan(QWidget* window, const std::vector<ScanFileType>& types) {
    // The patterns of all types together are wider than a screen.
    return QFileDialog::getOpenFileName(window, QObject::tr("Open a scan or a scene"), {},
                                        scanFilters(types).join(QStringLiteral(";;")), nullptr,
                                        QFileDialog::HideNameFilterDetails);
}

QString askForPath(QWidget* window) {
    return QFileDialog::getOpenFileName(window, QObject::tr("Follow a path"), {},
                                        QObject::tr("Paths: time_s, x_m, y_m, z_m (*.csv)"));
}

QString askForRecording(QWidget* window) {
    return QFileDialog::getOpenFileName(window, QObject::tr("Replay a recording"), {},
                                        QObject::tr("Force logs (force_log.csv *.csv)"));
}

QString askForPicture(QWidget* window) {
    return QFileDialog::getSaveFileName(window, QObject::tr("Save a picture of the window"),
                                        QStringLiteral("asperity.png"),
                                        QObject::tr("Pictures (*.png)"));
}

QString askForCurve(QWidget* window) {
    return QFileDialog::getOpenFileName(
        window, QObject::tr("Draw a measured force–distance curve"), {},
        QObject::tr("Text tables: distance and force with units (*.csv *.txt *.tsv *.dat);;"
                    "All files (*)"));
}

QString askForTable(QWidget* window) {
    const QString file =
        QFileDialog::getSaveFileName(window, QObject::tr("Export the touches"),
                                     QStringLiteral("touches.csv"), QObject::tr("Tables (*.csv)"));
    return file.isEmpty() || !QFileInfo(file).suffix().isEmpty() ? file
                                                                 : file + QStringLiteral(".csv");
}

void askForName(QWidget* window, const QString& title, const QString& label, const QString& name,
                const std::function<void(const QString&)>& take) {
    auto* dialog = new QInputDialog(window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setObjectName(QStringLiteral("askForName"));
    dialog->setWindowTitle(title);
    dialog->setLabelText(label);
    dialog->setTextValue(name);
    QObject::connect(dialog, &QInputDialog::textValueSelected, window,
                     [take](const QString& given) {
                         if (!given.trimmed().isEmpty()) {
                             take(given.trimmed());
                         }
                     });
    dialog->open();
}

QString askForSceneFile(QWidget* window, const QString& suggestion) {
    return QFileDialog::getSaveFileName(window, QObject::tr("Save the scene"), suggestion,
                                        QObject::tr("Scenes (*.toml)"));
}

void complainIn(QWidget* window, const QString& message) {
    // Plain: a name of a file may look like markup.
    openBox(window, QMessageBox::Warning, QObject::tr("Asperity"), message, Qt::PlainText);
}

void explainControls(QWidget* window) {
    openBox(window, QMessageBox::NoIcon, QObject::tr("Mouse and keys"), controlsText(),
            Qt::AutoText);
}

void explainProgram(QWidget* window) {
    openBox(window, QMessageBox::NoIcon, QObject::tr("About Asperity"),
            QObject::tr("<b>Asperity %1</b><br>An augmented-reality interface for an atomic force "
                        "microscope.<br>BSD-3-Clause; uses VTK, Qt, Qwt, Eigen, hidapi, OpenEXR.")
                .arg(QString::fromUtf8(kVersion)),
            Qt::AutoText);
}

}  // namespace asperity
