#include "gui/kit/Language.h"

#include <fmt/format.h>

#include <QApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>
#include <algorithm>
#include <memory>

#include "core/Error.h"

namespace velum::gui {

namespace {

constexpr Language kLanguages[] = {{"en", "English"}, {"de", "Deutsch"}};

QString systemCode() {
  QString code = QLocale::system().name().section('_', 0, 0);
  bool isOurs = std::ranges::any_of(kLanguages, [&](const Language& one) { return code == one.code; });
  return isOurs ? code : QString("en");
}

/// @return false where the folder has no such words
bool installWords(const QString& name, const QString& folder) {
  auto words = std::make_unique<QTranslator>(qApp);
  if (!words->load(name, folder)) return false;
  QCoreApplication::installTranslator(words.release());
  return true;
}

}  // namespace

std::span<const Language> languages() { return kLanguages; }

void speak(const QString& code) {
  bool isOurs = std::ranges::any_of(kLanguages, [&](const Language& one) { return code == one.code; });
  if (!code.isEmpty() && !isOurs)
    throw ArgumentError(fmt::format("'{}' is no language of Velum; it speaks en and de", code.toStdString()));
  QString spoken = code.isEmpty() ? systemCode() : code;
  QString ofSystem = QLocale::system().name().section('_', 0, 0);
  if (!code.isEmpty() && code != ofSystem) QLocale::setDefault(QLocale(code));
  if (spoken == "en") return;
  // Qt's own words, of dialogs and menus of fields, are embedded where the build had them, else where Qt is; ours go
  // before them.
  if (!installWords("qtbase_" + spoken, ":/velum/translations"))
    installWords("qtbase_" + spoken, QLibraryInfo::path(QLibraryInfo::TranslationsPath));
  installWords("velum_" + spoken, ":/velum/translations");
}

}  // namespace velum::gui
