#include "gui/kit/TypedNumber.h"

#include <QRegularExpression>
#include <cmath>

namespace velum::gui {

namespace {

/// Millimetres in a unit of length; 0 for a text that is no such unit.
double millimetresIn(const QString& unit) {
  struct Row {
    const char* name;
    double millimetres;
  };
  static constexpr Row kUnits[] = {{"km", 1e6},       {"m", 1e3},         {"cm", 10.0}, {"mm", 1.0}, {"um", 1e-3},
                                   {"\u00b5m", 1e-3}, {"\u03bcm", 1e-3},  {"nm", 1e-6}, {"A", 1e-7}, {"\u00c5", 1e-7},
                                   {"\u212b", 1e-7},  {"angstrom", 1e-7}, {"in", 25.4}};
  for (const Row& row : kUnits) {
    QString name = QString::fromUtf8(row.name);
    if (unit == name || (name.size() > 1 && unit.compare(name, Qt::CaseInsensitive) == 0)) return row.millimetres;
  }
  return 0.0;
}

bool isSame(const QString& a, const QString& b) { return !b.isEmpty() && a.compare(b, Qt::CaseInsensitive) == 0; }

/// 1 or -1 for a letter of direction, 0 for any other text.
double signOf(const QString& text, const NumberKind& kind) {
  return isSame(text, kind.positive) ? 1.0 : isSame(text, kind.negative) ? -1.0 : 0.0;
}

/// The factor from a number in this unit to the kind's own unit; 0: the unit does not suit the kind.
double factorOf(const QString& unit, const NumberKind& kind) {
  if (unit.isEmpty() || isSame(unit, kind.unit)) return 1.0;
  bool isDegree = kind.unit == QString::fromUtf8("\u00b0");
  if (isDegree && (isSame(unit, "deg") || isSame(unit, "degrees"))) return 1.0;
  return kind.millimetres > 0.0 ? millimetresIn(unit) / kind.millimetres : 0.0;
}

/// Reads the text behind a number: a direction, a unit, or both. @return factor for the number; 0: the text is not
/// understood
double factorBehind(QString text, bool hasDirection, const NumberKind& kind) {
  double sign = 1.0;
  bool isApart = text.size() == 1 || (text.size() > 1 && text[text.size() - 2].isSpace());
  if (double found = signOf(text.right(1), kind); found != 0.0 && isApart && !hasDirection) {
    sign = found;
    text = text.chopped(1).trimmed();
  }
  return sign * factorOf(text, kind);
}

}  // namespace

std::optional<double> readTyped(const QString& text, const NumberKind& kind) {
  static const QRegularExpression form(
      R"(^(\p{L}?)\s*([+\-\x{2212}]?)\s*((?:\d+(?:[.,]\d*)?|[.,]\d+)(?:[eE][+\-]?\d+)?)\s*(.*)$)",
      QRegularExpression::UseUnicodePropertiesOption);
  QString rest = text.trimmed(), prefix = kind.prefix.trimmed();
  if (!prefix.isEmpty() && rest.startsWith(prefix, Qt::CaseInsensitive)) rest = rest.mid(prefix.size()).trimmed();
  auto match = form.match(rest);
  if (!match.hasMatch()) return std::nullopt;
  // The number.
  bool isNumber = false;
  double value = match.captured(3).replace(',', '.').toDouble(&isNumber);
  if (!isNumber || !std::isfinite(value)) return std::nullopt;
  if (!match.captured(2).isEmpty() && match.captured(2) != "+") value = -value;
  QString letter = match.captured(1), behind = match.captured(4).trimmed();
  double sign = letter.isEmpty() ? 1.0 : signOf(letter, kind);
  double factor = factorBehind(behind, !letter.isEmpty(), kind);
  // When the user types over the number, the field's own unit stays behind the typed text: "8 cm mm".
  if (factor == 0.0 && behind.endsWith(kind.unit) && !kind.unit.isEmpty())
    factor = factorBehind(behind.chopped(kind.unit.size()).trimmed(), !letter.isEmpty(), kind);
  if (sign == 0.0 || factor == 0.0) return std::nullopt;
  return sign * value * factor;
}

}  // namespace velum::gui
