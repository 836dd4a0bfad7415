#pragma once

#include <QString>

#include <string>

namespace asperity {

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

}  // namespace asperity
