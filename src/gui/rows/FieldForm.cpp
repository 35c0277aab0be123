#include "gui/rows/FieldForm.h"

#include <fmt/format.h>

#include <QCheckBox>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/Assert.h"
#include "core/Text.h"
#include "gui/kit/Text.h"
#include "gui/kit/Words.h"
#include "scene/json/Paths.h"
#include "session/command/DocumentCommands.h"

namespace velum::gui {

namespace {

using scene::FieldKind;

/// Pixels between label and control; and how many of them the mark of a key may take.
constexpr int kLabelGap = 12, kMarkRoom = 11;

/// Numbers of a text as fields have it: "1,2,3".
std::vector<double> numbersIn(std::string_view text) {
  std::vector<double> numbers;
  while (!text.empty()) {
    std::string_view word = text.substr(0, text.find(','));
    numbers.push_back(numberIn(word).value_or(0.0));
    text.remove_prefix(std::min(word.size() + 1, text.size()));
  }
  return numbers;
}

bool inPercent(const scene::FieldFacts& facts, const FieldText& text) {
  bool isShare = facts.unit.empty() && facts.range.min == 0.0 && facts.range.max == 1.0;
  return facts.kind == FieldKind::Number && text.inPercent.value_or(isShare);
}

/// How many decimals a number has: enough for a thousandth of the range, where there is a range.
int decimalsOf(const scene::FieldFacts& facts, const FieldText& text) {
  if (facts.kind == FieldKind::Whole || inPercent(facts, text)) return 0;
  double span = facts.range.max - facts.range.min;
  return span <= 2.0 ? 2 : span <= 100.0 ? 1 : 0;
}

/// How a unit stands behind a number; empty where numbers are shown without.
QString symbolOf(std::string_view unit) {
  if (unit == "pixel") return FieldForm::tr(" px");
  if (unit == "point") return FieldForm::tr(" pt");
  if (unit == "deg") return "\u00b0";
  if (unit == "mm" || unit == "s") return " " + toText(unit);
  return {};
}

QString suffixOf(const scene::FieldFacts& facts, const FieldText& text) {
  return inPercent(facts, text) ? " %" : symbolOf(facts.unit);
}

/// What the field means, with a unit that the control does not show.
QString tipOf(const scene::FieldFacts& facts) {
  QString tip = wordsOf(facts.meaning);
  if (tip.endsWith('.')) tip.chop(1);
  bool isShown = facts.unit.empty() || facts.unit == kLength || !symbolOf(facts.unit).isEmpty();
  return isShown ? tip : tip + ", " + QString::fromStdString(facts.unit).replace("^2", "\u00b2");
}

QString capitalised(const std::string& name) {
  QString text = QString::fromStdString(name);
  return text.left(1).toUpper() + text.mid(1);
}

}  // namespace

FieldForm::FieldForm(session::Document& document, QObject* parent, std::string root, std::function<int()> place)
    : QObject(parent), mDocument(document), mRoot(std::move(root)), mPlace(std::move(place)), mSteps(tr("Change %1")) {}

QWidget* FieldForm::add(const std::string& path, const QString& title, FieldText text) {
  VELUM_ASSERT(mGrid, "rows have a grid");
  Row& row = makeRow(mGrid->parentWidget(), path, title, std::move(text));
  int line = mGrid->rowCount();
  bool hasTitle = row.facts.kind == FieldKind::Truth || row.facts.kind == FieldKind::Color;
  if (!hasTitle) {
    mGrid->addWidget(row.label = new QLabel(title, mGrid->parentWidget()), line, 0);
    row.label->setContentsMargins(0, 0, kMarkRoom, 0);
    row.key->watch(row.label);
  }
  mGrid->addWidget(row.key, line, 0, Qt::AlignRight | Qt::AlignVCenter);
  mGrid->addWidget(row.control, line, 1);
  return row.control;
}

void FieldForm::addWidget(QWidget* widget, const QString& title) {
  int line = mGrid->rowCount();
  if (!title.isEmpty()) mGrid->addWidget(new QLabel(title, mGrid->parentWidget()), line, 0);
  mGrid->addWidget(widget, line, 1, title.isEmpty() ? Qt::AlignLeft : Qt::Alignment());
}

void FieldForm::setEnabled(bool isEnabled) {
  for (const Row& row : mRows)
    if (!row.text.isEnabled) row.control->setEnabled(isEnabled);
}

QWidget* FieldForm::make(QWidget* parent, const std::string& path, const QString& title, FieldText text) {
  Row& row = makeRow(parent, path, title, std::move(text));
  row.key->standOver(row.control);
  return row.control;
}

FieldForm::Row& FieldForm::makeRow(QWidget* parent, const std::string& path, const QString& title, FieldText text) {
  Row& row = mRows.emplace_back(Row{path, scene::fieldFacts(mRoot + path), std::move(text)});
  if (row.text.name.isEmpty()) row.text.name = title;
  // A colour says by itself what a click does.
  if (row.text.tip.isEmpty() && row.facts.kind != FieldKind::Color) row.text.tip = tipOf(row.facts);
  if (row.text.step.isEmpty() && !row.text.call) row.text.step = mSteps.arg(inSentence(row.text.name));
  row.control = makeControl(row, title, parent);
  row.control->setObjectName(row.text.object);
  if (!row.text.tip.isEmpty()) row.control->setToolTip(row.text.tip);
  row.key = new FieldKey(
      mDocument, row.text.name, [this, &row] { return pathOf(row); }, parent);
  row.key->watch(row.control);
  return row;
}

QWidget* FieldForm::makeControl(const Row& row, const QString& title, QWidget* parent) {
  switch (row.facts.kind) {
    case FieldKind::Truth: {
      auto* box = new QCheckBox(title, parent);
      box->setAccessibleName(row.text.name);
      connect(box, &QCheckBox::clicked, this, [this, &row](bool on) { set(row, on ? "true" : "false"); });
      return box;
    }
    case FieldKind::Color: {
      auto* button = new ColorButton(row.text.name, parent);
      button->setText(title);
      connect(button, &ColorButton::picked, this,
              [this, &row](glm::vec3 color) { set(row, fmt::format("{},{},{}", color.r, color.g, color.b)); });
      return button;
    }
    case FieldKind::Choice:
      return makeChoice(row, parent);
    case FieldKind::Whole:
    case FieldKind::Number:
      return makeNumber(row, parent);
    case FieldKind::Text:
    case FieldKind::Other:
      break;
  }
  VELUM_ASSERT(false, "forms have controls for fields of that kind");
  return nullptr;
}

QWidget* FieldForm::makeChoice(const Row& row, QWidget* parent) {
  auto* box = new QComboBox(parent);
  box->setAccessibleName(row.text.name);
  box->addItems(row.text.choices);
  if (row.text.choices.isEmpty())
    for (const std::string& name : row.facts.names) box->addItem(wordsOf(capitalised(name).toStdString()));
  VELUM_ASSERT(std::size_t(box->count()) <= row.facts.names.size(), "choices are values of the field");
  connect(box, &QComboBox::activated, this, [this, &row](int index) { set(row, row.facts.names[std::size_t(index)]); });
  return box;
}

/// Makes a field for a number; for a vector one number that all components get.
QWidget* FieldForm::makeNumber(const Row& row, QWidget* parent) {
  auto* control = new NumberRow(0, 1, decimalsOf(row.facts, row.text), suffixOf(row.facts, row.text), parent);
  control->setName(row.text.name);
  if (!row.text.range) {
    VELUM_ASSERT(std::isfinite(row.facts.range.max - row.facts.range.min), "a form offers a part of what is endless");
    double shown = inPercent(row.facts, row.text) ? 100.0 : 1.0;
    control->setRange(row.facts.range.min * shown, row.facts.range.max * shown);
  }
  connect(control, &NumberRow::changed, this, [this, &row](double number) {
    double value = inPercent(row.facts, row.text) ? number / 100.0 : number;
    value = std::clamp(value, row.facts.range.min, row.facts.range.max);
    if (row.facts.kind == FieldKind::Whole) value = std::round(value);
    std::string all;
    for (int i = 0; i < row.facts.count; ++i) all += fmt::format("{}{}", i > 0 ? "," : "", value);
    set(row, all, true);
  });
  connect(control, &NumberRow::settled, this, [this] { mDocument.endMerge(); });
  return control;
}

std::string FieldForm::pathOf(const Row& row) const {
  if (!mPlace) return mRoot + row.path;
  int place = mPlace();
  if (place < 0) return {};
  std::size_t at = mRoot.find(".N.");
  VELUM_ASSERT(at != std::string::npos, "the root says where the item stands");
  return fmt::format("{}.{}.{}{}", mRoot.substr(0, at), place, mRoot.substr(at + 3), row.path);
}

void FieldForm::set(const Row& row, const std::string& value, bool merge) {
  std::string path = pathOf(row);
  if (path.empty()) return;
  session::Call call = row.text.call ? row.text.call(value) : session::Call(session::SetField{path, value});
  bool isOff = value == "false" && !row.text.stepOff.isEmpty();
  const QString& step = isOff ? row.text.stepOff : row.text.step;
  session::edit(mDocument, call, merge, step.toStdString());
}

void FieldForm::show(const Row& row, const std::string& value) {
  if (auto* box = qobject_cast<QCheckBox*>(row.control)) return box->setChecked(value == "true");
  if (auto* box = qobject_cast<QComboBox*>(row.control)) {
    auto found = std::find(row.facts.names.begin(), row.facts.names.end(), value);
    return box->setCurrentIndex(int(found - row.facts.names.begin()));
  }
  std::vector<double> numbers = numbersIn(value);
  if (auto* button = qobject_cast<ColorButton*>(row.control))
    return button->setColor({float(numbers.at(0)), float(numbers.at(1)), float(numbers.at(2))});
  auto* control = static_cast<NumberRow*>(row.control);
  double shown = inPercent(row.facts, row.text) ? 100.0 : 1.0;
  if (row.facts.unit == kLength) control->setLength(Length(mDocument.shown()));
  if (row.text.range) control->setRange(row.text.range().min * shown, row.text.range().max * shown);
  control->setValue(numbers.at(0) * shown);
}

void FieldForm::refresh() {
  for (const Row& row : mRows) {
    if (row.text.isShown) row.control->setVisible(row.text.isShown());
    if (row.text.isShown && row.label) row.label->setVisible(row.text.isShown());
    if (row.text.isEnabled) row.control->setEnabled(row.text.isEnabled());
    std::string path = row.text.isShown && !row.text.isShown() ? std::string() : pathOf(row);
    row.key->refresh(!path.empty());
    if (path.empty()) continue;
    show(row, row.text.number ? fmt::format("{}", row.text.number()) : scene::getField(mDocument.shown(), path));
  }
}

std::vector<FieldForm::Told> FieldForm::rows() const {
  std::vector<Told> told;
  for (const Row& row : mRows) {
    Told& one = told.emplace_back(Told{mRoot + row.path, row.control, {}});
    double shown = inPercent(row.facts, row.text) ? 100.0 : 1.0;
    auto* control = qobject_cast<NumberRow*>(row.control);
    if (control) one.offered = {control->spin()->minimum() / shown, control->spin()->maximum() / shown};
    if (control && row.text.range) one.offered = row.text.range();  // also of rows that have not been shown yet
  }
  return told;
}

QGridLayout* makeFieldGrid(QWidget* parent, int labelWidth) {
  auto* grid = new QGridLayout(parent);
  grid->setContentsMargins(0, 0, 0, 0);
  // Between label and control there is room for the mark of a key.
  grid->setHorizontalSpacing(kLabelGap - kMarkRoom);
  grid->setVerticalSpacing(8);
  grid->setColumnMinimumWidth(0, labelWidth + kMarkRoom);
  grid->setColumnStretch(1, 1);
  return grid;
}

}  // namespace velum::gui
