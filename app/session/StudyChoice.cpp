#include "app/session/StudyChoice.h"

#include "app/program/DataFolder.h"
#include "app/session/UserFolder.h"
#include "core/Error.h"
#include "core/PrintableText.h"
#include "core/experiment/StudyChecks.h"
#include "core/io/experiment/StudyFile.h"
#include "core/io/experiment/TrialTable.h"
#include "ui/experiment/StudyForm.h"
#include "ui/window/MainWindow.h"

#include <QFile>
#include <QStringList>

namespace asperity {

namespace {

std::filesystem::path shippedStudy() { return dataFolder() / "studies" / "positioning.toml"; }

QString textOf(const std::filesystem::path& path) {
    return QString::fromStdString(printable(path.string()));
}

/// Tasks and trials, in a few words.
QString aboutOf(const Study& study) {
    QStringList tasks;
    for (const StudyTask& task : study.tasks) {
        tasks << StudyForm::tr("%1 %2").arg(QString::fromLatin1(keyOf(task.kind)),
                                            QString::fromLatin1(nameOf(task.kind)));
    }
    return StudyForm::tr(
               "%1. Materials: %2. Each participant has %3 trials, and %4 s to try the program.")
        .arg(tasks.join(", "))
        .arg(study.materials.size())
        .arg(planTrials(study, 1, 1).size())
        .arg(study.training);
}

/// What lies in its folder. @throw InputError
std::vector<TrialRecord> trialsIn(const std::filesystem::path& folder, const Study& study) {
    const std::filesystem::path table = folder / "trials.csv";
    return holdsStudy(folder) && std::filesystem::exists(table) ? readTrials(table, study)
                                                                : std::vector<TrialRecord>();
}

}  // namespace

StudyChoice::StudyChoice(MainWindow& window, StudyForm& form, StudyResultsControl& results)
    : window_(window)
    , form_(form)
    , results_(results)
    , work_(
          loadingLine(window),
          {.finished = [this](std::shared_ptr<OpenStudy>& study) { Q_EMIT opened(study); },
           .failed =
               [this](const std::exception_ptr& reason) { window_.complain(reasonOf(reason)); }}) {
    connect(&form, &StudyForm::studyChosen, this,
            [this](const QString& file) { chooseStudy(QFile::encodeName(file).toStdString()); });
    connect(&form, &StudyForm::folderChosen, this, [this](const QString& folder) {
        chooseFolder(QFile::encodeName(folder).toStdString());
    });
    connect(&form, &StudyForm::startChosen, this, &StudyChoice::open);
    connect(&form, &StudyForm::resultsChosen, this, &StudyChoice::showResults);
}

void StudyChoice::show() {
    if (study_) {
        showFolder();
    } else {
        chooseStudy(shippedStudy());
    }
}

void StudyChoice::chooseStudy(const std::filesystem::path& file) {
    try {
        study_ = readStudy(file);
        folder_ = userFolder() / "studies" / file.stem();
        form_.showStudy(QString::fromStdString(study_->name), aboutOf(*study_));
        showFolder();
    } catch (const Error& error) {
        window_.complain(QString::fromUtf8(error.what()));
    }
}

void StudyChoice::chooseFolder(const std::filesystem::path& folder) {
    folder_ = folder;
    showFolder();
}

void StudyChoice::showFolder() {
    try {
        const std::vector<TrialRecord> trials = trialsIn(folder_, *study_);
        const auto counting = std::ranges::count_if(trials, &TrialRecord::counts);
        form_.showFolder(textOf(folder_), trials.empty()
                                              ? tr("New: no trial is in it yet")
                                              : tr("Goes on: %1 trials are in it").arg(counting));
        form_.showParticipant(participantToGoOn(*study_, trials));
        form_.refuse({});
    } catch (const Error& error) {
        form_.showFolder(textOf(folder_), {});
        form_.refuse(tr("Holds another study: %1").arg(QString::fromUtf8(error.what())));
    }
}

void StudyChoice::open() {
    work_.start(tr("Loading the study …"), [study = *study_, folder = folder_,
                                            participant = form_.participant()](Progress& progress) {
        return std::make_shared<OpenStudy>(study, folder, participant, &progress);
    });
}

void StudyChoice::showResults() {
    results_.show([study = *study_, folder = folder_](const auto& read) {
        if (!holdsStudy(folder)) {
            throw Error("No trial of this study is done yet");
        }
        read(ExperimentFolder(folder, study, FolderUse::Resume));
    });
}

}  // namespace asperity
