#include "ui/window/Dialogs.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>
#include <QMessageBox>
#include <QPushButton>

namespace asperity {

QStringList scanFilters(const std::vector<ScanFileType>& types) {
    const QChar blank(' ');
    QStringList all{QStringLiteral("*.toml"), QStringLiteral("*.zip")};
    QStringList single{QObject::tr("Scenes (*.toml)"), QObject::tr("Bundles (*.zip)")};
    for (const ScanFileType& type : types) {
        all << type.patterns;
        const QString name = type.name.left(1).toUpper() + type.name.mid(1);
        single << QStringLiteral("%1 (%2)").arg(name, type.patterns.join(blank));
    }
    all.removeDuplicates();  // some types share theirs
    return QStringList{QObject::tr("Scans and scenes (%1)").arg(all.join(blank))}
           << single << QObject::tr("All files (*)");
}

QString askForPath(QWidget* window) {
    return QFileDialog::getOpenFileName(window, QObject::tr("Follow a path"), {},
                                        QObject::tr("Paths: time_s, x_m, y_m, z_m (*.csv)"));
}

QString askForRecording(QWidget* window) {
    return QFileDialog::getOpenFileName(
        window, QObject::tr("Replay a recording"), {},
        QObject::tr("Force logs (force_log.csv recording.h5 *.csv)"));
}

QString askForRun(QWidget* window) {
    return QFileDialog::getOpenFileName(
        window, QObject::tr("Look at a recording"), {},
        QObject::tr("Recorded runs (recording.json summary.json recording.h5 force_log.csv);;"
                    "Bundles (*.zip);;All files (*)"));
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

QString askForForceMap(QWidget* window, const QString& suggestion) {
    return QFileDialog::getSaveFileName(
        window, QObject::tr("Save the force map"), suggestion,
        QObject::tr("Force maps: .gwy, with .vti, .exr and pictures beside it (*.gwy)"));
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

void askWhether(QWidget* window, const QString& question, const QString& action,
                const std::function<void()>& act) {
    auto* box = new QMessageBox(QMessageBox::Question, QObject::tr("Asperity"), question,
                                QMessageBox::Cancel, window);
    box->setObjectName(QStringLiteral("askWhether"));
    box->setTextFormat(Qt::PlainText);  // a name may look like markup
    box->setAttribute(Qt::WA_DeleteOnClose);
    const QPushButton* agree = box->addButton(action, QMessageBox::AcceptRole);
    box->setDefaultButton(QMessageBox::Cancel);
    QObject::connect(agree, &QPushButton::clicked, window, act);
    box->open();
}

QString askForSession(QWidget* window, const QString& suggestion) {
    return QFileDialog::getSaveFileName(window, QObject::tr("Save the session"), suggestion,
                                        QObject::tr("Sessions (*.toml)"));
}

void complainIn(QWidget* window, const QString& message) {
    auto* box = new QMessageBox(QMessageBox::Warning, QObject::tr("Asperity"), message,
                                QMessageBox::Ok, window);
    // A name of a file may look like markup.
    box->setTextFormat(Qt::PlainText);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->open();
}

}  // namespace asperity
