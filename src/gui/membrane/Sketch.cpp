#include "gui/membrane/Sketch.h"

#include <algorithm>
#include <cmath>

#include "gui/membrane/StrengthCanvas.h"
#include "gui/service/SelectedCut.h"
#include "gui/tool/StrokePaint.h"
#include "session/membrane/Sketch.h"
#include "session/membrane/StrokeSamples.h"

namespace velum::gui {

namespace {

constexpr double kRadiusStep = 1.15;
constexpr double kFirstShare = 0.02;  // radius of the first brush, of the data's

/// Two digits are enough for a brush.
double rounded(double length) {
  double unit = std::pow(10.0, std::floor(std::log10(std::max(length, 1e-9))) - 1.0);
  return std::round(length / unit) * unit;
}

}  // namespace

Sketch::Sketch(session::Document& document, Selection& selection, Toolbox& toolbox, QObject* parent)
    : QObject(parent), mDocument(document), mSelection(selection), mToolbox(toolbox) {
  connect(&selection, &Selection::cutChanged, this, [this] {
    select(-1);
    mToolbox.repaint();
  });
}

const std::vector<scene::Stroke>* Sketch::strokes() const {
  const scene::Cut* cut = selectedMembrane(mDocument, mSelection);
  return cut ? &cut->membrane->field.strokes : nullptr;
}

void Sketch::refresh() {
  const auto& volume = mDocument.shown().volume.data;
  if (volume && mFitted != volume.id()) {
    mFitted = volume.id();
    mRadius = rounded(kFirstShare * velum::radiusOf(*volume));
    emit radiusChanged(mRadius);
  }
  const Strokes* all = strokes();
  if (mSelected >= 0 && (!all || mSelected >= int(all->size()))) select(-1);
}

void Sketch::select(int stroke) {
  if (stroke == mSelected) return;
  mDocument.endMerge();
  mSelected = stroke;
  if (const Strokes* all = strokes(); all && stroke >= 0 && stroke < int(all->size())) {
    mRadius = (*all)[std::size_t(stroke)].radius;
    emit radiusChanged(mRadius);
  }
  emit selectedChanged(stroke);
  mToolbox.repaint();
}

void Sketch::setRadius(double length) {
  if (!(length > 0) || length == mRadius) return;
  mRadius = length;
  emit radiusChanged(length);
  if (mSelected >= 0)
    edit(
        "Change stroke's radius",
        [this](Strokes& all) {
          if (mSelected < int(all.size())) all[std::size_t(mSelected)].radius = mRadius;
        },
        true);
  mToolbox.repaint();
}

void Sketch::turnRadius(double notches) { setRadius(rounded(mRadius * std::pow(kRadiusStep, notches))); }

void Sketch::remove(int stroke) {
  const Strokes* all = strokes();
  if (!all || stroke < 0 || stroke >= int(all->size())) return;
  select(-1);
  edit("Remove stroke", [stroke](Strokes& list) { list.erase(list.begin() + stroke); });
}

void Sketch::addStroke(const scene::Stroke& stroke, const std::string& label) {
  edit(label, [&](Strokes& all) { all.push_back(stroke); });
}

/// Counted once for each volume, so that fitting costs what is under the strokes.
const Histogram& Sketch::whole() {
  const auto& layer = mDocument.shown().volume;
  std::tuple now{layer.data.id(), layer.channel, layer.timeStep};
  if (now != mCounted) mWhole = session::wholeHistogram(layer);
  mCounted = now;
  return mWhole;
}

void Sketch::edit(const std::string& label, const std::function<void(Strokes&)>& change, bool merge) {
  if (!isReady()) return;
  Strokes next = *strokes();
  change(next);
  editSelectedMembrane(
      mDocument, mSelection, label,
      [&](scene::Membrane& m) { session::setStrokes(m.field, next, mDocument.shown().volume, whole()); }, merge);
}

KeyAnswer Sketch::radiusKey(const KeyStroke& stroke) {
  bool isWider = stroke.key == Qt::Key_BracketRight, isNarrower = stroke.key == Qt::Key_BracketLeft;
  if (stroke.isTyping || (!isWider && !isNarrower)) return {};
  return [this, notches = isWider ? 1.0 : -1.0] { turnRadius(notches); };
}

KeyAnswer Sketch::key(const KeyStroke& stroke) {
  if (mSelected < 0) return {};
  if (stroke.view && stroke.key == Qt::Key_Delete) return [this] { remove(mSelected); };
  if (stroke.key == Qt::Key_Escape) return [this] { select(-1); };
  return radiusKey(stroke);
}

void Sketch::paint(ViewPainter& over) const {
  const Strokes* all = strokes();
  for (std::size_t i = 0; all && i < all->size(); ++i) {
    const scene::Stroke& stroke = (*all)[i];
    paintStroke(over, stroke.path, stroke.radius, stroke.avoid ? kAvoidColor : kKeepColor, int(i) == mSelected);
  }
}

}  // namespace velum::gui
