#include "ui/CoreWords.h"

#include <QCoreApplication>

namespace asperity {

QString coreWords(const char* text) { return QCoreApplication::translate("asperity::core", text); }

QString coreWords(const std::string& text) { return coreWords(text.c_str()); }

}  // namespace asperity
