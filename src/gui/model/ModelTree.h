#pragma once
#include <QColor>
#include <QFontMetrics>
#include <optional>
#include <vector>

#include "gui/model/Equalizer.h"
#include "gui/rows/BarScale.h"
#include "gui/rows/TypeTree.h"
#include "scene/ModelLayer.h"

namespace velum::gui {

/// The types of the scene's model, with whether each type is shown, and how many of its instances are: the numbers are
/// those of the equalizer's last picture.
class ModelTree : public TypeTree {
  Q_OBJECT
 public:
  enum Column { Eye, Swatch, Name, Bar, Count, kColumns };
  enum Role { VisibleRole = kOwnRole, ColorRole, HeldRole };  // HeldRole: a hand has set the row's number
  enum Shown { None, Some, All };  ///< how many of a row's types are shown: the value of VisibleRole

  ModelTree(const Equalizer& equalizer, QObject* parent);
  /// Shows the layer; emits nothing where the layer is the same as before.
  void showLayer(const scene::ModelLayer& layer);
  /// Shows the equalizer's counts.
  void showCounts();
  int shownCount() const { return mShownCount; }
  const BarScale& scale() const { return mScale; }
  void setPercent(bool percent);
  /// The counts of a row's instances; before there are counts the sum, total(), is 0.
  Counts countOf(const Row& row) const;
  /// How many of a row's instances are drawn, as the column Count says it: the whole number, or in percent, where
  /// neither a few are said to be none nor nearly all to be all.
  static QString drawnText(std::uint64_t drawn, std::uint64_t total, bool isPercent);
  /// The width of the widest text that the column Count can come to have for this model, pixels.
  int widestNumber(const QFontMetrics& metrics) const;
  /// The number that was typed into a row's field: "50", or "20 %" of `total`, in the language's digits; nothing where
  /// the text is no whole number and no share.
  static std::optional<double> readNumber(const QString& text, double total);

  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;

 private:
  Shown shownOf(const Row& row) const;
  QString tipOf(const Row& row, int column) const;
  QString describe(const MoleculeType& type) const;
  QString describe(const Counts& count) const;
  QString numberOf(const Row& row) const;
  QString heldText(const std::string& path) const;

  const Equalizer& mEqualizer;
  BarScale mScale;
  scene::ModelLayer mLayer;
  std::vector<bool> mVisible, mOwnColors;  ///< by type
  std::vector<QColor> mColors;
  int mShownCount = 0;
};

}  // namespace velum::gui
