#include "app/session/StudyResultsControl.h"

#include "app/experiment/StudyFigures.h"
#include "app/experiment/StudyResults.h"
#include "core/Error.h"
#include "core/PathText.h"
#include "core/PrintableText.h"
#include "ui/experiment/StudyResultsDialog.h"
#include "ui/window/MainWindow.h"

#include <QFile>

namespace asperity {

StudyResultsControl::StudyResultsControl(MainWindow& window)
    : window_(window)
    , work_(loadingLine(window), {.finished = [this](Drawn& drawn) { show(drawn); },
                                  .failed =
                                      [this](const std::exception_ptr& reason) {
                                          window_.complain(reasonOf(reason));
                                      }}) {}

void StudyResultsControl::show(const WithFolder& withFolder) {
    work_.start(QObject::tr("Drawing the results …"), [withFolder](Progress& /*progress*/) {
        Drawn drawn;
        withFolder([&drawn](const ExperimentFolder& folder) {
            if (folder.trials().empty()) {
                throw Error("No trial of this study is done yet");
            }
            writeStudyResults(folder);
            writeStudyFigures(folder);
            drawn.folder = folder.path().string();
            drawn.text = studyText(folder);
            for (const auto& [name, file] :
                 {std::pair("Error", "figure_12.png"), std::pair("Time", "figure_13.png"),
                  std::pair("Force against time", "figure_11.png")}) {
                drawn.figures.emplace_back(name, (folder.path() / file).string());
            }
        });
        return drawn;
    });
}

void StudyResultsControl::show(const Drawn& drawn) {
    if (dialog_ == nullptr) {
        dialog_ = new StudyResultsDialog(&window_);
    }
    std::vector<StudyFigure> figures;
    for (const auto& [name, file] : drawn.figures) {
        figures.push_back({.name = QObject::tr(name.c_str()),
                           .picture = QPixmap(QFile::decodeName(file.c_str()))});
    }
    dialog_->showResults(QString::fromStdString(printable(drawn.folder)),
                         QString::fromStdString(drawn.text), figures);
}

}  // namespace asperity
