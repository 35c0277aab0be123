#pragma once
#include <QAbstractTableModel>
#include <QCollator>
#include <QSortFilterProxyModel>
#include <optional>
#include <vector>

#include "gui/rows/CountBar.h"
#include "gui/structure/AreaMeter.h"
#include "gui/structure/StructureMeter.h"
#include "scene/Structure.h"

namespace velum::gui {

/// The structures of a scene as rows. Follows the scene by differences, so that thousands of rows cost nothing while
/// something else changes.
class StructureModel : public QAbstractTableModel {
  Q_OBJECT
 public:
  enum Column { Eye, Swatch, Name, Size, Mean, Most, Opacity, Solo, Bar, kColumns };
  enum Role {
    IdRole = Qt::UserRole,
    VisibleRole,
    ColorRole,
    OpacityRole,
    SoloRole,
    VoxelsRole,
    AbsentRole,
    MeanRole,  ///< Of the scan's values in it; invalid while it is not known, as the next.
    MostRole
  };

  StructureModel(const StructureMeter& meter, const AreaMeter& areas, QObject* parent);

  /// Takes the structures over, row by row where the ids are the same.
  /// @param solo  that is shown alone
  void setRows(const std::vector<scene::Structure>& rows, std::optional<int> solo);
  /// Of the scene: sizes are told in ml, or in nm^3.
  void setLengthUnit(LengthUnit unit);
  /// The sizes are known, or no longer.
  void sizesChanged();
  /// What the scan measured in them is known, or no longer.
  void valuesChanged();
  /// How much of the picture they take is known, or another.
  void areasChanged();
  /// The bar of a row in a cell.
  CountBar barOf(int id, QRect cell) const;
  /// -1: no such row.
  int rowOf(int id) const;

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;

 signals:
  void renamed(int id, const QString& name);

 private:
  QString sizeText(int id) const;
  QString valueText(int id, Column column) const;
  QString valuesTip(int id) const;
  QString tipOf(const scene::Structure& structure, int column) const;

  const StructureMeter& mMeter;
  const AreaMeter& mAreas;
  LengthUnit mLengthUnit = LengthUnit::Millimetre;
  std::vector<scene::Structure> mRows;
  std::optional<int> mSolo;
};

/// Sorts and searches them: by words of the name, or by the number.
class StructureOrder : public QSortFilterProxyModel {
  Q_OBJECT
 public:
  enum class Key { Number, Name, Size, Mean, Most };
  explicit StructureOrder(QObject* parent);
  void setKey(Key key);
  Key key() const { return mKey; }
  /// Rows stay whose name holds every word, or whose number is the text.
  void setSearch(const QString& text);
  bool isSearching() const { return !mWords.isEmpty(); }
  /// Rows of structures without voxels stay, too.
  void setAbsentShown(bool shown);

 protected:
  bool filterAcceptsRow(int row, const QModelIndex& parent) const override;
  bool lessThan(const QModelIndex& left, const QModelIndex& right) const override;

 private:
  Key mKey = Key::Number;
  QStringList mWords;
  bool mIsAbsentShown = false;
  QCollator mCollator;
};

}  // namespace velum::gui
