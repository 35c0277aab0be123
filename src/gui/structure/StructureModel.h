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

/// The structures of a scene as rows. Only rows that differ from the scene are changed, so that thousands of rows cost
/// nothing while something else changes.
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
    MeanRole,  ///< Mean of the scan's values in the structure; this and MostRole are invalid while not known.
    MostRole
  };

  StructureModel(const StructureMeter& meter, const AreaMeter& areas, QObject* parent);

  /// Shows the scene's structures; where the ids are as before only rows that differ are changed. @param solo  the
  /// structure that is shown alone
  void setRows(const std::vector<scene::Structure>& rows, std::optional<int> solo);
  /// Sets the scene's unit of length: it decides whether sizes are told in ml, or in nm^3.
  void setLengthUnit(LengthUnit unit);
  /// To be called when the sizes have become known, or are no longer.
  void sizesChanged();
  /// To be called when the scan's values in the structures have become known, or are no longer.
  void valuesChanged();
  /// To be called when the areas of the structures in the picture have become known, or have changed.
  void areasChanged();
  /// The bar of a structure, laid out in a cell.
  CountBar barOf(int id, QRect cell) const;
  /// The row of a structure; -1: it has none.
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

/// Sorts the rows of a StructureModel and searches them: by words of the name, or by the number.
class StructureOrder : public QSortFilterProxyModel {
  Q_OBJECT
 public:
  enum class Key { Number, Name, Size, Mean, Most };
  explicit StructureOrder(QObject* parent);
  void setKey(Key key);
  Key key() const { return mKey; }
  /// Leaves the rows whose name holds every word of the text, or whose number is the text.
  void setSearch(const QString& text);
  bool isSearching() const { return !mWords.isEmpty(); }
  /// Sets whether the rows of structures without voxels are shown, too.
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
