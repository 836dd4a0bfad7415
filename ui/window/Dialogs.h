#pragma once

#include <QString>
#include <QStringList>

#include <functional>
#include <vector>

class QWidget;

namespace asperity {

/// A type of scan files.
struct ScanFileType {
    QString name;          ///< for people
    QStringList patterns;  ///< of its files: "*.gwy"
};

/// The filters of the dialog that opens a scan: all that can be read and scenes first, then each
/// type by its name, and any file, whose content decides.
[[nodiscard]] QStringList scanFilters(const std::vector<ScanFileType>& types);

/// The file that a user chooses; empty: none.
[[nodiscard]] QString askForPath(QWidget* window);
[[nodiscard]] QString askForRecording(QWidget* window);
/// A file of a recorded run's folder, or a bundle.
[[nodiscard]] QString askForRun(QWidget* window);
[[nodiscard]] QString askForPicture(QWidget* window);
/// Of a measured force-distance curve.
[[nodiscard]] QString askForCurve(QWidget* window);
/// Where a table is to be written.
[[nodiscard]] QString askForTable(QWidget* window);

/// Where a force map is to be written. @param suggestion its path
[[nodiscard]] QString askForForceMap(QWidget* window, const QString& suggestion);

/// A name that a user gives; the window goes on meanwhile. @param take is called with one that is
/// not empty
void askForName(QWidget* window, const QString& title, const QString& label, const QString& name,
                const std::function<void(const QString&)>& take);

/// Asks before something of a user's is lost; the window goes on meanwhile.
/// @param action what the button that does it says
/// @param act is called where the user agrees
void askWhether(QWidget* window, const QString& question, const QString& action,
                const std::function<void()>& act);

/// The file to write a session to. @param suggestion its path
[[nodiscard]] QString askForSession(QWidget* window, const QString& suggestion);

/// What must be read; the window goes on meanwhile.
void complainIn(QWidget* window, const QString& message);

}  // namespace asperity
