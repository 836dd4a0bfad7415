#include "ui/experiment/StudyForm.h"

#include "ui/measure/PageParts.h"
#include "ui/panels/Card.h"

#include <QFileDialog>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

namespace asperity {

namespace {

constexpr int kMostParticipants = 999;

QLabel* newText(const char* name, const QString& toolTip) {
    auto* label = new QLabel;
    label->setObjectName(QString::fromLatin1(name));
    label->setToolTip(toolTip);
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return label;
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
    participant_->setRange(1, kMostParticipants);
    participant_->setToolTip(tr("Number of the participant: no names are kept. It decides on the "
                                "order of the trials"));
    auto* otherStudy =
        pushButton(tr("Other study…"), "chooseStudy", tr("A study file (TOML)"), Qt::TabFocus);
    auto* otherFolder =
        pushButton(tr("Other folder…"), "chooseStudyFolder",
                   tr("A new folder, or one in which this study goes on"), Qt::TabFocus);
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
    const QString file = QFileDialog::getOpenFileName(window(), tr("Choose a study"), QString(),
                                                      tr("Studies (*.toml);;All files (*)"));
    if (!file.isEmpty()) {
        Q_EMIT studyChosen(file);
    }
}

void StudyForm::askForFolder() {
    const QString folder = QFileDialog::getExistingDirectory(
        window(), tr("Choose the folder of the results"), folder_->text());
    if (!folder.isEmpty()) {
        Q_EMIT folderChosen(folder);
    }
}

}  // namespace asperity
