#include "app/session/StudyChoice.h"

#include "app/program/DataFolder.h"
#include "app/session/UserFolder.h"
#include "core/Error.h"
#include "core/experiment/StudyChecks.h"
#include "core/io/experiment/StudyFile.h"
#include "core/io/experiment/TrialTable.h"
#include "ui/ShownPath.h"
#include "ui/experiment/StudyForm.h"
#include "ui/window/MainWindow.h"

#include <QStringList>

namespace asperity {

namespace {

std::filesystem::path shippedStudy() { return dataFolder() / "studies" / "positioning.toml"; }

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
    std::error_code unknown;
    return holdsStudy(folder) && std::filesystem::exists(table, unknown)
               ? readTrials(table, study)
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
            [this](const QString& file) { chooseStudy(pathOf(file)); });
    connect(&form, &StudyForm::folderChosen, this,
            [this](const QString& folder) { chooseFolder(pathOf(folder)); });
    connect(&form, &StudyForm::shown, this, &StudyChoice::show);
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
        file_ = file;
        folder_ = userFolder() / "studies" / file.stem();
        form_.showStudy(QString::fromStdString(study_->name), aboutOf(*study_));
        showFolder();
    } catch (const std::exception& error) {
        const QString why = QString::fromUtf8(error.what());
        study_ ? window_.complain(why) : form_.refuse(why);
    }
}

void StudyChoice::chooseFolder(const std::filesystem::path& folder) {
    folder_ = folder;
    if (study_) {
        showFolder();
    }
}

void StudyChoice::showFolder() {
    const auto refuse = [this](const QString& why) {
        form_.showFolder(shownPath(folder_), {});
        form_.refuse(why);
    };
    try {
        if (holdsStudy(folder_) && !holdsStudy(folder_, *study_)) {
            refuse(tr("Holds another study: choose another folder"));
            return;
        }
        const std::vector<TrialRecord> trials = trialsIn(folder_, *study_);
        if (!areInOrderOfPeople(*study_, trials)) {
            refuse(tr("Holds trials of operators of a model: choose another folder"));
            return;
        }
        const auto counting = std::ranges::count_if(trials, &TrialRecord::counts);
        form_.showFolder(shownPath(folder_),
                         trials.empty() ? tr("New: no trial is in it yet")
                                        : tr("Goes on; trials that count: %1").arg(counting));
        form_.showParticipant(participantToGoOn(*study_, trials));
        form_.refuse({});
    } catch (const std::exception& error) {
        refuse(QString::fromUtf8(error.what()));
    }
}

void StudyChoice::open() {
    if (!study_) {
        return;
    }
    work_.start(tr("Loading the study …"), [study = *study_, file = file_, folder = folder_,
                                            participant = form_.participant()](Progress& progress) {
        try {
            return std::make_shared<OpenStudy>(study, folder, participant, &progress);
        } catch (const StudyRefused& refused) {
            throw InputError(file.string(), refused.key, "expected " + refused.reason);
        }
    });
}

void StudyChoice::showResults() {
    if (!study_) {
        return;
    }
    results_.show([study = *study_, folder = folder_](const auto& read) {
        if (!holdsStudy(folder)) {
            throw Error("No trial of this study is done yet");
        }
        read(ExperimentFolder(folder, study, FolderUse::Resume));
    });
}

}  // namespace asperity
