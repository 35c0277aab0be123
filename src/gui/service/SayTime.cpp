#include "gui/service/SayTime.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QLocale>

namespace velum::gui {

namespace {

QString sayDay(const char* text) { return QCoreApplication::translate("SayTime", text); }

}  // namespace

QString sayTime(std::chrono::system_clock::time_point when) {
  QDateTime time = QDateTime::fromSecsSinceEpoch(std::chrono::system_clock::to_time_t(when));
  QString clock = QLocale().toString(time.time(), QLocale().timeFormat(QLocale::ShortFormat).remove(":ss"));
  qint64 days = time.date().daysTo(QDate::currentDate());
  if (days == 0) return sayDay(QT_TRANSLATE_NOOP("SayTime", "today %1")).arg(clock);
  if (days == 1) return sayDay(QT_TRANSLATE_NOOP("SayTime", "yesterday %1")).arg(clock);
  return QString("%1, %2").arg(QLocale().toString(time.date(), QLocale::LongFormat), clock);
}

}  // namespace velum::gui
