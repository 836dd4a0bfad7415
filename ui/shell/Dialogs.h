#pragma once

#include <QDialog>
#include <QFileDialog>
#include <QRect>
#include <QSize>
#include <QString>
#include <QStringList>

#include <functional>
#include <vector>

class QWidget;
class QPlainTextEdit;
class QLineEdit;

namespace asperity {

/// A type of scan files.
struct ScanFileType {
    QString name;          ///< for people
    QStringList patterns;  ///< of its files: "*.gwy"
};

/// The filters of the dialog that opens a scan: all that can be read and scenes first, then each
/// type by its name, and any file, whose content decides.
[[nodiscard]] QStringList scanFilters(const std::vector<ScanFileType>& types);

/// A name that a user gives; the window stays usable. @param take is called with one that is
/// not empty
void askForName(QWidget* window, const QString& title, const QString& label, const QString& name,
                const std::function<void(const QString&)>& take);

/// Name of the box of askWhether() as an object.
inline constexpr const char* kAskWhether = "askWhether";

/// Asks before something of a user's is lost; the window stays usable.
/// @param action what the button that does it says
/// @param act is called where the user agrees
void askWhether(QWidget* window, const QString& question, const QString& action,
                const std::function<void()>& act);

/// Shows a message that must be read; the window stays responsive.
void complainIn(QWidget* window, const QString& message);

// Geometry on a screen: all lengths in pixels of the desktop, without the frames of windows.

/// Returns where a window opens: in the middle of the screen, with space for its frame.
/// @param available of the screen, without task bars
[[nodiscard]] QRect openingGeometry(const QSize& wanted, const QRect& available);

/// Returns where another window opens: right of `window`, else left of it, else over its right
/// edge; on the screen in any case.
[[nodiscard]] QRect placeBeside(const QRect& window, const QSize& wanted, const QRect& available);

/// A text beside the window, to be read, selected and copied.
class TextDialog : public QDialog {
    Q_OBJECT

public:
    TextDialog(const QString& title, const QString& tip, QWidget* window);

    void setText(const QString& text);
    [[nodiscard]] QString text() const;

private:
    QPlainTextEdit* text_;
};

/// Folders and files as a part of a dialog: Qt's own file dialog without its buttons.
class FileChooser : public QFileDialog {
    Q_OBJECT

public:
    /// @param filters of file types, "Gwyddion .gwy (*.gwy)"
    explicit FileChooser(const QStringList& filters, QWidget* parent = nullptr);

    /// The file that is chosen or typed; empty: none that is there.
    [[nodiscard]] QString file() const;
    /// Folders that are one click away.
    void setFolders(const QStringList& folders);
    /// Goes to its folder and chooses it.
    void choose(const QString& file);

    void accept() override;
    void reject() override { Q_EMIT canceled(); }
    void done(int /*result*/) override {}  // it stays where it is
    bool eventFilter(QObject* watched, QEvent* event) override;

Q_SIGNALS:
    /// file() is another one.
    void chosen(const QString& file);
    /// Return or a double click has chosen it.
    void activated();
    void canceled();

private:
    void watchName();

    QLineEdit* name_ = nullptr;
    QString file_;
};

}  // namespace asperity
