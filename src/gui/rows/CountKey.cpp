#include "gui/rows/CountKey.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>

#include "gui/kit/Text.h"
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

CountKey::CountKey(const QString& tip, QWidget* parent) : QWidget(parent) {
  setObjectName("countKey");
  setToolTip(tip);
  setAccessibleName(tr("Colours of the bars: %1").arg(countTitle()));
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(2, 0, 2, 0);
  row->setSpacing(5);
  for (std::size_t i = 0; i < kCountKinds.size(); ++i) {
    auto* word = new QLabel(toText(kCountKinds[i].adjective), this);
    word->setProperty("role", "muted");
    if (i > 0) row->addSpacing(9);
    row->addWidget(new KeyPatch(countColor(CountOf(i)), this));
    row->addWidget(word);
  }
  row->addStretch(1);
}

}  // namespace velum::gui
