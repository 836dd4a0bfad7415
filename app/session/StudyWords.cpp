#include "app/session/StudyWords.h"

#include "ui/CoreWords.h"
#include "ui/NumberText.h"

namespace asperity {

namespace {

QString wordsOf(const std::string& name) { return QString::fromStdString(name).replace('_', ' '); }

QString noteOf(const TrialRecord& record) {
    if (record.fault != Fault::None) {
        return TrialPanel::tr("does not count: %1").arg(coreWords(nameOf(record.fault)));
    }
    if (!record.struckOut.empty()) {
        return TrialPanel::tr("struck out: %1").arg(QString::fromStdString(record.struckOut));
    }
    return record.timedOut ? TrialPanel::tr("the time was over") : QString();
}

/// "Task B on polystyrene", with the lever where there are several.
QString taskTitle(const Study& study, const PlannedTrial& trial) {
    const QString title = TrialPanel::tr("Task %1 on %2")
                              .arg(QString::fromLatin1(keyOf(study.tasks.at(trial.task).kind)),
                                   wordsOf(study.materials.at(trial.material).name));
    return study.levers.size() == 1 ? title
                                    : TrialPanel::tr("%1, lever %2")
                                          .arg(title, wordsOf(study.levers.at(trial.lever).name));
}

/// What is to be done at the target.
QString taskSentence(TaskKind kind) {
    switch (kind) {
    case TaskKind::Above:
        return TrialPanel::tr("Hold the tip at the green cross-hair, above the surface.");
    case TaskKind::On:
        return TrialPanel::tr("Bring the tip onto the surface, at the green cross-hair.");
    case TaskKind::Below:
        return TrialPanel::tr("Press the tip into the surface, down to the green cross-hair.");
    }
    return {};
}

/// "Participant 1, trial 3 of 24", with the attempt where it is not the first.
QString placeWords(const ParticipantStudy& person, const PlannedTrial& trial) {
    const int ofPerson = (trial.number - 1) % person.count() + 1;
    const QString place = TrialPanel::tr("Participant %1  ·  trial %2 of %3")
                              .arg(person.participant())
                              .arg(ofPerson)
                              .arg(person.count());
    return trial.attempt == 1 ? place
                              : TrialPanel::tr("%1  ·  attempt %2").arg(place).arg(trial.attempt);
}

}  // namespace

TrialStage stageWords(const OpenStudy& study, const StudyMoment& moment) {
    const StudyPhase phase = moment.phase;
    const ParticipantStudy& person = study.person;
    const QString task = taskSentence(study.study.tasks.at(moment.trial.task).kind);
    TrialStage stage{.place = placeWords(person, moment.trial),
                     .done = person.done(),
                     .count = person.count(),
                     .task = taskTitle(study.study, moment.trial),
                     .canPause = phase != StudyPhase::Finished && phase != StudyPhase::Training,
                     .isPaused = phase == StudyPhase::Paused,
                     .canStrikeOut =
                         moment.canStrikeOut && phase != StudyPhase::Trial && !moment.isDrawing,
                     .canShowResults = phase != StudyPhase::Trial && !moment.isDrawing};
    switch (phase) {
    case StudyPhase::Training:
        stage.place = TrialPanel::tr("Participant %1  ·  training").arg(person.participant());
        stage.task = TrialPanel::tr("Try the program");
        stage.instruction =
            TrialPanel::tr("Move the tip to the green cross-hair and back, touch the surface, turn "
                           "the view. Nothing is kept.");
        stage.action = TrialPanel::tr("Go to the trials  (Enter)");
        break;
    case StudyPhase::Ready:
        stage.instruction =
            moment.refusal.isEmpty()
                ? TrialPanel::tr("%1 The clock starts with Enter; until then the tip rests.")
                      .arg(task)
                : moment.refusal;
        stage.action = TrialPanel::tr("Begin  (Enter)");
        break;
    case StudyPhase::Trial:
        stage.instruction = TrialPanel::tr("%1 Press Enter when you are satisfied.").arg(task);
        stage.action = TrialPanel::tr("Done  (Enter)");
        break;
    case StudyPhase::Result:
        stage.instruction = TrialPanel::tr("The tip stays where it was at the end.");
        stage.action = TrialPanel::tr("Next trial  (Enter)");
        break;
    case StudyPhase::Paused:
        stage.instruction = TrialPanel::tr("The study rests.");
        stage.action = TrialPanel::tr("Go on  (Enter)");
        break;
    case StudyPhase::Finished:
        stage.place =
            TrialPanel::tr("Participant %1  ·  all trials are done").arg(person.participant());
        stage.task = TrialPanel::tr("Thank you");
        stage.instruction = TrialPanel::tr("Results shows what came of all trials.");
        stage.action = TrialPanel::tr("Leave the study  (Enter)");
        break;
    case StudyPhase::Choosing:
        break;
    }
    return stage;
}

TrialResult resultWords(const TrialRecord& record) {
    return {.name = TrialPanel::tr("last trial: %1")
                        .arg(record.counts() ? TrialPanel::tr("it counts")
                                             : TrialPanel::tr("it comes again")),
            .error = siText(record.error, "m"),
            .share = QStringLiteral("%1 %").arg(record.errorPercent, 0, 'f', 1),
            .time = QStringLiteral("%1 s").arg(record.time, 0, 'f', 1),
            .force = siText(record.largestForce, "N"),
            .note = noteOf(record)};
}

}  // namespace asperity
