#include "gui/extrusion/ExtrusionList.h"

#include <QPainter>
#include <QSignalBlocker>
#include <QStyledItemDelegate>

#include "gui/kit/CutTitle.h"
#include "gui/kit/Length.h"
#include "gui/rows/RowPaint.h"
#include "session/structure/StructureEdit.h"

namespace velum::gui {

namespace {

constexpr int kSwatchEdge = 14;
/// Pixels, however many rows there are, so that the widgets below keep their place.
constexpr int kHeight = 150;

/// Rows as wide as the list: what is longer is elided, not scrolled to.
class Delegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    return {1, QStyledItemDelegate::sizeHint(option, index).height()};
  }
};

QIcon swatchOf(const scene::Scene& scene, int structure, const QColor& line) {
  const scene::Structure* row = session::findStructure(scene, structure);
  glm::vec3 color = row ? row->color : glm::vec3(0.6f);
  QPixmap pixmap(kSwatchEdge, kSwatchEdge);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  paintSwatch(painter, QRectF(0.5, 0.5, kSwatchEdge - 1, kSwatchEdge - 1), QColor::fromRgbF(color.r, color.g, color.b),
              line);
  return pixmap;
}

}  // namespace

ExtrusionList::ExtrusionList(QWidget* parent) : QListWidget(parent) {
  setObjectName("extrusionList");
  setAccessibleName(tr("Structures that are pulled out"));
  setToolTip(tr("What stands out of the cuts, and how far"));
  setSelectionMode(QAbstractItemView::ExtendedSelection);
  setUniformItemSizes(true);
  setIconSize({kSwatchEdge, kSwatchEdge});
  // In a long row the middle is left out, as the end tells how far, and out of which cut, the structure stands.
  setItemDelegate(new Delegate(this));
  setTextElideMode(Qt::ElideMiddle);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setFixedHeight(kHeight);
  connect(this, &QListWidget::currentRowChanged, this, [this](int row) {
    if (row >= 0 && row < int(mExtrusions.size())) emit chosen(mExtrusions[std::size_t(row)]);
  });
}

void ExtrusionList::showScene(const scene::Scene& scene, const std::vector<session::Extrusion>& extrusions) {
  const QSignalBlocker quiet(this);
  auto was = current();
  mExtrusions = extrusions;
  Length length(scene);
  while (count() > int(extrusions.size())) delete takeItem(count() - 1);
  while (count() < int(extrusions.size())) addItem(new QListWidgetItem);
  for (int i = 0; i < count(); ++i) {
    const auto& one = extrusions[std::size_t(i)];
    QString name = one.structure == 0 ? tr("What has no label")
                                      : QString::fromStdString(session::structureName(scene, one.structure));
    QString text = tr("%1   %2").arg(name, length.text(one.distance));
    if (scene.cuts.size() > 1) text = tr("%1 out of %2").arg(text, cutTitle(scene, one.cut));
    item(i)->setText(text);
    item(i)->setToolTip(text);
    item(i)->setIcon(swatchOf(scene, one.structure, palette().color(QPalette::Dark)));
  }
  if (was) select(was->cut, was->structure);
}

void ExtrusionList::select(int cut, int structure) {
  const QSignalBlocker quiet(this);
  auto isIt = [&](const auto& one) { return one.cut == cut && one.structure == structure; };
  auto found = std::find_if(mExtrusions.begin(), mExtrusions.end(), isIt);
  int row = int(found - mExtrusions.begin());
  // A row that is current already may be one of several that are selected.
  if (found != mExtrusions.end() && row != currentRow()) setCurrentRow(row, QItemSelectionModel::ClearAndSelect);
}

std::optional<session::Extrusion> ExtrusionList::current() const {
  int row = currentRow();
  if (row < 0 || row >= int(mExtrusions.size())) return std::nullopt;
  return mExtrusions[std::size_t(row)];
}

std::vector<session::Extrusion> ExtrusionList::selected() const {
  std::vector<session::Extrusion> out;
  for (const auto& index : selectedIndexes())
    if (index.row() < int(mExtrusions.size())) out.push_back(mExtrusions[std::size_t(index.row())]);
  return out;
}

}  // namespace velum::gui
