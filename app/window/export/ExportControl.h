#pragma once

#include "app/window/LongWork.h"
#include "app/window/Stage.h"
#include "app/window/ViewControl.h"
#include "app/window/export/ExportDialog.h"
#include "app/window/export/FilmOfRecording.h"

#include <QImage>
#include <QPointer>
#include <QSettings>
#include <QTimer>

#include <filesystem>
#include <memory>
#include <optional>

class QAction;

namespace asperity {

/// Writes what the window shows, or puts it on the clipboard, as a user chooses in a dialog. All of
/// it is of the moment at which the dialog opened.
class ExportControl : public Feature {
    Q_OBJECT

public:
    /// @param window, runs, views outlive this
    explicit ExportControl(Stage& stage);

    /// Reads the last choices from `settings`, and keeps new ones there.
    void remember(std::unique_ptr<QSettings> settings);

    /// Shows the dialog; the window stays usable.
    void ask();
    /// The dialog; null: it is closed.
    [[nodiscard]] ExportDialog* dialog() { return dialog_; }

private:
    void chooseOpenRecording();
    void connectDialog();
    void follow();
    void showFile();
    void preview();
    void showPicture(const QImage& picture);
    void showFailures();
    [[nodiscard]] std::filesystem::path file() const;
    [[nodiscard]] std::optional<SurfaceQuantity> color() const;
    [[nodiscard]] PictureSpec spec() const;
    [[nodiscard]] PictureSpec previewSpec() const;
    [[nodiscard]] const QImage& windowPicture();
    [[nodiscard]] QImage picture(const PictureSpec& spec);
    [[nodiscard]] QString wordsFor(ExportSubject subject) const;
    void write();
    void draw(const std::filesystem::path& path);
    void start(const std::filesystem::path& path);
    [[nodiscard]] ExportWork workFor(const ExportOrder& order);
    void copy();

    ViewControl& views_;
    std::unique_ptr<QSettings> settings_;
    ExportChoices choices_;
    QPointer<ExportDialog> dialog_;
    std::shared_ptr<const ExportMoment> moment_;  ///< while the dialog is open
    QImage windowPicture_;                        ///< of that moment, once it was asked for
    std::optional<ExportSubject> previewed_;      ///< of the present preview
    QString nameFailure_;     ///< why there is no file of that name; empty: there is
    QString pictureFailure_;  ///< why there is no such picture; empty: there is
    QTimer soon_;             ///< so that choices that follow each other are drawn at once
    MainThreadExecutor executor_;
    BackgroundWork<QImage> preview_;
    LongWork<QString> work_;  ///< its answer is what to tell
};

/// Puts on the clipboard what the window shows: the large view, the window, a plot, the numbers.
class ClipboardControl : public Feature {
    Q_OBJECT

public:
    /// @param window, runs, views outlive this
    explicit ClipboardControl(Stage& stage);

private:
    void copyView();
    void copyWindow();
    void copyPlot();
    void copyNumbers();

    QAction* plot_ = nullptr;
    ViewControl& views_;
};

}  // namespace asperity
