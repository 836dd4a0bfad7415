#include "app/window/curve/CurveFitControl.h"

#include "app/curves/CurveFit.h"
#include "app/window/curve/CurveColumnsDialog.h"
#include "app/window/curve/CurveFitForm.h"
#include "app/window/curve/CurveFitPage.h"
#include "core/io/FileBytes.h"
#include "ui/shell/Dialogs.h"
#include "ui/shell/FileDialogs.h"
#include "ui/shell/Menus.h"
#include "ui/widgets/ShownText.h"

#include <QAction>

#include <utility>

namespace asperity {

CurveFitControl::CurveFitControl(Stage& stage)
    : Feature(stage)
    , page_(new CurveFitPage(&host_.widget()))
    , fits_(loadingLine(host_),
            {.finished = [this](Fitted& fitted) { show(fitted); },
             .failed = [this](const std::exception_ptr& reason) { complain(reason); }})
    , saves_(loadingLine(host_), {.finished =
                                      [this](std::filesystem::path& scene) {
                                          host_.tell(tr("The fit is saved"));
                                          if (!scene.empty()) {
                                              stage_.scenes().open(scene);
                                          }
                                          Q_EMIT saved();
                                      },
                                  .failed = complaintIn(host_)}) {
    host_.addWindow(*page_);
    const QAction& entry =
        host_.menus().add({MenuName::Measure, 0, 71}, "fitCurve",
                          {.text = tr("F&it measured curves…"),
                           .tip = tr("Sample and lever from measured force–distance curves")});
    connect(&entry, &QAction::triggered, this, [this] { host_.toggle(*page_); });
    connect(page_, &CurveFitPage::openChosen, this, &CurveFitControl::ask);
    connect(page_, &CurveFitPage::columnsChosen, this, &CurveFitControl::askColumns);
    connect(page_, &CurveFitPage::changed, this, &CurveFitControl::fit);
    connect(page_, &CurveFitPage::saveChosen, this, [this] { askFolder(false); });
    connect(page_, &CurveFitPage::sceneChosen, this, [this] { askFolder(true); });
}

void CurveFitControl::ask() {
    const QString file =
        askWhatToOpen(page_, {.kind = FileKind::Curve,
                              .title = tr("Open measured force–distance curves"),
                              .filters = tr("Force curves (*.jpk-force *.jpk-force-map "
                                            "*.jpk-qi-data *.jpk-qi-series *.ibw *.spm "
                                            "*.nid *.csv *.txt *.tsv *.dat *.zip);;"
                                            "All files (*)")});
    if (!file.isEmpty()) {
        open(pathOf(file));
    }
}

void CurveFitControl::askColumns() {
    if (path_.empty()) {
        ask();
        return;
    }
    auto* const dialog = new CurveColumnsDialog(path_, read_, page_);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog] { open(path_, dialog->options()); });
    dialog->open();
}

void CurveFitControl::open(const std::filesystem::path& file, const CurveReadOptions& read) {
    path_ = file;
    read_ = read;
    file_ = nullptr;
    page_->setFile({});
    page_->setWorking();
    const CycleFitOptions options = page_->form().options();
    fits_.start(tr("Opening %1 …").arg(shownPath(file.filename())),
                [file, read, options](Progress& /*progress*/) {
                    Fitted fitted{.file = std::make_shared<ForceCurveFile>(file, read),
                                  .curve = {},
                                  .isNew = true};
                    fitted.curve = fittedCurve(file.string(), *fitted.file, 0, options);
                    return fitted;
                });
}

void CurveFitControl::fit() {
    if (file_ == nullptr) {
        return;
    }
    page_->setWorking();
    fits_.start(tr("Fitting …"), [file = file_, path = path_, index = page_->index(),
                                  options = page_->form().options()](Progress& /*progress*/) {
        return Fitted{.file = file,
                      .curve = fittedCurve(path.string(), *file, index, options),
                      .isNew = false};
    });
}

void CurveFitControl::show(Fitted& fitted) {
    file_ = fitted.file;
    curve_ = std::move(fitted.curve);
    if (fitted.isNew) {
        page_->setFile(
            {.name = shownPath(path_.filename()), .count = file_->count(), .grid = file_->grid()});
    }
    page_->setCurve(curve_);
    Q_EMIT shown();
}

void CurveFitControl::complain(const std::exception_ptr& reason) {
    page_->setComplaint(reasonOf(reason));
    Q_EMIT shown();
}

void CurveFitControl::askFolder(bool opens) {
    const QString answer = askWhichFolder(
        page_, {.kind = FileKind::Fit, .title = tr("Folder for the fit and its scene")});
    if (answer.isEmpty()) {
        return;
    }
    const std::filesystem::path folder = pathOf(answer);
    if (!std::filesystem::exists(folder / "fit.json")) {
        save(folder, opens);
        return;
    }
    askWhether(page_, tr("%1 holds another fit. Replace it?").arg(shownPath(folder)), tr("Replace"),
               [this, folder, opens] { save(folder, opens); });
}

void CurveFitControl::save(const std::filesystem::path& folder, bool opens) {
    saves_.start(tr("Saving the fit …"),
                 [folder, opens, curve = curve_, path = path_](Progress& /*progress*/) mutable {
                     curve.sha256 = sha256Of(FileBytes(path));
                     OutputFolder out(folder, fitFolder(), true);
                     out.collect([&curve](const std::filesystem::path& collected) {
                         writeFitFiles(collected, curve);
                     });
                     out.commit();
                     return opens ? folder / "scene.toml" : std::filesystem::path();
                 });
}

}  // namespace asperity
