#include "app/window/recording/ReportControl.h"

#include "app/loading/ComparedRun.h"
#include "app/recording/Bundle.h"
#include "app/window/recording/PlaybackControl.h"
#include "core/Error.h"
#include "core/ProgramRun.h"
#include "core/Progress.h"
#include "ui/shell/Dialogs.h"
#include "ui/shell/FileDialogs.h"
#include "ui/widgets/ShownText.h"

#include <QAction>
#include <QDesktopServices>
#include <QFile>
#include <QUrl>

#include <csignal>
#include <optional>

namespace asperity {

namespace {

/// The program that the user would call: the file of this one, or beside it that of a test.
std::filesystem::path asperityProgram() {
    return std::filesystem::read_symlink("/proc/self/exe").parent_path() / "asperity";
}

/// The reason without the program's name, the last line of what it said.
std::string reasonIn(const std::string& said) {
    const std::string mark = "asperity: ";
    const std::size_t begin = said.rfind(mark);
    return begin == std::string::npos ? said : said.substr(begin + mark.size());
}

/// The name of the page in "1 run; open FOLDER/NAME.html or NAME.pdf".
std::string pageIn(const std::string& said) {
    const std::string mark = " or ";
    const std::size_t begin = said.rfind(mark) + mark.size();
    return said.substr(begin, said.rfind(".pdf") - begin) + ".html";
}

/// Another process draws the pictures of the page: the window stays responsive.
/// @return the page @throw Error; Canceled
std::filesystem::path writeReport(const std::filesystem::path& run,
                                  const std::filesystem::path& folder, Progress& progress) {
    ProgramCall call =
        trustedCall(asperityProgram(), {"report", run.string(), "--out", folder.string()});
    call.endSignal = SIGTERM;  // what it has begun is deleted
    RunningProgram program(call);
    std::optional<ProgramOutcome> outcome;
    while (!outcome) {
        if (progress.isCanceled()) {
            throw Canceled();
        }
        outcome = program.look();
    }
    if (outcome->end != ProgramEnd::Exited || outcome->exitCode != 0) {
        throw Error(reasonIn(outcome->output));
    }
    return folder / pageIn(outcome->output);
}

}  // namespace

ReportControl::ReportControl(Stage& stage)
    : Feature(stage)
    , work_(loadingLine(host_), {.finished =
                                     [this](std::filesystem::path& page) {
                                         const QString file = QFile::decodeName(page.c_str());
                                         host_.tell(tr("Report: %1").arg(shownPath(page)));
                                         QDesktopServices::openUrl(QUrl::fromLocalFile(file));
                                         Q_EMIT written(file);
                                     },
                                 .failed = complaintIn(host_)}) {
    const QAction& entry = host_.menus().add(
        {MenuName::File, 1, 70}, "report",
        {.text = tr("Report o&n a recording…"),
         .tip = tr("Write a page on a recorded run, as HTML and PDF: the recording "
                   "that is looked at, else one to choose")});
    connect(&entry, &QAction::triggered, this, &ReportControl::ask);
}

void ReportControl::ask() {
    QWidget& window = host_.widget();
    const std::filesystem::path open = runs_.openRecording();
    const std::filesystem::path run =
        open.empty() ? runOf(pathOf(askForRun(window, tr("Report on a recording")))) : open;
    if (run.empty()) {
        return;
    }
    const QString last = lastFolder(FileKind::Report);
    const std::filesystem::path parent =
        last.isEmpty() ? std::filesystem::absolute(run).parent_path() : pathOf(last);
    const std::filesystem::path suggested = parent / (runName(run) + "_report");
    askForName(&window, tr("Report on %1").arg(QString::fromStdString(runName(run))),
               tr("Folder for the report; an earlier report in it is replaced"),
               QFile::decodeName(suggested.c_str()), [this, run](const QString& folder) {
                   rememberFolderOf(FileKind::Report, folder);
                   write(run, pathOf(folder));
               });
}

void ReportControl::write(const std::filesystem::path& run, const std::filesystem::path& folder) {
    work_.start(tr("Report on %1 …").arg(QString::fromStdString(runName(run))),
                [run, folder](Progress& progress) { return writeReport(run, folder, progress); });
}

}  // namespace asperity
