#include "gui/mark/LetteringForm.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>

#include "core/Error.h"
#include "gui/kit/Text.h"
#include "gui/kit/Words.h"
#include "gui/rows/ListParts.h"
#include "scene/PlateStyles.h"
#include "scene/Scene.h"
#include "session/command/Command.h"
#include "session/command/DocumentCommands.h"
#include "session/command/MarkCommands.h"

namespace velum::gui {

namespace {

constexpr int kLetteringLabels = 72;
/// Widths of columns and pages that journals ask for, mm.
constexpr int kPageWidths[] = {85, 114, 174, 183};

/// A group of rows under a title.
QVBoxLayout* makeGroup(QWidget* group, const QString& title) {
  QVBoxLayout* layout = makeColumn(group, 8);
  layout->addWidget(makeTitle(title, group));
  return layout;
}

}  // namespace

LetteringForm::LetteringForm(session::Document& document, QWidget* parent)
    : QWidget(parent),
      mDocument(document),
      mForm(document, this),
      mCaptions(new CaptionForm(document, kLetteringLabels, this)) {
  QVBoxLayout* layout = makeColumn(this, 14);
  layout->addWidget(makeStyle());
  layout->addWidget(makeLine(this));
  layout->addWidget(makeNames());
  layout->addWidget(makeLine(this));
  layout->addWidget(makeCorners());
  layout->addWidget(makeLine(this));
  layout->addWidget(mCaptions);
}

QWidget* LetteringForm::makeStyle() {
  auto* group = new QWidget(this);
  QGridLayout* rows = makeFieldGrid(nullptr, kLetteringLabels);
  makeGroup(group, tr("Lettering"))->addLayout(rows);
  mForm.setGrid(rows);
  auto lettering = [this]() -> const scene::Lettering& { return mDocument.shown().lettering; };
  auto hasPage = [lettering] { return lettering().pageWidth > 0.0; };
  mForm.addWidget(mStyle = makeStyles(group), tr("Style"));
  mForm.add("lettering.pageWidth", tr("Page"),
            {.object = "pageWidth",
             .tip = tr("Width of the printed picture, mm: letters and lines have their size on paper; 0: sizes go with "
                       "the picture's rows"),
             .name = tr("Width of the page"),
             .step = tr("Change width of page"),
             .range = [] {
               return Range{0, 1000};
             }});
  mForm.addWidget(makeWidths(group));
  mForm.add("lettering.textSize", tr("Letters"),
            {.object = "textSize",
             .tip = tr("Their size in pixels of a picture of 1000 rows; they grow with the picture"),
             .name = tr("Size of the letters"),
             .step = tr("Change size of letters"),
             .isShown = [hasPage] { return !hasPage(); }});
  mForm.add("lettering.textPoints", tr("Letters"),
            {.object = "textPoints",
             .tip = tr("Their size on the page, points"),
             .name = tr("Size of the letters on the page"),
             .step = tr("Change size of letters"),
             .range =
                 [] {
                   return Range{1, 72};
                 },
             .isShown = hasPage});
  mForm.add("lettering.linePoints", tr("Lines"),
            {.object = "linePoints",
             .tip = tr("Width of the lines of marks and leaders, points; without a page in proportion to the letters"),
             .name = tr("Width of lines"),
             .step = tr("Change width of lines"),
             .range = [] {
               return Range{0.1, 5};
             }});
  mForm.add("lettering.typeface", tr("Typeface"),
            {.object = "typeface",
             .tip = tr("Letters with serifs, as in books, or without"),
             .step = tr("Change typeface"),
             .choices = {tr("Sans"), tr("Serif")}});
  mForm.add("lettering.bold", tr("Bold"), {.object = "bold", .tip = tr("Heavy letters"), .step = tr("Bold letters")});
  mForm.add("lettering.halo", tr("Halo"),
            {.object = "halo",
             .tip = tr("How much of the ground's colour lies around letters and lines, so that they are read over "
                       "anything, %"),
             .name = tr("Halo of the lettering"),
             .step = tr("Change halo")});
  return group;
}

QComboBox* LetteringForm::makeStyles(QWidget* parent) {
  auto* styles = new QComboBox(parent);
  styles->setObjectName("letteringStyle");
  styles->setAccessibleName(tr("Style of the lettering"));
  styles->setToolTip(tr("Typeface, sizes, colour and halo of all that is written over the picture"));
  for (const scene::PlateStyle& style : scene::plateStyles()) {
    styles->addItem(wordsOf(style.title), toText(style.name));
    styles->setItemData(styles->count() - 1, wordsOf(style.tip), Qt::ToolTipRole);
  }
  connect(styles, &QComboBox::activated, this, [this, styles](int row) {
    session::edit(mDocument, session::ChooseLetteringStyle{styles->itemData(row).toString().toStdString()});
  });
  return styles;
}

QWidget* LetteringForm::makeWidths(QWidget* parent) {
  auto* widths = new QWidget(parent);
  auto* row = new QHBoxLayout(widths);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(0);
  for (int width : kPageWidths) {
    QPushButton* button =
        makeQuiet(QString::number(width), "", tr("A width that journals ask for: %1 mm").arg(width), widths);
    button->setAccessibleName(tr("Page of %1 mm").arg(width));
    connect(button, &QPushButton::clicked, this, [this, width] {
      session::edit(mDocument, session::SetField{"lettering.pageWidth", std::to_string(width)}, false,
                    tr("Change width of page").toStdString());
    });
    row->addWidget(button);
  }
  row->addWidget(new QLabel("mm", widths));
  row->addStretch(1);
  return widths;
}

QWidget* LetteringForm::makeNames() {
  auto* group = new QWidget(this);
  QGridLayout* rows = makeFieldGrid(nullptr, kLetteringLabels);
  makeGroup(group, tr("Names"))->addLayout(rows);
  mForm.setGrid(rows);
  auto isOn = [this] { return mDocument.shown().lettering.names; };
  mForm.add("lettering.names", tr("Names of what is seen"),
            {.object = "names",
             .tip = tr("Names of structures and types with leaders to them; they find their own places"),
             .step = tr("Names of what is seen"),
             .isEnabled = [this] { return mDocument.shown().model.data || mDocument.shown().labels.data; }});
  mForm.add("lettering.nameOrder", tr("Stand"),
            {.object = "nameOrder",
             .tip = tr("Where the names stand: in columns left and right, or around what is seen"),
             .name = tr("Order of the names"),
             .step = tr("Change order of names"),
             .choices = {tr("In columns"), tr("Around")},
             .isEnabled = isOn});
  mForm.add("lettering.mostNames", tr("At most"),
            {.object = "mostNames",
             .tip = tr("How many names find a place at most"),
             .name = tr("Most names"),
             .step = tr("Change number of names"),
             .isEnabled = isOn});
  mNamed = new QLineEdit(group);
  mNamed->setObjectName("named");
  mNamed->setAccessibleName(tr("What is named"));
  mNamed->setPlaceholderText(tr("What is seen most"));
  mNamed->setToolTip(tr("Names of structures and paths of types, with commas between them; empty: what is seen most"));
  connect(mNamed, &QLineEdit::editingFinished, this, &LetteringForm::nameThese);
  mForm.addWidget(mNamed, tr("Only"));
  return group;
}

/// What is typed becomes the list.
void LetteringForm::nameThese() {
  QStringList quoted;
  for (const QString& part : mNamed->text().split(',', Qt::SkipEmptyParts))
    if (QString name = part.trimmed(); !name.isEmpty())
      quoted << '"' + name.replace('\\', "\\\\").replace('"', "\\\"") + '"';
  std::string value = "[" + quoted.join(',').toStdString() + "]";
  try {
    session::edit(mDocument, session::SetField{"lettering.named", value}, false, tr("Name these").toStdString());
  } catch (const Error&) {
    refresh();  // more than there may be
  }
}

QWidget* LetteringForm::makeCorners() {
  auto* group = new QWidget(this);
  QGridLayout* rows = makeFieldGrid(nullptr, kLetteringLabels);
  makeGroup(group, tr("In the corners"))->addLayout(rows);
  mForm.setGrid(rows);
  addCorner(
      "legend", "legendCorner", &scene::Lettering::legend, tr("Legend"),
      tr("Colours and names of types and structures over the picture, also in files; the menu of a type lists it"),
      [this] { return mDocument.shown().model.data || mDocument.shown().labels.data; });
  addCorner("scaleBar", "scaleBarCorner", &scene::Lettering::scaleBar, tr("Scale bar"),
            tr("How long things are, over the picture, also in files; in perspective at the point about which the view "
               "turns"),
            [] { return true; });
  addCorner("timeStamp", "timeStampCorner", &scene::Lettering::timeStamp, tr("Time stamp"),
            tr("The time of the time step over the picture, also in files"), [this] {
              const auto& volume = mDocument.shown().volume.data;
              return volume && volume->timeSteps > 1;
            });
  return group;
}

/// A tick, and the corner in which it stands.
void LetteringForm::addCorner(const char* part, const char* corner, bool scene::Lettering::*isOn, const QString& title,
                              const QString& tip, const std::function<bool()>& canBe) {
  std::string root = "lettering.";
  QString name = tr("Corner of the %1").arg(inSentence(title));
  mForm.add(root + part, title, {.object = part, .tip = tip, .step = title, .isEnabled = canBe});
  mForm.add(root + corner, tr("Stands"),
            {.object = corner,
             .tip = tr("The corner in which the %1 stands").arg(inSentence(title)),
             .name = name,
             .step = tr("Move %1").arg(inSentence(title)),
             .choices = {tr("Top left"), tr("Top right"), tr("Bottom left"), tr("Bottom right")},
             .isEnabled = [this, isOn, canBe] { return mDocument.shown().lettering.*isOn && canBe(); }});
}

void LetteringForm::refresh() {
  const scene::Lettering& lettering = mDocument.shown().lettering;
  mStyle->setCurrentIndex(mStyle->findData(toText(scene::plateStyleName(lettering))));
  mStyle->setPlaceholderText(tr("Own"));
  QString named = toText(fmt::format("{}", fmt::join(lettering.named, ", ")));
  if (!mNamed->hasFocus()) mNamed->setText(named);
  mNamed->setEnabled(lettering.names);
  mForm.refresh();
  mCaptions->refresh();
}

}  // namespace velum::gui
