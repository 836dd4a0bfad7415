#include "app/session/MessageControl.h"

#include "ui/CoreWords.h"
#include "ui/panels/MessageLog.h"
#include "ui/window/MainWindow.h"

#include <utility>

namespace asperity {

MessageControl::MessageControl(MainWindow& window, RunControl& runs)
    : window_(window), runs_(runs) {
    connect(&runs, &RunControl::begun, this, &MessageControl::listNotes);
}

/// A device that was chosen before it was there is no error.
void MessageControl::advance() {
    const Fault now = runs_.run()->loop().snapshot().sample.output.fault;
    const Fault before = std::exchange(fault_, now);
    if (now == before) {
        return;
    }
    MessageLog& log = window_.messages();
    if (now == Fault::None) {
        log.add(MessageKind::Note, tr("The fault was reset"));
    } else {
        log.add(runs_.run()->awaitsDevice() ? MessageKind::Note : MessageKind::Error,
                tr("Fault, forces are off: %1").arg(coreWords(nameOf(now))));
    }
}

/// The same scan of another material has the same notes.
void MessageControl::listNotes() {
    fault_ = Fault::None;
    QStringList notes;
    for (const std::string& note : notesOn(runs_.run()->loaded())) {
        notes << QString::fromStdString(note);
    }
    if (notes != notes_) {
        notes_ = notes;
        for (const QString& note : notes) {
            window_.messages().add(MessageKind::Note, note);
        }
    }
}

}  // namespace asperity
