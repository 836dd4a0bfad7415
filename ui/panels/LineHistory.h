#pragma once

#include <QKeyEvent>
#include <QLineEdit>

namespace asperity {

/// Whether a key is for the window's history: it undoes or redoes, and nothing typed in this line
/// can be. Qt's own lines keep both keys to themselves even then.
inline bool isForWindowHistory(const QKeyEvent& key, const QLineEdit& line) {
    return (key.matches(QKeySequence::Undo) && !line.isUndoAvailable()) ||
           (key.matches(QKeySequence::Redo) && !line.isRedoAvailable());
}

}  // namespace asperity
