#include "gui/window/StatusLine.h"

#include <QLocale>
#include <cmath>

#include "core/BrickCache.h"
#include "core/Text.h"
#include "gui/kit/CoreWords.h"
#include "gui/kit/Length.h"
#include "gui/kit/Text.h"
#include "gui/kit/Words.h"
#include "scene/Crowd.h"
#include "scene/GreyWindows.h"
#include "session/model/ModelEdit.h"

namespace velum::gui {

namespace {

/// Type, compartment and number of an instance of the model; empty for all else.
QString instanceText(const scene::Scene& scene, const render::Pick& pick) {
  auto place = pick.type >= 0 ? session::instancePlace(scene, pick.modelInstance) : std::nullopt;
  if (!place) return {};
  const Model& model = *scene.model.data;
  if (place->isWhole) {
    auto copies = scene::copyCount(scene.model);
    return "    " + typeText(scene.model, std::uint32_t(pick.type)) +
           StatusLine::tr(" in copy %1 of %2").arg(place->copy + 1).arg(copies);
  }
  const MoleculeType& type = model.types[place->type];
  const Compartment& compartment = model.compartments[type.compartment];
  QString text = "    " + typeText(scene.model, place->type);
  if (compartment.parent >= 0)
    text += StatusLine::tr(" in %1").arg(
        toText(scene::shownName(scene.model, session::compartmentPath(model, type.compartment), compartment.name)));
  return text + StatusLine::tr(", %1 of %2").arg(place->ofType + 1).arg(type.instanceCount);
}

QString shortNumber(double value) { return localNumber(tidyNumber(value)); }

}  // namespace

StatusLine::StatusLine(const WindowParts& parts, QStatusBar& bar)
    : Room(parts),
      mData(new QLabel(tr("Nothing is open"), &bar)),
      mPick(new QLabel(&bar)),
      mStreaming(new QLabel(&bar)),
      mReduction(new QLabel(&bar)),
      mRefine(new QLabel(&bar)),
      mDriver(new QLabel(&bar)) {
  bar.setSizeGripEnabled(false);
  mReduction->setProperty("role", "alarm");
  mRefine->setObjectName("refined");
  mRefine->setToolTip(tr("How far the picture is refined"));
  bar.addWidget(mData);
  bar.addWidget(mStreaming);
  bar.addWidget(mReduction);
  mStreaming->setObjectName("streaming");
  bar.addPermanentWidget(mPick);
  bar.addPermanentWidget(mRefine);
  bar.addPermanentWidget(mDriver);
  connect(&parts.views, &ViewGrid::pointedAt, this, &StatusLine::showPick);
  connect(&parts.views, &ViewGrid::pointedAtNothing, mPick, &QLabel::clear);
  connect(&parts.views.viewport(), &Viewport::refined, this, &StatusLine::showProgress);
}

void StatusLine::showProgress(double fraction, const QString& stage) {
  mRefine->setText(stage.isEmpty() ? tr("Complete")
                   : fraction > 0  ? QString("%1 %2 %").arg(stage).arg(int(100 * fraction))
                                   : stage);
  render::Stats stats = mParts.views.viewport().stats();
  QString driver = QString::fromStdString(stats.renderer);
  mDriver->setText(driver.section(" (", 0, 0).section('/', 0, 0));
  mDriver->setToolTip(tr("Drawn by %1").arg(driver));
  showStreaming(stats.streaming);
  QString reduction = inWords(stats.reduction);
  mReduction->setText(reduction.isEmpty() ? QString() : tr("Reduced"));
  mReduction->setToolTip(reduction);
}

/// How much of what is seen is at which level, and what is on its way.
void StatusLine::showStreaming(const render::Streaming& streaming) {
  const auto& volume = mParts.session.shown().volume.data;
  if (!volume || !volume->finer) return mStreaming->clear();
  QStringList levels, lines;
  for (std::size_t i = 0; i < streaming.shares.size(); ++i) {
    auto percent = int(std::lround(100.0 * streaming.shares[i]));
    if (percent == 0) continue;
    glm::ivec3 dims = volume->finer->bricks->source().levels()[i].dims;
    levels << tr("%1: %2 %").arg(i).arg(percent);
    lines << QString::fromUtf8("%1: %2 \u00d7 %3 \u00d7 %4, %5 %")
                 .arg(i)
                 .arg(dims.x)
                 .arg(dims.y)
                 .arg(dims.z)
                 .arg(percent);
  }
  QString text = levels.isEmpty() ? tr("streamed") : tr("level ") + levels.join(", ");
  if (streaming.missing > 0) text += tr(", %n brick(s) to come", nullptr, int(streaming.missing));
  mStreaming->setText(text);
  auto mebibytes = [](double bytes) { return qint64(bytes / (1 << 20)); };
  QString tip = tr("Of what is seen, how much is shown at which level of detail, 0 the finest:");
  for (const QString& line : lines) tip += "\n" + line;
  tip += "\n" + tr("Bricks take %1 of %2 MiB of the graphics memory and %3 of %4 MiB of the machine's.")
                    .arg(mebibytes(streaming.usedBytes))
                    .arg(mebibytes(streaming.budgetBytes))
                    .arg(mebibytes(double(volume->finer->bricks->bytes())))
                    .arg(mebibytes(double(volume->finer->bricks->mostBytes())));
  if (streaming.coarser > 1.0)
    tip += "\n" +
           tr("They have no room: all is shown %L1 times coarser than pixels. Edit > Preferences > Memory gives more.")
               .arg(streaming.coarser, 0, 'f', 1);
  mStreaming->setToolTip(tip);
}

void StatusLine::refresh(const session::Session& session) {
  const scene::Scene& scene = session.shown();
  showStreaming(mParts.views.viewport().stats().streaming);
  mPick->setToolTip(hasPatientLetters(scene)
                        ? tr("Under the pointer: value, position in patient coordinates (L, P, S), structure")
                        : tr("Under the pointer: position along x, y and z, and what is there"));
  if (const auto& v = scene.volume.data) {
    glm::ivec3 size = v->finer ? v->finer->bricks->source().levels().front().dims : v->dims;
    glm::dmat3 edges(worldFromBox(*v));  // of the finest level's box
    glm::dvec3 shown = glm::dvec3(glm::length(edges[0]), glm::length(edges[1]), glm::length(edges[2])) /
                       glm::dvec3(size) * Length(scene).shownPerLength();
    QString times = QString::fromUtf8(" \u00d7 ");
    std::string valueUnit = scene::valueUnit(*v);
    QString unit = valueUnit.empty() ? QString() : " " + QString::fromStdString(valueUnit);
    auto type = enumName(v->type);
    QStringList dims, spacing;
    for (int i = 0; i < 3; ++i) {
      dims << QString::number(size[i]);
      spacing << shortNumber(shown[i]);
    }
    QString text = dims.join(times) + "    ";
    text += v->isSpacingKnown ? spacing.join(times) + Length(scene).suffix() : tr("spacing unknown");
    text += "    " + tr("%1    %2 to %3%4")
                         .arg(QString::fromUtf8(type.data(), int(type.size())), shortNumber(v->range.x),
                              shortNumber(v->range.y), unit);
    mData->setText(text);
    mData->setToolTip(
        tr("Voxels, spacing, sample type and range of values of %1").arg(QString::fromStdString(v->name)));
  } else if (scene.labels.data) {
    mData->setText(tr("%n structure(s)", nullptr, int(scene.labels.structures.size())));
  } else if (const auto& model = scene.model.data) {
    std::uint64_t instances = scene::instanceCount(scene.model);
    mData->setText(
        tr("%1 instances of %2 types").arg(QLocale().toString(qulonglong(instances))).arg(model->types.size()));
    mData->setToolTip(readableText(model->name));
  } else {
    mData->setText(scene.surfaces.empty() ? tr("Nothing is open")
                                          : tr("%n surface(s)", nullptr, int(scene.surfaces.size())));
  }
}

void StatusLine::showPick(const render::Pick& pick) {
  const auto& scene = mParts.session.shown();
  QString text;
  QStringList values;
  for (double value : render::probe(scene, pick.world).values) values << shortNumber(value);
  if (const auto& v = scene.volume.data; v && !values.isEmpty())
    text = QString("%1 %2    ").arg(values.join(", "), QString::fromStdString(scene::valueUnit(*v)));
  bool letters = hasPatientLetters(scene);
  Length length(scene);
  static constexpr const char* kPlus[] = {"L", "P", "S"};
  static constexpr const char* kMinus[] = {"R", "A", "I"};
  for (int i = 0; i < 3; ++i) {
    double at = pick.world[i];
    bool isMinus = length.number(at).startsWith('-');
    text += letters ? QString("%1 %2  ").arg(isMinus ? kMinus[i] : kPlus[i], length.number(std::abs(at)))
                    : length.number(at) + "  ";
  }
  text += length.unit();
  for (const auto& structure : scene.labels.structures)
    if (structure.id == pick.structure) text += "    " + QString::fromStdString(structure.name);
  text += instanceText(scene, pick);
  mPick->setText(text);
}

}  // namespace velum::gui
