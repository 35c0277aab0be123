#include "gui/window/Findable.h"

#include <QLineEdit>
#include <QScrollArea>

#include "gui/kit/NumberField.h"
#include "gui/kit/Text.h"
#include "gui/kit/Words.h"
#include "gui/look/PresetGrid.h"
#include "gui/rows/PictureList.h"
#include "scene/Presets.h"

namespace velum::gui {

namespace {

using Findables = std::vector<Findable>;

/// Without a number: the keyboard goes to the field, and what it says is selected.
void takeNumber(SideTabs& tabs, NumberField& field, const QString& number) {
  tabs.showPage(&field);
  field.setFocus(Qt::ShortcutFocusReason);
  number.isEmpty() ? field.selectAll() : field.enter(number);
}

void addNumbers(SideTabs& tabs, int page, Findables& found) {
  for (NumberField* field : tabs.widget(page)->findChildren<NumberField*>()) {
    if (field->accessibleName().isEmpty() || !field->isVisibleTo(tabs.widget(page))) continue;
    found.push_back({tabs.tabText(page) + " > " + field->accessibleName(), field->withUnit(field->value()),
                     field->toolTip(), field->isEnabled(), true,
                     [&tabs, field](const QString& number) { takeNumber(tabs, *field, number); }});
  }
}

/// Looks, finishes, lit spheres; presets have more than their list shows.
void addPictures(SideTabs& tabs, int page, Findables& found) {
  for (PictureList* list : tabs.widget(page)->findChildren<PictureList*>()) {
    if (qobject_cast<PresetGrid*>(list->parentWidget()) || !list->isVisibleTo(tabs.widget(page))) continue;
    for (const auto& [name, title] : list->titles())
      found.push_back({list->accessibleName() + " > " + title,
                       {},
                       list->toolTip(),
                       list->isEnabled(),
                       false,
                       [&tabs, list, name](const QString&) {
                         tabs.showPage(list);
                         emit list->chosen(name);
                       }});
  }
}

void addPresets(const WindowParts& parts, Findables& found) {
  auto* grid = parts.tabs.findChild<PresetGrid*>();
  if (!grid) return;
  bool isOn = grid->isEnabled();
  for (const auto& preset : scene::presets())
    found.push_back({PresetGrid::tr("Preset") + " > " + wordsOf(preset.title),
                     {},
                     {},
                     isOn,
                     false,
                     [&parts, grid, name = toText(preset.name)](const QString&) {
                       parts.tabs.showPage(grid);
                       grid->choose(name);
                     }});
}

void addStructures(const WindowParts& parts, Findables& found) {
  for (const auto& structure : parts.session.shown().labels.structures) {
    QString name = structure.name.empty() ? QString::number(structure.id) : QString::fromStdString(structure.name);
    found.push_back({Room::tr("Structure") + " > " + name,
                     {},
                     Room::tr("Go to this structure and select it"),
                     true,
                     false,
                     [&parts, id = structure.id](const QString&) {
                       parts.selection.setStructure(id);
                       parts.actions.find("structure.goTo")->trigger();
                     }});
  }
}

void addTypes(const WindowParts& parts, Findables& found) {
  const auto& model = parts.session.shown().model.data;
  for (int i = 0; model && i < int(model->types.size()); ++i) {
    // By both names, as people may know the one or the other.
    QString name = typeText(parts.session.shown().model, std::uint32_t(i)),
            inFile = readableText(model->types[std::size_t(i)].name);
    if (name != QString(inFile).replace('_', ' ')) name += QString(" (%1)").arg(inFile);
    found.push_back({Room::tr("Type") + " > " + name,
                     {},
                     Room::tr("Select this molecular type"),
                     true,
                     false,
                     [&parts, i](const QString&) {
                       parts.selection.setType(i);
                       parts.actions.find("model.list")->trigger();
                     }});
  }
}

}  // namespace

QString fullName(const QAction& action) {
  QString name = action.text();
  const QObject* owner = action.parent();
  for (auto* menu = qobject_cast<const QMenu*>(owner); menu; menu = qobject_cast<const QMenu*>(menu->parent()))
    if (!menu->title().isEmpty()) name = menu->title() + " > " + name;
  return name.remove('&').remove("...");
}

Findables findCommands(const ActionTable& actions) {
  Findables found;
  for (QAction* action : actions.all())
    found.push_back({fullName(*action), action->shortcut().toString(QKeySequence::NativeText), action->toolTip(),
                     action->isEnabled(), false, [action](const QString&) { action->trigger(); }, action->icon()});
  return found;
}

Findables findAll(const WindowParts& parts) {
  Findables found = findCommands(parts.actions);
  addPresets(parts, found);
  for (int page = 0; page < parts.tabs.count(); ++page) {
    if (!parts.tabs.isTabVisible(page)) continue;
    addNumbers(parts.tabs, page, found);
    addPictures(parts.tabs, page, found);
  }
  addStructures(parts, found);
  addTypes(parts, found);
  return found;
}

}  // namespace velum::gui
