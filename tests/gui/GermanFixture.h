#pragma once
#include <QAbstractButton>
#include <QComboBox>
#include <QContextMenuEvent>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenuBar>
#include <QRegularExpression>
#include <QScrollArea>
#include <QStyle>
#include <QStyleOptionComboBox>
#include <QTabBar>
#include <QTimer>
#include <QTranslator>
#include <QXmlStreamReader>

#include "ModelFixture.h"
#include "Shots.h"
#include "gui/kit/Language.h"
#include "gui/kit/SideTabs.h"

namespace velum::gui {

/// What a translation says in English where it says something else, without the marks of letters.
inline QSet<QString> englishTexts() {
  QFile file(QString::fromStdString(std::string(VELUM_SOURCE_DIR) + "/translations/velum_de.ts"));
  EXPECT_TRUE(file.open(QIODevice::ReadOnly));
  QXmlStreamReader xml(&file);
  QSet<QString> english, german;
  QString source;
  while (!xml.atEnd()) {
    xml.readNext();
    if (!xml.isStartElement()) continue;
    if (xml.name() == QStringLiteral("source")) source = xml.readElementText().remove('&');
    if (xml.name() == QStringLiteral("translation"))
      (source == xml.readElementText(QXmlStreamReader::IncludeChildElements).remove('&').trimmed() ? german : english)
          << source;
  }
  return english - german;
}

/// A window that was made in German, with a cell model or data.
class German : public ModelWindow {
 protected:
  void SetUp() override {
    mLocale = QLocale();
    speak("de");
    Window::SetUp();
  }
  void TearDown() override {
    Window::TearDown();
    for (auto* words : qApp->findChildren<QTranslator*>()) {
      QCoreApplication::removeTranslator(words);
      delete words;
    }
    QLocale::setDefault(mLocale);
  }

  /// No text that is seen, nor any tip or name, is one that has a translation, or has words that only English has.
  void expectNothingEnglish(const QWidget& owner) {
    auto check = [&](const QString& text, const QObject& of) {
      EXPECT_FALSE(isEnglish(text)) << owner.objectName().toStdString() << ": " << of.metaObject()->className() << " "
                                    << of.objectName().toStdString() << ": " << text.toStdString();
    };
    for (const auto* action : owner.findChildren<QAction*>()) {
      check(action->text(), *action);
      check(action->toolTip(), *action);
      check(action->statusTip(), *action);
    }
    for (const auto* menu : owner.findChildren<QMenu*>()) check(menu->title(), *menu);
    check(owner.windowTitle(), owner);
    for (const auto* widget : owner.findChildren<QWidget*>()) {
      check(widget->toolTip(), *widget);
      check(widget->accessibleName(), *widget);
      check(widget->accessibleDescription(), *widget);
      if (const auto* label = qobject_cast<const QLabel*>(widget)) check(label->text(), *label);
      if (const auto* button = qobject_cast<const QAbstractButton*>(widget)) check(button->text(), *button);
      if (const auto* line = qobject_cast<const QLineEdit*>(widget)) check(line->placeholderText(), *line);
      if (const auto* box = qobject_cast<const QGroupBox*>(widget)) check(box->title(), *box);
      if (const auto* box = qobject_cast<const QComboBox*>(widget))
        for (int i = 0; i < box->count(); ++i) check(box->itemText(i), *box);
      if (const auto* tabs = qobject_cast<const QTabWidget*>(widget))
        for (int i = 0; i < tabs->count(); ++i) check(tabs->tabText(i), *tabs), check(tabs->tabToolTip(i), *tabs);
    }
  }

  /// What is seen of labels, buttons, boxes and tabs is seen whole.
  void expectNothingClipped(const QWidget& owner, const QString& where) {
    auto expectRoom = [&](int needed, int room, const QWidget& of, const QString& text) {
      EXPECT_LE(needed, room) << where.toStdString() << ": " << of.metaObject()->className() << " "
                              << of.objectName().toStdString() << ": " << text.toStdString();
    };
    for (const auto* widget : owner.findChildren<QWidget*>()) {
      if (!widget->isVisible()) continue;
      if (const auto* area = qobject_cast<const QScrollArea*>(widget))
        if (area->widget() && area->horizontalScrollBarPolicy() == Qt::ScrollBarAlwaysOff)
          expectRoom(area->widget()->width(), area->viewport()->width(), *area->widget(), {});
      if (const auto* label = qobject_cast<const QLabel*>(widget)) {
        bool isElided = label->sizePolicy().horizontalPolicy() == QSizePolicy::Ignored;
        if (label->text().isEmpty() || isElided) continue;
        if (label->wordWrap())
          expectRoom(label->heightForWidth(label->width()), label->height() + 1, *label, label->text());
        else
          expectRoom(label->sizeHint().width(), label->width(), *label, label->text());
      }
      if (const auto* button = qobject_cast<const QAbstractButton*>(widget))
        if (!button->text().isEmpty() && button->sizePolicy().horizontalPolicy() != QSizePolicy::Ignored)
          expectRoom(button->sizeHint().width(), button->width(), *button, button->text());
      if (const auto* box = qobject_cast<const QComboBox*>(widget)) {
        QStyleOptionComboBox option;
        option.initFrom(box);
        QRect room = box->style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, box);
        expectRoom(box->fontMetrics().horizontalAdvance(box->currentText()), room.width(), *box, box->currentText());
      }
      if (const auto* bar = qobject_cast<const QTabBar*>(widget))
        for (int i = 0; i < bar->count(); ++i)
          if (bar->isTabVisible(i))
            expectRoom(bar->fontMetrics().horizontalAdvance(bar->tabText(i).remove('&')), bar->tabRect(i).width(), *bar,
                       bar->tabText(i));
    }
  }
  void expectGermanAndWhole(QWidget& owner, const QString& where) {
    // Texts have changed just now.
    for (int i = 0; i < 3; ++i) QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
    expectNothingEnglish(owner);
    expectNothingClipped(owner, where);
    takeShot(owner, "german-" + where);
  }
  /// A dialog as it is shown first.
  void expectGermanDialog(QWidget& dialog, const QString& where) {
    dialog.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&dialog));
    QTest::qWait(50);
    expectGermanAndWhole(dialog, where);
    dialog.hide();
  }
  /// Each page of the side panel, at the size of a small screen.
  void expectGermanPages(const QString& where) {
    mWindow->resize(1280, 860);
    SideTabs& tabs = mWindow->tabs();
    for (int page = 0; page < tabs.count(); ++page) {
      if (!tabs.isTabVisible(page)) continue;
      tabs.setCurrentIndex(page);
      QTest::qWait(30);
      expectGermanAndWhole(*mWindow, where + "-" + tabs.tabText(page));
    }
  }

  /// The menu that the right button, or the key, opens in a place of a widget.
  void expectGermanMenu(QWidget& widget, QPoint at, const QString& where,
                        QContextMenuEvent::Reason reason = QContextMenuEvent::Mouse) {
    bool isSeen = false;
    QTimer::singleShot(50, mWindow.get(), [&] {
      auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
      if (!menu) return;
      isSeen = true;
      for (const QAction* action : menu->actions())
        EXPECT_FALSE(isEnglish(action->text()) || isEnglish(action->toolTip())) << action->text().toStdString();
      expectNothingEnglish(*menu);
      expectDifferentLetters(*menu);
      takeShot(*menu, "german-menu-" + where);
      menu->close();
    });
    QContextMenuEvent event(reason, at, widget.mapToGlobal(at));
    QApplication::sendEvent(&widget, &event);
    EXPECT_TRUE(QTest::qWaitFor([&] { return isSeen; }, kPatience)) << where.toStdString();
  }
  /// No two of them have the same letter.
  void expectDifferentLetters(const QStringList& texts, const QString& where) {
    QMap<QString, QString> letters;
    for (const QString& text : texts) {
      QString letter = QKeySequence::mnemonic(text).toString();
      if (letter.isEmpty()) continue;
      EXPECT_FALSE(letters.contains(letter)) << (where + ": " + text + " and " + letters[letter]).toStdString();
      letters[letter] = text;
    }
  }
  void expectDifferentLetters(const QMenu& menu) {
    QStringList texts;
    for (const QAction* action : menu.actions()) texts << action->text();
    expectDifferentLetters(texts, menu.title());
  }

  int mTexts = 0;

 private:
  bool isEnglish(QString text) {
    static const QSet<QString> english = englishTexts();
    static const QRegularExpression sentence(
        "\\b(the|of|and|is|are|with|not|from|which|there|this|what|its|where|or|how|to)\\b");
    // The commands of scripts and the names of fields are English in both languages.
    static const QRegularExpression code("\\b[a-z]+\\.[a-z][A-Za-z.]*");
    text.remove('&');
    if (text.isEmpty()) return false;
    ++mTexts;
    return english.contains(text) || text.remove(code).contains(sentence);
  }

  QLocale mLocale;
};

}  // namespace velum::gui
