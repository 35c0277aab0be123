#include "gui/kit/CoreWords.h"

#include <QCoreApplication>
#include <QHash>
#include <QList>
#include <QRegularExpression>
#include <algorithm>

#include "../translations/CoreWords.h"
#include "gui/kit/Text.h"
#include "gui/kit/Words.h"

namespace velum::gui {

namespace {

/// What is too short to be told from code where it is written: words that are put into messages, and numbers of things.
constexpr const char* kPutIn[] = {
    QT_TRANSLATE_NOOP("Core", "%1 (libraries say: %2)"),
    QT_TRANSLATE_NOOP("Core", "%1 structures"),
    QT_TRANSLATE_NOOP("Core", "%1 types"),
    QT_TRANSLATE_NOOP("Core", "%1 marks"),
    QT_TRANSLATE_NOOP("Core", "%1 rows"),
    QT_TRANSLATE_NOOP("Core", "%1 numbers"),
    QT_TRANSLATE_NOOP("Core", "%1 frames"),
    QT_TRANSLATE_NOOP("Core", ": %1 by %2"),
    QT_TRANSLATE_NOOP("Core", ", %1 by %2"),
    QT_TRANSLATE_NOOP("Core", "brick"),
    QT_TRANSLATE_NOOP("Core", "bricks"),
    QT_TRANSLATE_NOOP("Core", "volume"),
    QT_TRANSLATE_NOOP("Core", "surface"),
    QT_TRANSLATE_NOOP("Core", "model"),
    QT_TRANSLATE_NOOP("Core", "none"),
    QT_TRANSLATE_NOOP("Core", "tile"),
    QT_TRANSLATE_NOOP("Core", "strip"),
    QT_TRANSLATE_NOOP("Core", "quote"),
    QT_TRANSLATE_NOOP("Core", "bracket"),
    QT_TRANSLATE_NOOP("Core", "labels"),
    QT_TRANSLATE_NOOP("Core", "the file is prestack"),
    QT_TRANSLATE_NOOP("Core", "distance"),
    QT_TRANSLATE_NOOP("Core", "angle"),
    QT_TRANSLATE_NOOP("Core", "path"),
    QT_TRANSLATE_NOOP("Core", "area"),
    QT_TRANSLATE_NOOP("Core", "arrow"),
    QT_TRANSLATE_NOOP("Core", "label"),
    QT_TRANSLATE_NOOP("Core", "name"),
    QT_TRANSLATE_NOOP("Core", "circle"),
    QT_TRANSLATE_NOOP("Core", "box"),
    QT_TRANSLATE_NOOP("Core", "region"),
    QT_TRANSLATE_NOOP("Core", "profile"),
    QT_TRANSLATE_NOOP("Core", "preset"),
    QT_TRANSLATE_NOOP("Core", "finish"),
    QT_TRANSLATE_NOOP("Core", "look"),
    QT_TRANSLATE_NOOP("Core", "style"),
    QT_TRANSLATE_NOOP("Core", "window"),
    QT_TRANSLATE_NOOP("Core", "lit sphere"),
    QT_TRANSLATE_NOOP("Core", "supported"),
    QT_TRANSLATE_NOOP("Core", "known"),
    // What the system says most.
    QT_TRANSLATE_NOOP("Core", "No such file or directory"),
    QT_TRANSLATE_NOOP("Core", "Permission denied"),
    QT_TRANSLATE_NOOP("Core", "No space left on device"),
    QT_TRANSLATE_NOOP("Core", "Is a directory"),
    QT_TRANSLATE_NOOP("Core", "Read-only file system"),
    QT_TRANSLATE_NOOP("Core", "Input/output error"),
};

QString ofCore(const QString& text) { return QCoreApplication::translate("Core", text.toUtf8().constData()); }

/// Whether it is numbers and units alone, as "1.5 x 2.0 mm".
bool isNumeric(const QString& text) {
  static const QRegularExpression numeric(
      R"(\A[-+]?\d+(\.\d+)?(e[-+]?\d+)?( ?[%°a-zA-Zµ²³/]{1,5})?(( x | \.\. | )[-+]?\d+(\.\d+)?( ?[%°a-zA-Zµ²³/]{1,5})?)*\z)");
  return numeric.match(text).hasMatch();
}

/// The words in which something stands that is translated by a list of its own: its words are names elsewhere.
constexpr const char* kNoMemoryFor = "the driver has no memory for %1";

QString ofMemory(const QString& purpose) { return QCoreApplication::translate("Memory", purpose.toUtf8().constData()); }

constexpr qsizetype kFewLetters = 12, kLongest = 4000;

/// A pattern, taken to pieces.
class Pattern {
 public:
  explicit Pattern(const char* english) : mEnglish(english) {
    static const QRegularExpression place("%([1-9])");
    QString expression;
    qsizetype at = 0;
    for (auto found = place.globalMatch(mEnglish); found.hasNext();) {
      QRegularExpressionMatch match = found.next();
      mParts << mEnglish.mid(at, match.capturedStart() - at);
      mPlaces << match.captured(1).toInt();
      at = match.capturedEnd();
    }
    mParts << mEnglish.mid(at);
    for (const QString& part : mParts) mLetters += part.size();
  }

  const QString& english() const { return mEnglish; }
  /// How much of it is no place.
  qsizetype letters() const { return mLetters; }
  bool beginsWithPlace() const { return mParts.first().isEmpty(); }

  /// What stands in its places, by their numbers. @return false where the text is none of this pattern
  bool match(const QString& text, QStringList& values) const {
    if (text.size() < mLetters || !text.startsWith(mParts.first()) || !text.endsWith(mParts.last())) return false;
    if (mPlaces.isEmpty()) return text == mEnglish;
    qsizetype at = 0;
    for (const QString& part : mParts) {
      at = text.indexOf(part, at);
      if (at < 0) return false;
      at += part.size();
    }
    QRegularExpressionMatch found = expression().match(text);
    if (!found.hasMatch()) return false;
    // Else "FILE: ..." would be the thing of which the rest speaks, and all that ends in "types" a number of them.
    if (beginsWithPlace() && !mParts[1].startsWith(':') && found.captured(1).contains(": ")) return false;
    bool isShort = mLetters < kFewLetters && (beginsWithPlace() || !mEnglish[0].isLetter());
    if (isShort && !isNumeric(found.captured(1))) return false;
    values.clear();
    for (qsizetype i = 0; i < mPlaces.size(); ++i) {
      while (values.size() < mPlaces[i]) values << QString();
      values[mPlaces[i] - 1] = found.captured(int(i) + 1);
    }
    return true;
  }

 private:
  const QRegularExpression& expression() const {
    if (!mExpression.pattern().isEmpty()) return mExpression;
    QString text = "\\A" + QRegularExpression::escape(mParts.first());
    // Of two places side by side the second one is an addition that may be missing.
    for (qsizetype i = 1; i < mParts.size(); ++i)
      text += (mParts[i].isEmpty() && i + 1 < mParts.size() ? "(.*)" : "(.*?)") + QRegularExpression::escape(mParts[i]);
    mExpression.setPattern(text + "\\z");
    mExpression.setPatternOptions(QRegularExpression::DotMatchesEverythingOption);
    return mExpression;
  }

  QString mEnglish;
  QStringList mParts;
  QList<int> mPlaces;
  qsizetype mLetters = 0;
  mutable QRegularExpression mExpression;
};

/// Those that say most come first, so that none takes what another one says better.
const std::vector<Pattern>& patterns() {
  static const std::vector<Pattern> all = [] {
    std::vector<Pattern> list(std::begin(kCoreWords), std::end(kCoreWords));
    for (const char* more : kPutIn) list.emplace_back(more);
    std::ranges::stable_sort(list, std::ranges::greater(), &Pattern::letters);
    return list;
  }();
  return all;
}

QString valueWords(const QString& value) {
  static const QRegularExpression quoted("\\A'([^']*)'\\z");
  if (isNumeric(value)) return localNumber(value.toStdString());
  if (auto found = quoted.match(value); found.hasMatch())
    return QCoreApplication::translate("Core", "'%1'").arg(found.captured(1));
  return inWords(value);
}

/// A translation with what is put in.
QString filled(const QString& text, const QStringList& values) {
  QString out;
  for (qsizetype i = 0; i < text.size(); ++i) {
    int place = text[i] == '%' && i + 1 < text.size() ? text[i + 1].digitValue() : -1;
    if (place < 1 || place > values.size()) {
      out += text[i];
      continue;
    }
    // What stands in quotes is a name, or a word of a script.
    bool isQuoted = out.endsWith(QChar(0x201e));
    out += isQuoted ? values[place - 1] : valueWords(values[place - 1]);
    ++i;
  }
  return out;
}

/// A text by those patterns that do, or do not, begin with what is put in. @return none where no pattern is it
QString byPattern(const QString& said, bool beginsWithPlace) {
  QStringList values;
  for (const Pattern& pattern : patterns()) {
    if (pattern.beginsWithPlace() != beginsWithPlace || !pattern.match(said, values)) continue;
    QString words = ofCore(pattern.english());
    if (words == pattern.english()) continue;
    if (pattern.english().startsWith(kNoMemoryFor)) values[0] = ofMemory(values[0]);
    return filled(words, values);
  }
  return {};
}

/// Lists of names and the like: to look at each part of each part would take long.
bool hasManyMarks(const QString& said) {
  constexpr qsizetype kMany = 24;
  return said.count(", ") + said.count("; ") + said.count(": ") > kMany;
}

/// A text behind which something is added: ", not 20: there are no more". @return none where nothing is
QString withTail(const QString& said) {
  if (hasManyMarks(said)) return {};
  for (qsizetype at = said.size() - 1; at > 0; --at) {
    bool isMark = said[at] == ',' || said[at] == ';' || said[at] == ':' || (said[at] == ' ' && said.mid(at, 2) == " (");
    if (!isMark) continue;
    QString head = said.left(at), headWords = inWords(head), tail = byPattern(said.mid(at), false);
    if (!tail.isEmpty() && headWords != head) return headWords + tail;
  }
  return {};
}

/// Of two texts joined by a mark, both in words. What stands before a colon may be a file's name or a field's.
QString joinedWords(const QString& said, const QString& mark, bool keepsFirst) {
  for (qsizetype at = said.indexOf(mark); at >= 0; at = said.indexOf(mark, at + 1)) {
    QString first = said.left(at), rest = said.mid(at + mark.size());
    QString restWords = inWords(rest), firstWords = inWords(first);
    if (restWords != rest && (keepsFirst || firstWords != first)) return firstWords + mark + restWords;
  }
  return said;
}

QString toWords(const QString& said) {
  static const QString kFirst = kCoreWords[0];
  if (said.isEmpty() || said.size() > kLongest || ofCore(kFirst) == kFirst)
    return said;  // the window speaks as the libraries do
  if (QString words = patternWords(said); !words.isEmpty()) return words;
  if (said.contains('\n')) {
    QStringList lines = said.split('\n');
    for (QString& line : lines) line = inWords(line);
    return lines.join('\n');
  }
  if (said.endsWith('.'))
    if (QString plain = said.chopped(1), words = inWords(plain); words != plain) return words + '.';
  if (hasManyMarks(said)) {
    QStringList parts = said.split("; ");
    for (QString& part : parts)
      if (QString words = patternWords(part); !words.isEmpty()) part = words;
    return parts.join("; ");
  }
  if (QString words = joinedWords(said, "; ", false); words != said) return words;
  return joinedWords(said, ": ", true);
}

}  // namespace

std::span<const char* const> corePatterns() { return kCoreWords; }

QString patternWords(const QString& said) {
  if (QString whole = ofCore(said); whole != said) return whole;
  if (QString words = byPattern(said, false); !words.isEmpty()) return words;
  if (QString words = withTail(said); !words.isEmpty()) return words;
  return byPattern(said, true);
}

QString inWords(const QString& said) {
  // Within one text the same part is asked for again and again.
  static QHash<QString, QString> known;
  static int depth = 0;
  if (auto found = known.constFind(said); found != known.constEnd()) return *found;
  ++depth;
  QString words = toWords(said);
  --depth == 0 ? known.clear() : void(known.insert(said, words));
  return words;
}

QString inWords(std::string_view said) { return inWords(toText(said)); }

}  // namespace velum::gui
