#pragma once
#include <QString>
#include <span>

namespace velum::gui {

/// A language in which the window speaks.
struct Language {
  const char* code;  ///< ISO 639: "de"
  const char* name;  ///< in the language itself: "Deutsch"
};
/// English first, which needs no translation.
std::span<const Language> languages();

/// Makes the application speak a language from now on: for widgets that are made later. Numbers are written as the
/// system's language does where that is the one, else as the language's own land does. C's functions keep their point.
/// The application's thread, once. @param code  of a language; empty: the system's, English where that is none of ours
/// @throw ArgumentError for an unknown code
void speak(const QString& code);

}  // namespace velum::gui
