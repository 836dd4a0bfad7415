#include "app/session/MessageControl.h"

#include "core/PrintableText.h"
#include "core/words/SceneWords.h"
#include "ui/CoreWords.h"
#include "ui/panels/MessageLog.h"
#include "ui/window/MainWindow.h"

#include <utility>

namespace asperity {

MessageControl::MessageControl(MainWindow& window, RunControl& runs)
    : window_(window), runs_(runs) {
    connect(&runs, &RunControl::begun, this, [this] {
        fault_ = Fault::None;
        listNotes();
    });
    connect(&runs, &RunControl::modelFitted, this, &MessageControl::listNotes);
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

/// The same scan of another material has the same notes on its heights. Those on the force come
/// once its model is known.
void MessageControl::listNotes() {
    const LoadedScene& loaded = runs_.run()->loaded();
    if (loaded.notes != heightNotes_) {
        forceNotes_.clear();
    }
    list(loaded.notes, heightNotes_);
    if (!loaded.needs.pending) {
        list(forceNotes(loaded.scene, loaded.needs), forceNotes_);
    }
}

void MessageControl::list(const std::vector<std::string>& notes, std::vector<std::string>& listed) {
    if (notes != listed) {
        listed = notes;
        for (const std::string& note : notes) {
            window_.messages().add(MessageKind::Note, QString::fromStdString(printable(note)));
        }
    }
}

}  // namespace asperity
