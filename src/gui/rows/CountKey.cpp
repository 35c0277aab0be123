#include "gui/rows/CountKey.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>

#include "gui/kit/Text.h"
#include "gui/kit/Words.h"
#include "gui/rows/CountBar.h"

namespace velum::gui {

namespace {

constexpr QSize kPatchSize(14, 9);  // as high as a bar

class KeyPatch : public QWidget {
 public:
  KeyPatch(const QColor& color, QWidget* parent) : QWidget(parent), mColor(color) { setFixedSize(kPatchSize); }

 protected:
  void paintEvent(QPaintEvent*) override { QPainter(this).fillRect(rect(), mColor); }

 private:
  QColor mColor;
};

}  // namespace

CountKey::CountKey(Of of, QWidget* parent) : QWidget(parent) {
  setObjectName("countKey");
  setToolTip(
      of == Of::Instances
          ? tr("Of the instances of a row: those that the picture shows; those that are drawn, but hidden behind "
               "others or outside the picture; those that cuts remove or that are not shown")
          : tr("Of the pixels that a structure would take: those that show it, those where others are before it, "
               "those where cuts remove it"));
  setAccessibleName(tr("Colours of the bars: %1").arg(countTitle()));
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(2, 0, 2, 0);
  row->setSpacing(5);
  for (std::size_t i = 0; i < kCountKinds.size(); ++i) {
    auto* word = new QLabel(wordsOf(kCountKinds[i].adjective), this);
    word->setProperty("role", "muted");
    if (i > 0) row->addSpacing(9);
    row->addWidget(new KeyPatch(countColor(CountOf(i)), this));
    row->addWidget(word);
  }
  row->addStretch(1);
}

}  // namespace velum::gui
