#include "gui/structure/StructureCommands.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "gui/kit/Words.h"
#include "gui/rows/FieldKey.h"
#include "gui/rows/PictureList.h"
#include "scene/LitSpheres.h"
#include "session/command/Command.h"
#include "session/command/CutCommands.h"
#include "session/command/LetteringCommands.h"
#include "session/command/MarkCommands.h"
#include "session/command/StructureCommands.h"
#include "session/cut/CutEdit.h"
#include "session/membrane/MembraneEdit.h"

namespace velum::gui {

namespace {
QIcon iconOf(const Image& picture) { return QIcon(QPixmap::fromImage(toQImage(picture))); }
}  // namespace

StructureCommands::StructureCommands(session::Document& document, Selection& selection, QObject* parent)
    : QObject(parent), mDocument(document), mSelection(selection), mFlight(document, nullptr) {
  connect(&mMeter, &StructureMeter::measured, this, [this] {
    if (mGoTo) goTo(mGoTo);
  });
}

std::vector<std::string> StructureCommands::named(const Ids& ids) const {
  return session::structureNames(mDocument.shown(), ids);
}

void StructureCommands::setVisible(const Ids& ids, bool visible) {
  if (!ids.empty()) session::edit(mDocument, session::ShowStructures{named(ids), visible});
}

void StructureCommands::invertVisible(const Ids& ids) {
  session::edit(mDocument, session::InvertStructures{named(ids)});
}

void StructureCommands::toggleSolo(int id) {
  if (!session::findStructure(mDocument.shown(), id)) return;
  session::SoloStructure call{named({id})[0]};
  if (mSolo.structure > 0 && session::soloStructure(mDocument.shown()) == mSolo.structure) {
    Ids shown = mSolo.visible;
    std::erase_if(shown, [&](int one) { return !session::findStructure(mDocument.shown(), one); });
    call.shown = named(shown);
    call.unlabelled = mSolo.unlabelled;
  }
  scene::Scene after = mDocument.shown();
  session::SoloMemory next = session::toggleSolo(after, mSolo, id);
  session::edit(mDocument, call);
  mSolo = next;
}

void StructureCommands::setColor(const Ids& ids, glm::vec3 color) {
  session::edit(mDocument, session::ColorStructures{named(ids), color});
}

void StructureCommands::dragOpacity(const Ids& ids, double opacity) {
  session::edit(mDocument, session::SetStructureOpacity{named(ids), std::clamp(opacity, 0.0, 1.0)}, true);
}

void StructureCommands::rename(int id, const QString& name) {
  session::edit(mDocument, session::RenameStructure{named({id})[0], name.toStdString()});
}

void StructureCommands::listInLegend(const Ids& ids, bool listed) {
  session::edit(mDocument, session::ListStructuresInLegend{named(ids), listed});
}

void StructureCommands::setShowAs(const Ids& ids, scene::ShowAs as) {
  if (!ids.empty()) session::edit(mDocument, session::ShowStructuresAs{named(ids), as});
}

void StructureCommands::setLitSphere(const Ids& ids, const QString& name) {
  session::edit(mDocument, session::SetStructureSphere{named(ids), name.toStdString()});
}

const scene::Cut* StructureCommands::cut() const { return scene::findCut(mDocument.shown(), mSelection.cut()); }

QString StructureCommands::cutName() const {
  const scene::Cut* selected = cut();
  if (!selected) return {};
  if (!selected->name.empty()) return QString::fromStdString(selected->name);
  return tr("cut %1").arg(scene::cutPlace(mDocument.shown(), selected->id) + 1);
}

bool StructureCommands::isSpared(int id) const {
  const scene::Cut* selected = cut();
  return selected && session::isSpared(*selected, id);
}

void StructureCommands::setSpared(const Ids& ids, bool whole) {
  if (const scene::Cut* selected = cut())
    session::edit(mDocument,
                  session::SpareStructures{named(ids), whole, session::cutKey(mDocument.shown(), selected->id)});
}

const scene::Membrane* StructureCommands::membrane() const {
  const scene::Cut* selected = cut();
  return selected && scene::isMembrane(*selected) ? &*selected->membrane : nullptr;
}

double StructureCommands::strengthOf(int id) const {
  const scene::Membrane* sheet = membrane();
  if (!sheet) return 0.0;
  for (const auto& one : sheet->field.byLabel)
    if (one.id == id) return one.strength;
  return 0.0;
}

void StructureCommands::setStrength(const Ids& ids, double strength) {
  if (membrane())
    session::edit(mDocument,
                  session::ProtectStructures{named(ids), strength, session::cutKey(mDocument.shown(), cut()->id)});
}

void StructureCommands::goTo(int id) {
  mGoTo = mMeter.isMeasuring() ? id : 0;
  const session::StructureSize* size = mMeter.find(id);
  if (!size) return;
  mGoTo = 0;
  const LabelVolume& labels = *mMeter.labels();
  glm::dvec3 middle = session::middleOfStructure(labels, id, *size);
  mDocument.view([middle](scene::Scene& scene) {
    scene.sections.crosshair = middle;
    scene.sections.isPlaced = true;
  });
  mFlight.start(session::closeUp(mDocument.shown().camera, middle, session::radiusOfStructure(labels, *size), 1.0));
}

/// What the selected membrane does with structures; nothing where another cut is selected.
void StructureCommands::fillMembraneMenu(QMenu& menu, const Ids& ids) {
  if (!membrane()) return;
  auto add = [&](const QString& text, const QString& tip, double sign) {
    QAction* action = menu.addAction(text);
    action->setToolTip(tip);
    action->setCheckable(true);
    action->setChecked(std::all_of(ids.begin(), ids.end(), [&](int id) { return strengthOf(id) * sign > 0; }));
    connect(action, &QAction::triggered, this,
            [this, ids, sign](bool on) { setStrength(ids, on ? sign * session::kProtectStrength : 0.0); });
  };
  add(tr("Protect by membrane"), tr("The selected membrane's sheet goes around it"), 1.0);
  add(tr("Draw membrane to it"), tr("The selected membrane's sheet is drawn to it"), -1.0);
}

/// The three ways to show a structure.
void StructureCommands::fillShowMenu(QMenu& menu, const Ids& ids) {
  auto add = [&](const QString& text, const QString& tip, bool isOn, const std::function<void()>& run) {
    QAction* action = menu.addAction(text, this, run);
    action->setToolTip(tip);
    action->setCheckable(true);
    action->setChecked(isOn);
  };
  auto isShownAs = [&](scene::ShowAs as) {
    return std::all_of(ids.begin(), ids.end(), [&](int id) {
      const scene::Structure* structure = session::findStructure(mDocument.shown(), id);
      return structure && structure->visible && structure->showAs == as;
    });
  };
  bool isAlone = !mDocument.shown().volume.data || !mDocument.shown().volume.visible;
  if (!isAlone) {
    add(tr("Solid"), tr("A closed surface of its colour, whatever the curve of opacity says"),
        isShownAs(scene::ShowAs::Solid), [this, ids] { setShowAs(ids, scene::ShowAs::Solid); });
    add(tr("Material"), tr("The values in it, by the curve of opacity, tinted with its colour"),
        isShownAs(scene::ShowAs::Material), [this, ids] { setShowAs(ids, scene::ShowAs::Material); });
  }
  bool isHidden = std::none_of(ids.begin(), ids.end(), [&](int id) {
    const scene::Structure* structure = session::findStructure(mDocument.shown(), id);
    return structure && structure->visible;
  });
  add(tr("Hidden"), tr("It is not drawn"), isHidden, [this, ids, isHidden] { setVisible(ids, isHidden); });
}

void StructureCommands::fillSphereMenu(QMenu& menu, const Ids& ids) {
  QMenu* spheres = menu.addMenu(tr("Lit sphere"));
  spheres->setToolTip(tr("How the material looks in a finished picture"));
  QString now = QString::fromStdString(session::findStructure(mDocument.shown(), ids[0])->litSphere);
  auto add = [&](const QString& name, const QString& title, const QIcon& icon) {
    QAction* action = spheres->addAction(icon, title, this, [this, ids, name] { setLitSphere(ids, name); });
    action->setCheckable(true);
    action->setChecked(name == now);
  };
  add({}, tr("As the finish"), {});
  spheres->addSeparator();
  for (const scene::LitSphereName& sphere : scene::litSpheres())
    add(QString::fromUtf8(sphere.name.data(), int(sphere.name.size())), wordsOf(sphere.title),
        iconOf(scene::makeLitSphere(sphere.name, 32)));
  for (const scene::LitSphere& own : mDocument.shown().finish.spheres)
    add(QString::fromStdString(own.name), QString::fromStdString(own.name), own.data ? iconOf(*own.data) : QIcon());
}

/// Whether the legend lists them. Nothing for one without a name, which it cannot say.
void StructureCommands::fillLegendEntry(QMenu& menu, const Ids& ids) {
  const std::vector<std::string>& entries = mDocument.shown().lettering.entries;
  auto nameOf = [this](int id) { return session::findStructure(mDocument.shown(), id)->name; };
  if (std::any_of(ids.begin(), ids.end(), [&](int id) { return nameOf(id).empty(); })) return;
  QAction* list = menu.addAction(tr("List in legend"), this, [this, ids](bool on) { listInLegend(ids, on); });
  list->setCheckable(true);
  list->setChecked(std::all_of(ids.begin(), ids.end(), [&](int id) {
    return std::find(entries.begin(), entries.end(), nameOf(id)) != entries.end();
  }));
  list->setToolTip(tr("The legend names what is listed; where nothing is, the structures that are shown"));
}

/// Marks of one structure: its name where it is seen best, and what it measures.
void StructureCommands::fillMarkEntries(QMenu& menu, int id) {
  auto add = [&](const QString& text, const QString& tip, scene::MarkKind kind) {
    QAction* action = menu.addAction(text, this, [this, id, kind] {
      session::AddMark mark{.kind = kind};
      mark.structure = named({id})[0];
      session::edit(mDocument, mark);
    });
    action->setToolTip(tip);
    action->setEnabled(mDocument.shown().lettering.marks.size() < scene::kMostMarks);
  };
  add(tr("Name this"), tr("Its name beside it in the picture, with a leader; the page Marks lists it"),
      scene::MarkKind::Name);
  add(tr("Measure this"), tr("Its volume and its values, in the page Marks"), scene::MarkKind::Region);
}

/// Keys of a film.
void StructureCommands::fillKeyEntries(QMenu& menu, int id) {
  const auto& list = mDocument.shown().labels.structures;
  auto place = std::ranges::find(list, id, &scene::Structure::id) - list.begin();
  QMenu* keys = menu.addMenu(tr("Key in film"));
  keys->setToolTipsVisible(true);
  addKeyEntry(*keys, mDocument, "labels.structures." + std::to_string(place) + ".visible", tr("visibility"));
  addKeyEntry(*keys, mDocument, "labels.structures." + std::to_string(place) + ".opacity", tr("opacity"));
}

void StructureCommands::fillMenu(QMenu& menu, const Ids& ids) {
  if (ids.empty()) return;
  const scene::Structure* first = session::findStructure(mDocument.shown(), ids[0]);
  if (!first) return;
  bool one = ids.size() == 1;
  menu.setToolTipsVisible(true);
  QAction* title = menu.addAction(one ? QString::fromStdString(session::structureName(mDocument.shown(), ids[0]))
                                      : tr("%n structures", nullptr, int(ids.size())));
  title->setEnabled(false);
  menu.addSeparator();
  fillShowMenu(menu, ids);
  menu.addSeparator();
  if (one) {
    bool solo = session::soloStructure(mDocument.shown()) == ids[0];
    menu.addAction(solo ? tr("End solo") : tr("Solo"), this, [this, ids] { toggleSolo(ids[0]); })
        ->setToolTip(solo ? tr("Show again what was shown before") : tr("Show nothing but this"));
    menu.addAction(tr("Go there"), this, [this, ids] { goTo(ids[0]); })
        ->setToolTip(tr("Bring the camera near and the crosshair into its middle"));
    menu.addAction(tr("Rename..."), this, [this, ids] { emit renameAsked(ids[0]); });
  }
  fillLegendEntry(menu, ids);
  if (one) fillMarkEntries(menu, ids[0]);
  if (one) fillKeyEntries(menu, ids[0]);
  menu.addSeparator();
  QString name = cutName();
  QAction* whole = menu.addAction(name.isEmpty() ? tr("Spare") : tr("Spare in %1").arg(name));
  whole->setCheckable(true);
  whole->setChecked(std::all_of(ids.begin(), ids.end(), [this](int id) { return isSpared(id); }));
  whole->setEnabled(!name.isEmpty());
  whole->setToolTip(name.isEmpty() ? tr("Add or select a cut first")
                                   : tr("The selected cut spares it: it stands out of the cut"));
  connect(whole, &QAction::triggered, this, [this, ids](bool on) { setSpared(ids, on); });
  fillMembraneMenu(menu, ids);
  menu.addSeparator();
  fillSphereMenu(menu, ids);
  menu.addAction(tr("Export..."), this, [this, ids] { emit exportAsked(ids); })
      ->setToolTip(tr("Write it as a surface or as labels, for other programs"));
}

}  // namespace velum::gui
