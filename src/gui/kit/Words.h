#pragma once
#include <QString>
#include <span>
#include <string_view>

namespace velum::gui {

/// A text of a table in the window's language: a title, a tip, a sentence that is written once, in English, where the
/// table is. What no table has, as a name that somebody gave, stays as it is. In sources of the window such a text
/// stands in QT_TRANSLATE_NOOP("Words", ...); translations/TableWords.h lists those of tables below the window.
QString wordsOf(std::string_view text);

/// The name of an undo step in the window's language: "Hide aorta" is "Hide %1" with a name.
QString stepText(std::string_view label);
/// The beginnings of names of undo steps that go on with a name: "Hide %1".
std::span<const char* const> stepPatterns();

/// A title within a sentence: small letters, but where nouns have capital ones.
QString inSentence(const QString& title);

/// A number that was written with a decimal point, as the window shows it: "12,5 mm". @param text  numbers and units
/// alone, no names
QString localNumber(std::string_view text);

}  // namespace velum::gui
