#include "gui/rows/ArgumentForm.h"

#include <fmt/format.h>

#include <QCheckBox>
#include <QComboBox>
#include <QJsonArray>
#include <QJsonDocument>
#include <QLineEdit>
#include <QRegularExpression>

#include "core/Text.h"
#include "gui/kit/Widgets.h"
#include "gui/kit/Words.h"
#include "gui/rows/FieldForm.h"

namespace velum::gui {

namespace {

constexpr int kArgumentNameWidth = 82, kNumberWidth = 92;

/// "Top left" of "topLeft", in the window's language.
QString spelled(const std::string& name) {
  static const QRegularExpression capital("([A-Z])");
  QString text = QString::fromStdString(name).replace(capital, " \\1").toLower();
  return wordsOf((text.left(1).toUpper() + text.mid(1)).toStdString());
}

std::string inQuotes(const QString& text) {
  QByteArray json = QJsonDocument(QJsonArray{text}).toJson(QJsonDocument::Compact);
  return json.mid(1, json.size() - 2).toStdString();
}

/// The two ends of "0.1 .. 60".
Range rangeOf(const std::string& text) {
  std::size_t dots = text.find(" .. ");
  if (dots == text.npos) return {};
  return {numberIn(text.substr(0, dots)).value_or(0.0), numberIn(text.substr(dots + 4)).value_or(0.0)};
}

/// The names of "`left`, `right`".
ArgumentForm::Choices namesIn(const std::string& type) {
  ArgumentForm::Choices names;
  static const QRegularExpression name("`([^`]+)`");
  for (auto found = name.globalMatch(QString::fromStdString(type)); found.hasNext();) {
    std::string one = found.next().captured(1).toStdString();
    names.emplace_back(spelled(one), one);
  }
  return names;
}

}  // namespace

ArgumentForm::ArgumentForm(const session::Command& command, const Extra& extra, QWidget* parent)
    : QWidget(parent), mCommand(command) {
  QGridLayout* grid = makeFieldGrid(this, kArgumentNameWidth);
  for (const scene::FieldRow& argument : command.arguments()) {
    Row row = makeRow(argument, extra);
    QString title = spelled(argument.path), meaning = wordsOf(argument.doc);
    row.control->setObjectName(QString::fromStdString(argument.path));
    row.control->setToolTip(meaning.endsWith('.') ? meaning.chopped(1) : meaning);
    auto* box = qobject_cast<QCheckBox*>(row.control);
    auto* number = qobject_cast<NumberRow*>(row.control);
    if (box) box->setText(title);
    number ? number->setName(title) : row.control->setAccessibleName(title);
    int line = grid->rowCount();
    if (!box) grid->addWidget(new QLabel(title, this), line, 0);
    grid->addWidget(row.control, line, 1, qobject_cast<NumberField*>(row.control) ? Qt::AlignLeft : Qt::Alignment());
    mRows.push_back(std::move(row));
  }
}

ArgumentForm::Row ArgumentForm::makeRow(const scene::FieldRow& argument, const Extra& extra) {
  auto begin = extra.beginning.find(argument.path);
  std::string value = begin == extra.beginning.end() ? argument.defaultValue : begin->second;
  auto among = extra.choices.find(argument.path);
  if (among != extra.choices.end()) return makeList(argument, among->second, value);
  if (argument.type == "number" || argument.type == "whole number") return makeNumber(argument, value);
  if (argument.type.starts_with('`')) return makeList(argument, namesIn(argument.type), value);
  if (argument.type != "true or false") return makeLine(argument, value);
  auto* box = new QCheckBox(this);
  box->setChecked(value == "true");
  connect(box, &QCheckBox::toggled, this, &ArgumentForm::changed);
  return {argument.path, box, [box] { return std::string(box->isChecked() ? "true" : "false"); }};
}

ArgumentForm::Row ArgumentForm::makeNumber(const scene::FieldRow& argument, const std::string& value) {
  Range range = rangeOf(argument.range);
  double number = numberIn(value).value_or(0.0);
  if (argument.unit.empty() && range.max - range.min <= 1.0) {
    auto* slider = new NumberRow(100.0 * range.min, 100.0 * range.max, 0, " %", this);
    slider->setValue(100.0 * number);
    connect(slider, &NumberRow::changed, this, &ArgumentForm::changed);
    return {argument.path, slider, [slider] { return fmt::format("{}", slider->value() / 100.0); }};
  }
  auto* field = new NumberField(this);
  field->setRange(range.min, range.max);
  field->setDecimals(argument.type == "whole number" ? 0 : 2);
  if (!argument.unit.empty()) field->setSuffix(" " + QString::fromStdString(argument.unit));
  field->setAlignment(Qt::AlignRight);
  field->setMinimumWidth(kNumberWidth);
  field->setValue(number);
  connect(field, &NumberField::valueChanged, this, &ArgumentForm::changed);
  return {argument.path, field, [field] { return fmt::format("{}", field->value()); }};
}

ArgumentForm::Row ArgumentForm::makeList(const scene::FieldRow& argument, const Choices& choices,
                                         const std::string& value) {
  auto* list = new QComboBox(this);
  std::string plain = trimmed(value).starts_with('"') ? value.substr(1, value.size() - 2) : value;
  for (const auto& [shown, one] : choices) {
    list->addItem(shown, QString::fromStdString(one));
    if (one == plain) list->setCurrentIndex(list->count() - 1);
  }
  connect(list, &QComboBox::currentIndexChanged, this, &ArgumentForm::changed);
  return {argument.path, list, [list] { return inQuotes(list->currentData().toString()); }};
}

ArgumentForm::Row ArgumentForm::makeLine(const scene::FieldRow& argument, const std::string& value) {
  auto* line = new QLineEdit(this);
  line->setText(QJsonDocument::fromJson(QByteArray::fromStdString("[" + value + "]")).array().at(0).toString());
  connect(line, &QLineEdit::textChanged, this, &ArgumentForm::changed);
  return {argument.path, line, [line] { return inQuotes(line->text()); }};
}

session::Call ArgumentForm::call() const {
  std::string text;
  for (const Row& row : mRows) text += fmt::format("{}={} ", row.name, row.value());
  return {mCommand, mCommand.parse(text)};
}

QWidget* ArgumentForm::control(const std::string& name) const {
  for (const Row& row : mRows)
    if (row.name == name) return row.control;
  return nullptr;
}

double ArgumentForm::number(const std::string& name) const {
  auto* field = qobject_cast<NumberField*>(control(name));
  return field ? field->value() : 0.0;
}

}  // namespace velum::gui
