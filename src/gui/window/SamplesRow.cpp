#include "gui/window/SamplesRow.h"

#include <QHBoxLayout>
#include <QSignalBlocker>
#include <algorithm>

namespace velum::gui {

namespace {

constexpr int kSamplesOfWords[] = {1, 4, 16, 64};

}  // namespace

SamplesRow::SamplesRow(const QString& name, QWidget* parent)
    : QWidget(parent), mWords(new QComboBox(this)), mNumber(new QSpinBox(this)) {
  mWords->setObjectName(name + "Quality");
  mWords->setAccessibleName(tr("Quality"));
  mWords->addItems({tr("Draft (1 sample)"), tr("Good (4 samples)"), tr("Fine (16 samples)"), tr("Finest (64 samples)"),
                    tr("Samples:")});
  mWords->setToolTip(tr("Pictures that are averaged: more are smoother and take longer"));
  mNumber->setObjectName(name + "Samples");
  mNumber->setAccessibleName(tr("Samples a pixel"));
  mNumber->setRange(1, 256);
  mNumber->setToolTip(tr("Samples a pixel, 1 to 256"));
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(8);
  row->addWidget(mWords, 1);
  row->addWidget(mNumber);
  connect(mWords, &QComboBox::currentIndexChanged, this, [this](int index) {
    if (index < int(std::size(kSamplesOfWords))) mNumber->setValue(kSamplesOfWords[index]);
  });
  connect(mNumber, &QSpinBox::valueChanged, this, [this] {
    showWords();
    emit changed();
  });
  showWords();
}

void SamplesRow::showWords() {
  const QSignalBlocker quiet(mWords);
  mWords->setCurrentIndex(int(std::ranges::find(kSamplesOfWords, samples()) - std::begin(kSamplesOfWords)));
}

}  // namespace velum::gui
