#include "gui/mark/CaptionForm.h"

#include <fmt/format.h>

#include <QCoreApplication>
#include <QKeyEvent>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

#include "gui/kit/Text.h"
#include "gui/rows/ListParts.h"
#include "scene/Scene.h"
#include "scene/json/Paths.h"
#include "session/command/DocumentCommands.h"
#include "session/command/LetteringCommands.h"

namespace velum::gui {

namespace {

constexpr int kMostCaptionRows = 4, kTextLines = 3;

QString firstLine(const scene::Caption& caption) {
  QString text = toText(caption.text).trimmed().section('\n', 0, 0);
  return text.isEmpty() ? CaptionForm::tr("(no words)") : text;
}

}  // namespace

CaptionForm::CaptionForm(session::Document& document, int labelWidth, QWidget* parent)
    : QWidget(parent),
      mDocument(document),
      mAdd(makeQuiet(tr("Add"), "captionAdd", tr("Add a caption: words over the picture, also in files"), this)),
      mRemove(makeQuiet(tr("Remove"), "captionRemove", tr("Remove the selected caption (Del)"), this)),
      mList(new QListWidget(this)),
      mText(new QPlainTextEdit(this)),
      mForm(document, this, "lettering.captions.N.", [this] { return place(); }) {
  QVBoxLayout* layout = makeColumn(this, 8);
  auto* head = new QHBoxLayout;
  head->addWidget(makeTitle(tr("Captions"), this), 1);
  head->addWidget(mRemove);
  head->addWidget(mAdd);
  layout->addLayout(head);
  mAdd->setAccessibleName(tr("Add caption"));
  mRemove->setAccessibleName(tr("Remove caption"));
  mList->setObjectName("captionList");
  mList->setAccessibleName(tr("Captions"));
  mList->setToolTip(tr("The captions over the picture; Del removes one"));
  mList->setUniformItemSizes(true);
  mList->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  mList->installEventFilter(this);
  layout->addWidget(mList);
  layout->addWidget(mFields = makeFields(labelWidth));
  connect(mAdd, &QPushButton::clicked, this, &CaptionForm::add);
  connect(mRemove, &QPushButton::clicked, this, &CaptionForm::remove);
  connect(mList, &QListWidget::currentRowChanged, this,
          [this](int row) { select(row < 0 ? 0 : captions()[std::size_t(row)].id); });
  refresh();
}

QWidget* CaptionForm::makeFields(int labelWidth) {
  auto* fields = new QWidget(this);
  QVBoxLayout* layout = makeColumn(fields, 8);
  mText->setParent(fields);
  mText->setObjectName("captionText");
  mText->setAccessibleName(tr("Words of the caption"));
  mText->setToolTip(tr("The words, in as many lines as are typed; long lines are broken in the picture"));
  mText->setTabChangesFocus(true);
  mText->setFixedHeight(kTextLines * mText->fontMetrics().lineSpacing() + 2 * mText->frameWidth() +
                        int(2.0 * mText->document()->documentMargin()) + 4);
  mText->installEventFilter(this);
  connect(mText, &QPlainTextEdit::textChanged, this, [this] {
    setField("text", scene::valueOfText(mText->toPlainText().toStdString()), tr("Change caption"), true);
  });
  layout->addWidget(mText);
  QGridLayout* rows = makeFieldGrid(nullptr, labelWidth);
  layout->addLayout(rows);
  mForm.setGrid(rows);
  addRows();
  return fields;
}

void CaptionForm::addRows() {
  mForm.add("place", tr("Stands"),
            {.object = "captionPlace",
             .tip = tr("Where the caption stands; captions at one place stand below each other"),
             .name = tr("Place of the caption"),
             .step = tr("Move caption"),
             .choices = {tr("Top left"), tr("Top"), tr("Top right"), tr("Left"), tr("Centre"), tr("Right"),
                         tr("Bottom left"), tr("Bottom"), tr("Bottom right")}});
  mForm.add("size", tr("Size"),
            {.object = "captionSize",
             .tip = tr("Size of its letters, in that of other lettering, %"),
             .name = tr("Size of the caption"),
             .range =
                 [] {
                   return Range{0.2, 8.0};
                 },
             .inPercent = true});
  mForm.add("opacity", tr("Opacity"),
            {.object = "captionOpacity",
             .tip = tr("How much it covers, %; at 0 it takes no room either"),
             .name = tr("Opacity of the caption")});
  auto color = [this] { return place() < 0 ? std::nullopt : captions()[std::size_t(place())].color; };
  mOwnColor = new OwnColor(mForm, tr("caption"), "captionOwnColor", "captionColor", color, this);
  connect(mOwnColor, &OwnColor::asked, this,
          [this](const std::string& value) { setField("color", value, tr("Change colour of caption")); });
  mForm.addWidget(mOwnColor);
}

const std::vector<scene::Caption>& CaptionForm::captions() const { return mDocument.shown().lettering.captions; }

int CaptionForm::place() const {
  const auto& all = captions();
  auto found = std::find_if(all.begin(), all.end(), [&](const scene::Caption& one) { return one.id == mSelected; });
  return found == all.end() ? -1 : int(found - all.begin());
}

void CaptionForm::select(int id) {
  if (id == mSelected) return;
  mDocument.endMerge();
  mSelected = id;
  refresh();
}

void CaptionForm::setField(const char* field, const std::string& value, const QString& step, bool merge) {
  if (place() < 0) return;
  session::edit(mDocument, session::SetField{fmt::format("lettering.captions.{}.{}", place(), field), value}, merge,
                step.toStdString());
}

void CaptionForm::add() {
  int id = scene::nextId(captions());
  if (captions().size() < scene::kMostCaptions)
    session::edit(mDocument, session::AddCaption{tr("Caption").toStdString()});
  refresh();
  select(id);
  mText->selectAll();
  mText->setFocus(Qt::OtherFocusReason);
  QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);  // the page makes room for what is shown now
  for (QWidget* above = parentWidget(); above; above = above->parentWidget())
    if (auto* page = qobject_cast<QScrollArea*>(above)) page->ensureWidgetVisible(mFields);
}

void CaptionForm::remove() {
  if (place() < 0) return;
  session::edit(mDocument, session::RemoveCaption{"#" + std::to_string(mSelected)});
}

void CaptionForm::showList() {
  const QSignalBlocker quiet(mList);
  int count = int(captions().size()), row = mList->currentRow();
  while (mList->count() > count) delete mList->takeItem(mList->count() - 1);
  while (mList->count() < count) mList->addItem(new QListWidgetItem);
  for (int i = 0; i < count; ++i) mList->item(i)->setText(firstLine(captions()[std::size_t(i)]));
  // Where the selected one is gone its neighbour takes its place.
  if (place() < 0) mSelected = count == 0 ? 0 : captions()[std::size_t(std::clamp(row, 0, count - 1))].id;
  mList->setCurrentRow(place());
  int height = count > 0 ? mList->sizeHintForRow(0) : 0;
  mList->setFixedHeight(std::min(count, kMostCaptionRows) * height + 2 * mList->frameWidth() + 6);
}

/// Leaves the cursor where it is while the text is what was typed.
void CaptionForm::showText() {
  QString text = place() < 0 ? QString() : toText(captions()[std::size_t(place())].text);
  const QSignalBlocker quiet(mText);
  if (mText->toPlainText() != text) mText->setPlainText(text);
}

void CaptionForm::refresh() {
  showList();
  bool isAny = place() >= 0;
  for (QWidget* widget : std::initializer_list<QWidget*>{mList, mFields, mRemove}) widget->setVisible(isAny);
  mAdd->setEnabled(captions().size() < scene::kMostCaptions);
  showText();
  mOwnColor->refresh();
  mForm.refresh();
}

/// Del comes before the command that has the same key; typing is one step until the field is left.
bool CaptionForm::eventFilter(QObject* watched, QEvent* event) {
  bool isKey = event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride;
  if (watched == mList && isKey && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Delete && place() >= 0) {
    event->accept();
    if (event->type() == QEvent::KeyPress) remove();
    return true;
  }
  if (watched == mText && event->type() == QEvent::FocusOut) mDocument.endMerge();
  return QWidget::eventFilter(watched, event);
}

}  // namespace velum::gui
