#include "gui/kit/Words.h"

#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>
#include <algorithm>
#include <string>
#include <string_view>

#include "gui/kit/CoreWords.h"

namespace velum::gui {

namespace {

/// Names of undo steps that are given where the change is: below the window, or by a hand in it.
[[maybe_unused]] constexpr const char* kStepNames[] = {
    QT_TRANSLATE_NOOP("Words", "Add cut"),
    QT_TRANSLATE_NOOP("Words", "Add gradient point"),
    QT_TRANSLATE_NOOP("Words", "Add opacity point"),
    QT_TRANSLATE_NOOP("Words", "Align cut"),
    QT_TRANSLATE_NOOP("Words", "Change range of types"),
    QT_TRANSLATE_NOOP("Words", "Change tint"),
    QT_TRANSLATE_NOOP("Words", "Choose channel"),
    QT_TRANSLATE_NOOP("Words", "Choose paper"),
    QT_TRANSLATE_NOOP("Words", "Cut to pull out of"),
    QT_TRANSLATE_NOOP("Words", "Fade what has no label"),
    QT_TRANSLATE_NOOP("Words", "Follow the view"),
    QT_TRANSLATE_NOOP("Words", "Hide labels"),
    QT_TRANSLATE_NOOP("Words", "Hide model"),
    QT_TRANSLATE_NOOP("Words", "Hide the table"),
    QT_TRANSLATE_NOOP("Words", "Hide this tissue"),
    QT_TRANSLATE_NOOP("Words", "Keep in view"),
    QT_TRANSLATE_NOOP("Words", "Labels on sections"),
    QT_TRANSLATE_NOOP("Words", "Let be hidden"),
    QT_TRANSLATE_NOOP("Words", "Let sheet through"),
    QT_TRANSLATE_NOOP("Words", "Lock the view"),
    QT_TRANSLATE_NOOP("Words", "Move gradient point"),
    QT_TRANSLATE_NOOP("Words", "Move key of camera"),
    QT_TRANSLATE_NOOP("Words", "Move mark"),
    QT_TRANSLATE_NOOP("Words", "Move opacity point"),
    QT_TRANSLATE_NOOP("Words", "Move point of mark"),
    QT_TRANSLATE_NOOP("Words", "Move words of mark"),
    QT_TRANSLATE_NOOP("Words", "Plane through three points"),
    QT_TRANSLATE_NOOP("Words", "Protect from sheet"),
    QT_TRANSLATE_NOOP("Words", "Pull sheet"),
    QT_TRANSLATE_NOOP("Words", "Push sheet"),
    QT_TRANSLATE_NOOP("Words", "Remove force"),
    QT_TRANSLATE_NOOP("Words", "Remove gradient point"),
    QT_TRANSLATE_NOOP("Words", "Remove opacity point"),
    QT_TRANSLATE_NOOP("Words", "Remove pin"),
    QT_TRANSLATE_NOOP("Words", "Remove stroke"),
    QT_TRANSLATE_NOOP("Words", "Show labels"),
    QT_TRANSLATE_NOOP("Words", "Show model"),
    QT_TRANSLATE_NOOP("Words", "Show the table"),
    QT_TRANSLATE_NOOP("Words", "Show thinned"),
    QT_TRANSLATE_NOOP("Words", "Show this tissue"),
    QT_TRANSLATE_NOOP("Words", "Sketch what to let through"),
    QT_TRANSLATE_NOOP("Words", "Sketch what to protect"),
    QT_TRANSLATE_NOOP("Words", "Stop gradient opacity"),
    QT_TRANSLATE_NOOP("Words", "Turn cut off"),
    QT_TRANSLATE_NOOP("Words", "Turn cut on"),
    QT_TRANSLATE_NOOP("Words", "Turn force"),
    QT_TRANSLATE_NOOP("Words", "Use gradient opacity"),
};

// The longer of two that begin alike comes first.
constexpr const char* kStepPatterns[] = {
    QT_TRANSLATE_NOOP("Words", "Add force to %1"),
    QT_TRANSLATE_NOOP("Words", "Add to %1"),
    QT_TRANSLATE_NOOP("Words", "Add %1"),
    QT_TRANSLATE_NOOP("Words", "Change growth of %1"),
    QT_TRANSLATE_NOOP("Words", "Change %1"),
    QT_TRANSLATE_NOOP("Words", "Colour %1"),
    QT_TRANSLATE_NOOP("Words", "Cut %1"),
    QT_TRANSLATE_NOOP("Words", "Draw membrane to %1"),
    QT_TRANSLATE_NOOP("Words", "Duplicate %1"),
    QT_TRANSLATE_NOOP("Words", "End solo of %1"),
    QT_TRANSLATE_NOOP("Words", "Forget %1"),
    QT_TRANSLATE_NOOP("Words", "Ghosts of %1"),
    QT_TRANSLATE_NOOP("Words", "Grow on: %1"),
    QT_TRANSLATE_NOOP("Words", "Hide %1"),
    QT_TRANSLATE_NOOP("Words", "Keep %1"),
    QT_TRANSLATE_NOOP("Words", "Leave of %1"),
    QT_TRANSLATE_NOOP("Words", "Leave %1"),
    QT_TRANSLATE_NOOP("Words", "Let follow the group: %1"),
    QT_TRANSLATE_NOOP("Words", "Let follow %1"),
    QT_TRANSLATE_NOOP("Words", "Let go %1"),
    QT_TRANSLATE_NOOP("Words", "List in legend: %1"),
    QT_TRANSLATE_NOOP("Words", "Lit sphere of %1"),
    QT_TRANSLATE_NOOP("Words", "Name of %1"),
    QT_TRANSLATE_NOOP("Words", "No force of %1"),
    QT_TRANSLATE_NOOP("Words", "Not this: %1"),
    QT_TRANSLATE_NOOP("Words", "Opacity of %1"),
    QT_TRANSLATE_NOOP("Words", "Palette's colour of %1"),
    QT_TRANSLATE_NOOP("Words", "Protect by membrane: %1"),
    QT_TRANSLATE_NOOP("Words", "Pull out %1"),
    QT_TRANSLATE_NOOP("Words", "Put back %1"),
    QT_TRANSLATE_NOOP("Words", "Remove %1"),
    QT_TRANSLATE_NOOP("Words", "Rename %1"),
    QT_TRANSLATE_NOOP("Words", "Reset %1"),
    QT_TRANSLATE_NOOP("Words", "Set %1"),
    QT_TRANSLATE_NOOP("Words", "Show as material: %1"),
    QT_TRANSLATE_NOOP("Words", "Show solid: %1"),
    QT_TRANSLATE_NOOP("Words", "Show whole %1"),
    QT_TRANSLATE_NOOP("Words", "Show %1"),
    QT_TRANSLATE_NOOP("Words", "Smooth %1"),
    QT_TRANSLATE_NOOP("Words", "Solo %1"),
    QT_TRANSLATE_NOOP("Words", "Spare %1"),
    QT_TRANSLATE_NOOP("Words", "Style of lettering: %1"),
    QT_TRANSLATE_NOOP("Words", "Take out of legend: %1"),
};

/// Those whose rest is a word of the program; of all others it is a name of the user's.
constexpr std::string_view kOfProgramsWords[] = {"Add %1", "Change %1", "Cut %1", "Remove %1", "Reset %1", "Set %1"};

/// "3 structures", for which it stands where there are too many names.
bool isCount(const QString& rest) { return !rest.isEmpty() && rest[0].isDigit(); }

QString translated(const std::string& text) { return QCoreApplication::translate("Words", text.c_str()); }

}  // namespace

QString wordsOf(std::string_view text) { return translated(std::string(text)); }

std::span<const char* const> stepPatterns() { return kStepPatterns; }

QString stepText(std::string_view label) {
  QString plain = QString::fromUtf8(label.data(), qsizetype(label.size())), whole = wordsOf(label);
  if (whole != plain) return whole;
  if (QString words = patternWords(plain); !words.isEmpty()) return words;
  for (const char* pattern : kStepPatterns) {
    QString said = translated(pattern), beginning = QString(pattern).chopped(2);
    if (said == pattern || !plain.startsWith(beginning)) continue;
    QString rest = plain.mid(beginning.size());
    bool isName = std::ranges::count(kOfProgramsWords, std::string_view(pattern)) == 0 && !isCount(rest);
    return said.arg(isName ? rest : inWords(rest));
  }
  return plain;
}

QString inSentence(const QString& title) { return QLocale().language() == QLocale::German ? title : title.toLower(); }

QString localNumber(std::string_view text) {
  static const QRegularExpression point("(?<=\\d)\\.(?=\\d)");
  QString shown = QString::fromUtf8(text.data(), qsizetype(text.size()));
  QString comma = QLocale().decimalPoint();
  return comma == "." ? shown : shown.replace(point, comma);
}

}  // namespace velum::gui
