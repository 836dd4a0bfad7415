#pragma once

#include "core/SiFormat.h"

#include <QLocale>
#include <QString>

#include <filesystem>
#include <optional>
#include <string>

namespace asperity {

/// A number as a user types it, with the decimal point of files ("0.5", "1e-6") or the separator of
/// the user's own language ("0,5"). Separators of thousands are refused: in another language they
/// are decimal ones. Empty: it is no finite number.
[[nodiscard]] std::optional<double> numberFromText(const QString& text,
                                                   const QLocale& locale = QLocale());

/// A value in the unit that suits its size: "12.3 nm". Lengths are no finer than a picometer: no
/// instrument knows them better. @param unit SI
[[nodiscard]] QString siText(double value, const char* unit);

/// Three digits in a given unit, of constant width.
[[nodiscard]] QString threeDigits(double value, const SiScale& scale);

/// From now on C functions write and read numbers as in files whatever the user's language. Qt sets
/// the user's locale when the application is made: to be called right after that.
void keepDecimalPoint();

/// A share in percent with two digits, whole numbers from ten on: "0.12", "7.0", "295".
[[nodiscard]] inline QString percentText(double share) {
    const double percent = 100.0 * share;
    if (percent >= 1.0) {
        return QString::number(percent, 'f', percent < 9.95 ? 1 : 0);
    }
    return QString::number(percent, 'g', 2);
}

/// A text of core as the window shows it: translated, in the one context "asperity::core".
///
/// core does not know Qt and marks no text, so that lupdate finds none there. A translation file
/// (.ts) names them in a context of that name, one <message> a text, whose <source> is the text as
/// the table in core has it: a row of kEnumTable<...>, kValidityTraits, the knobs of
/// listSettings(). CoreWordsTest prints them in that form:
/// --gtest_filter='CoreWords.ListsThemForATranslationFile'. A sentence that core puts together with
/// numbers is no text of a table and stays as core has it.
[[nodiscard]] QString coreWords(const char* text);
[[nodiscard]] QString coreWords(const std::string& text);

/// A path for people: on one line, see printable().
[[nodiscard]] QString shownPath(const std::filesystem::path& path);

/// The path that a file dialog returned, in the bytes of the file system.
[[nodiscard]] std::filesystem::path pathOf(const QString& file);

}  // namespace asperity
