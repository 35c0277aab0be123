#include "gui/cut/SpareList.h"

#include <QHBoxLayout>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "gui/kit/Widgets.h"
#include "scene/Scene.h"
#include "session/cut/CutEdit.h"

namespace velum::gui {

namespace {

constexpr int kIdRole = Qt::UserRole;
constexpr int kLeastHeight = 140, kSwatch = 13;

}  // namespace

void SpareModel::setRows(const std::vector<scene::Structure>& structures, const scene::Cut& cut) {
  std::vector<int> spared;
  for (const auto& structure : structures)
    if (session::isSpared(cut, structure.id)) spared.push_back(structure.id);
  bool sameRows =
      std::equal(structures.begin(), structures.end(), mStructures.begin(), mStructures.end(),
                 [](const auto& a, const auto& b) { return a.id == b.id && a.name == b.name && a.color == b.color; });
  if (sameRows && spared == mSpared) return;
  if (!sameRows) beginResetModel();
  mSpared = std::move(spared);
  if (!sameRows) {
    mStructures = structures;
    endResetModel();
  } else if (!mStructures.empty()) {
    emit dataChanged(index(0), index(int(mStructures.size()) - 1), {Qt::CheckStateRole});
  }
}

int SpareModel::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : int(mStructures.size()); }

bool SpareModel::isKept(int row) const {
  return std::find(mSpared.begin(), mSpared.end(), mStructures[std::size_t(row)].id) != mSpared.end();
}

QVariant SpareModel::data(const QModelIndex& index, int role) const {
  const scene::Structure& structure = mStructures[std::size_t(index.row())];
  switch (role) {
    case Qt::DisplayRole:
      return structure.name.empty() ? tr("structure %1").arg(structure.id) : QString::fromStdString(structure.name);
    case Qt::CheckStateRole:
      return isKept(index.row()) ? Qt::Checked : Qt::Unchecked;
    case Qt::DecorationRole: {
      glm::vec3 c = glm::clamp(structure.color, 0.0f, 1.0f);
      return QColor::fromRgbF(c.r, c.g, c.b);
    }
    case kIdRole:
      return structure.id;
    default:
      return {};
  }
}

bool SpareModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (role != Qt::CheckStateRole) return false;
  emit ticked(mStructures[std::size_t(index.row())].id, value.toInt() == Qt::Checked);
  return true;
}

Qt::ItemFlags SpareModel::flags(const QModelIndex&) const {
  return Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable;
}

SpareList::SpareList(QWidget* parent)
    : QWidget(parent),
      mModel(new SpareModel(this)),
      mFound(new QSortFilterProxyModel(this)),
      mTitle(makeTitle({}, this)),
      mSearch(new QLineEdit(this)),
      mList(new QListView(this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(8);
  auto* head = new QHBoxLayout;
  head->setSpacing(2);
  head->addWidget(mTitle, 1);
  for (bool whole : {true, false}) {
    auto* button = new QPushButton(whole ? tr("All") : tr("None"), this);
    button->setObjectName(whole ? "spareAll" : "spareNone");
    button->setProperty("role", "quiet");
    button->setToolTip(whole ? tr("Leave all that are listed whole") : tr("Cut all that are listed"));
    head->addWidget(button);
    connect(button, &QPushButton::clicked, this, [this, whole] { emit changed(listedIds(), whole); });
  }
  layout->addLayout(head);
  mSearch->setObjectName("spareSearch");
  mSearch->setPlaceholderText(tr("Search structures"));
  mSearch->setClearButtonEnabled(true);
  mSearch->setAccessibleName(tr("Search structures to spare"));
  mSearch->setToolTip(tr("Lists the structures whose name holds these letters"));
  layout->addWidget(mSearch);
  mFound->setSourceModel(mModel);
  mFound->setFilterCaseSensitivity(Qt::CaseInsensitive);
  mList->setObjectName("spareList");
  mList->setAccessibleName(tr("Structures that the cut spares"));
  mList->setToolTip(tr("Ticked structures are left whole by the selected cut"));
  mList->setModel(mFound);
  mList->setUniformItemSizes(true);
  mList->setIconSize({kSwatch, kSwatch});
  mList->setSpacing(1);
  mList->setMinimumHeight(kLeastHeight);
  layout->addWidget(mList, 1);
  connect(mSearch, &QLineEdit::textChanged, mFound, &QSortFilterProxyModel::setFilterFixedString);
  connect(mModel, &SpareModel::ticked, this, [this](int id, bool whole) { emit changed({id}, whole); });
}

std::vector<int> SpareList::listedIds() const {
  std::vector<int> ids;
  for (int i = 0; i < mFound->rowCount(); ++i) ids.push_back(mFound->index(i, 0).data(kIdRole).toInt());
  return ids;
}

void SpareList::showCut(const std::vector<scene::Structure>& structures, const scene::Cut& cut) {
  setVisible(!structures.empty());
  if (structures.empty()) return;
  mModel->setRows(structures, cut);
  auto count = std::count_if(cut.spares.begin(), cut.spares.end(),
                             [&](const auto& spare) { return session::isSpared(cut, spare.structure); });
  mTitle->setText(count == 0 ? tr("Spares: nothing") : tr("Spares: %1").arg(count));
}

}  // namespace velum::gui
