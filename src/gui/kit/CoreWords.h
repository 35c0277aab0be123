#pragma once
#include <QString>
#include <span>
#include <string_view>

namespace velum::gui {

/// What the libraries below the window say, in the window's language: errors, warnings, stages of long work, and the
/// like. They say it in English, by the patterns of translations/CoreWords.h; what is put in them, names and what other
/// libraries say, stays as it is, numbers get the language's comma. What no pattern knows stays English. The
/// application's thread.
QString inWords(const QString& said);
QString inWords(std::string_view said);
inline QString inWords(const char* said) { return inWords(std::string_view(said)); }

/// Such a text where it is one of the patterns as a whole; else none. Nothing is cut into parts.
QString patternWords(const QString& said);

/// The patterns: English, with %1 for what is put in.
std::span<const char* const> corePatterns();

}  // namespace velum::gui
