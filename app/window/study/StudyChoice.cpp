#include "app/window/study/StudyChoice.h"

#include "app/program/DataFolder.h"
#include "app/window/RunControl.h"
#include "core/Error.h"
#include "core/experiment/Study.h"
#include "core/io/experiment/StudyFile.h"
#include "ui/shell/FileDialogs.h"
#include "ui/shell/Host.h"
#include "ui/widgets/Card.h"
#include "ui/widgets/PageParts.h"
#include "ui/widgets/ShownText.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QStringList>
#include <QVBoxLayout>

namespace asperity {

namespace {

constexpr int kMaxParticipants = 999;

QLabel* newText(const char* name, const QString& toolTip) {
    auto* label = new QLabel;
    label->setObjectName(QString::fromLatin1(name));
    label->setToolTip(toolTip);
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return label;
}

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

StudyForm::StudyForm(QWidget* parent)
    : QWidget(parent)
    , name_(newText("studyName", tr("The study that is done")))
    , about_(newText("studyAbout", tr("Tasks, materials, and trials of each participant")))
    , folder_(newText("studyFolder", tr("Where trials, tables and figures go")))
    , state_(newText("studyState", tr("What is in that folder already")))
    , participant_(new QSpinBox(this))
    , start_(pushButton(tr("Start the study"), "startStudy",
                        tr("Loads the materials; then comes the training, then one trial after the "
                           "other"),
                        Qt::TabFocus))
    , results_(pushButton(tr("Results…"), "formResults", tr("Figures and tables of that folder"),
                          Qt::TabFocus)) {
    participant_->setObjectName(QStringLiteral("studyParticipant"));
    participant_->setRange(1, kMaxParticipants);
    participant_->setToolTip(tr("Number of the participant: no names are kept. It decides on the "
                                "order of the trials"));
    auto* otherStudy =
        pushButton(tr("Other study…"), "chooseStudy", tr("A study file (TOML)"), Qt::TabFocus);
    auto* otherFolder =
        pushButton(tr("Other folder…"), "chooseStudyFolder",
                   tr("A new folder, or one with this study to continue"), Qt::TabFocus);
    auto* grid = new QGridLayout;
    grid->setColumnStretch(1, 1);
    grid->setHorizontalSpacing(10);
    const auto addRow = [&](int row, const QString& caption, QWidget* value, QWidget* button) {
        grid->addWidget(captionLabel(caption, this), row, 0, Qt::AlignTop | Qt::AlignLeft);
        grid->addWidget(value, row, 1, Qt::AlignTop);
        grid->addWidget(button, row, 2, Qt::AlignTop | Qt::AlignLeft);
    };
    addRow(0, tr("Study"), name_, otherStudy);
    grid->addWidget(about_, 1, 1, 1, 2);
    addRow(2, tr("Folder"), folder_, otherFolder);
    addRow(3, QString(), state_, results_);
    auto* person = new QHBoxLayout;
    person->addWidget(participant_);
    person->addWidget(start_);
    person->addStretch(1);
    grid->addWidget(captionLabel(tr("Participant"), this), 4, 0, Qt::AlignLeft);
    grid->addLayout(person, 4, 1, 1, 2);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(8, 6, 8, 6);
    column->addLayout(grid);
    column->addStretch(1);
    connect(otherStudy, &QPushButton::clicked, this, &StudyForm::askForStudy);
    connect(otherFolder, &QPushButton::clicked, this, &StudyForm::askForFolder);
    connect(start_, &QPushButton::clicked, this, &StudyForm::startChosen);
    connect(results_, &QPushButton::clicked, this, &StudyForm::resultsChosen);
    refuse(tr("No study is chosen"));
}

void StudyForm::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    Q_EMIT shown();
}

void StudyForm::showStudy(const QString& name, const QString& about) {
    name_->setText(name);
    about_->setText(about);
}

void StudyForm::showFolder(const QString& folder, const QString& state) {
    folder_->setText(folder);
    state_->setText(state);
}

void StudyForm::showParticipant(int participant) { participant_->setValue(participant); }

int StudyForm::participant() const { return participant_->value(); }

void StudyForm::refuse(const QString& why) {
    start_->setEnabled(why.isEmpty());
    results_->setEnabled(why.isEmpty());
    if (!why.isEmpty()) {
        state_->setText(why);
    }
}

void StudyForm::askForStudy() {
    const QString file =
        askWhatToOpen(window(), {.kind = FileKind::Study,
                                 .title = tr("Choose a study"),
                                 .filters = tr("Studies (*.toml);;All files (*)")});
    if (!file.isEmpty()) {
        Q_EMIT studyChosen(file);
    }
}

void StudyForm::askForFolder() {
    const QString folder =
        askWhichFolder(window(), {.kind = FileKind::StudyFolder,
                                  .title = tr("Choose the folder of the results"),
                                  .suggestion = folder_->text()});
    if (!folder.isEmpty()) {
        Q_EMIT folderChosen(folder);
    }
}

StudyChoice::StudyChoice(Host& host, StudyForm& form, StudyResultsControl& results)
    : host_(host)
    , form_(form)
    , results_(results)
    , work_(loadingLine(host_),
            {.finished = [this](std::shared_ptr<OpenStudy>& study) { Q_EMIT opened(study); },
             .failed = complaintIn(host_)}) {
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
        study_ ? host_.complain(why) : form_.refuse(why);
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
        form_.showFolder(shownPath(folder_), trials.empty()
                                                 ? tr("New: no trial is in it yet")
                                                 : tr("Resumes; valid trials: %1").arg(counting));
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
