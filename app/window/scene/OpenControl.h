#pragma once

#include "app/loading/ScanPreview.h"
#include "app/window/LongWork.h"
#include "app/window/Stage.h"
#include "app/window/scene/OpenDialog.h"
#include "app/window/scene/PreviewPane.h"
#include "app/window/scene/RecentFiles.h"
#include "app/window/scene/SceneControl.h"

#include <QPointer>
#include <QTimer>

#include <memory>
#include <optional>

namespace asperity {

class RecentMenu;

/// Opens files as a user asks for it: the dialog, with previews made in the background, and the
/// files that were opened last.
class OpenControl : public Feature {
    Q_OBJECT

public:
    explicit OpenControl(Stage& stage);

    /// Recent files and folder come from there, and go there.
    void remember(std::unique_ptr<QSettings> settings) { recent_.remember(std::move(settings)); }
    [[nodiscard]] RecentFiles& recent() { return recent_; }

    /// Shows the dialog; the window stays usable.
    void ask();
    /// The dialog; null: it is closed.
    [[nodiscard]] OpenDialog* dialog() { return dialog_; }

private:
    /// Numbers and texts of a preview, and its pictures.
    struct Looked {
        ScanPreview preview;
        OpenPreview shown;
    };

    void showRecent();
    void openRecent(int index);
    /// Looks into the file that is chosen, with the choices there are.
    void look();
    void show(Looked& looked);
    void open(const QString& file);
    [[nodiscard]] SceneOverrides overrides() const;

    SceneControl& scenes_;
    RecentFiles recent_;
    RecentMenu* menu_ = nullptr;
    QPointer<OpenDialog> dialog_;
    QString file_;                      ///< that is looked into; empty: none
    std::optional<ScaleGap> shownGap_;  ///< of that file
    QTimer soon_;  ///< so that choices that follow each other are looked at once
    std::shared_ptr<ScanPreviewer> previewer_ = std::make_shared<ScanPreviewer>();
    LongWork<Looked> work_;
};

/// A preview in words and pictures. Any thread.
[[nodiscard]] OpenPreview shownPreview(const ScanPreview& preview);

}  // namespace asperity
