#include "gui/look/ChannelList.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QVBoxLayout>
#include <algorithm>
#include <string>

#include "gui/service/EditField.h"
#include "session/command/Command.h"
#include "session/command/LookCommands.h"

namespace velum::gui {

void ChannelEye::mouseReleaseEvent(QMouseEvent* event) {
  setDown(false);
  if (event->button() == Qt::LeftButton && rect().contains(event->position().toPoint()))
    emit pressedWith(event->modifiers() & Qt::AltModifier);
}

/// The window has another use for Space.
bool ChannelEye::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Space)
    event->accept();
  return QToolButton::event(event);
}

void ChannelEye::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Space || event->key() == Qt::Key_Return)
    emit pressedWith(event->modifiers() & Qt::AltModifier);
  else
    QToolButton::keyPressEvent(event);
}

ChannelList::ChannelList(session::Document& document, QWidget* parent) : QWidget(parent), mDocument(document) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(3);
  layout->addWidget(makeTitle(tr("Channels"), this));
}

void ChannelList::addRow() {
  int channel = int(mRows.size());
  Row row{new QWidget(this), nullptr, nullptr, nullptr};
  auto* line = new QHBoxLayout(row.widget);
  line->setContentsMargins(0, 0, 0, 0);
  line->setSpacing(6);
  row.eye = new ChannelEye(row.widget);
  row.eye->setObjectName(QString("channelEye%1").arg(channel));
  row.eye->setToolTip(tr("Show or hide this channel; Alt+click: show it alone, or all again"));
  row.color = new ColorButton(tr("Colour of the channel"), row.widget);
  row.color->setFixedSize(28, 22);
  row.name = new QPushButton(row.widget);
  row.name->setObjectName(QString("channelName%1").arg(channel));
  row.name->setProperty("role", "row");
  row.name->setCheckable(true);
  row.name->setToolTip(tr("Edit the colour and opacity of this channel"));
  line->addWidget(row.eye);
  line->addWidget(row.color);
  line->addWidget(row.name, 1);
  layout()->addWidget(row.widget);
  connect(row.eye, &ChannelEye::pressedWith, this, [this, channel](bool alone) { show(channel, alone); });
  connect(row.color, &ColorButton::picked, this, [this, channel](glm::vec3 color) { recolor(channel, color); });
  connect(row.name, &QPushButton::clicked, this, [this, channel] { choose(channel); });
  mRows.push_back(row);
}

void ChannelList::show(int channel, bool alone) {
  const auto& looks = mDocument.shown().volume.channels;
  if (std::size_t(channel) >= looks.size()) return;
  if (alone) return session::edit(mDocument, session::ShowChannelAlone{channel});
  bool visible = !looks[std::size_t(channel)].visible;
  setField(mDocument, "volume.channels." + std::to_string(channel) + ".visible", visible ? "true" : "false",
           "Show or hide channel");
}

void ChannelList::recolor(int channel, glm::vec3 color) {
  if (std::size_t(channel) < mDocument.shown().volume.channels.size())
    session::edit(mDocument, session::ColorChannel{channel, color});
}

void ChannelList::choose(int channel) {
  setField(mDocument, "volume.channel", std::to_string(channel), "Choose channel");
  refresh();  // the chosen one stays pressed
}

void ChannelList::refresh() {
  const scene::VolumeLayer& layer = mDocument.shown().volume;
  bool mixes = scene::mixesChannels(layer);
  setVisible(mixes);
  if (!mixes) return;
  bool grows = mRows.size() < layer.channels.size();
  while (mRows.size() < layer.channels.size()) addRow();
  if (grows) tabInLayoutOrder(parentWidget());  // before what stands below
  for (std::size_t i = 0; i < mRows.size(); ++i) {
    const Row& row = mRows[i];
    row.widget->setVisible(i < layer.channels.size());
    if (i >= layer.channels.size()) continue;
    const scene::ChannelLook& look = layer.channels[i];
    QString name = QString::fromStdString(look.name);
    row.eye->setChecked(look.visible);
    row.eye->setAccessibleName(tr("Show %1").arg(name));
    row.color->setColor(look.color);
    row.color->setAccessibleName(tr("Colour of %1").arg(name));
    row.name->setText(row.name->fontMetrics().elidedText(name, Qt::ElideRight, 220));
    row.name->setChecked(int(i) == std::clamp(layer.channel, 0, int(layer.channels.size()) - 1));
  }
}

}  // namespace velum::gui
