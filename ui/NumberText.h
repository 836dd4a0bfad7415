#pragma once

#include "core/SiFormat.h"

#include <QLocale>
#include <QString>

#include <optional>

namespace asperity {

/// A number as a user types it, with the decimal point of files ("0.5", "1e-6") or the separator of
/// the user's own language ("0,5"). Separators of thousands are refused: in another language they
/// are decimal ones. Empty: it is no finite number.
[[nodiscard]] std::optional<double> numberFromText(const QString& text,
                                                   const QLocale& locale = QLocale());

/// A value in the unit that suits its size: "12.3 nm". @param unit SI
[[nodiscard]] QString siText(double value, const char* unit);

/// Three digits in a given unit, of constant width.
[[nodiscard]] QString threeDigits(double value, const SiScale& scale);

/// From now on C functions write and read numbers as in files whatever the user's language. Qt sets
/// the user's locale when the application is made: to be called right after that.
void keepDecimalPoint();

}  // namespace asperity
