#include "gui/window/LostWork.h"
#include "gui/kit/CoreWords.h"

#include <QMessageBox>
#include <QPushButton>
#include <exception>

namespace velum::gui {

LostWork::LostWork(const WindowParts& parts, RecoveryBar& bar, FileLoads& loads)
    : QObject(&parts.window), mParts(parts), mBar(bar), mLoads(loads) {
  connect(&bar, &RecoveryBar::restoreWanted, this, &LostWork::restoreAsked);
  connect(&bar, &RecoveryBar::discardWanted, this, &LostWork::askDiscard);
  connect(&loads, &FileLoads::lostWorkTaken, &bar, &RecoveryBar::next);
}

LostWork::~LostWork() = default;

void LostWork::lookFor(const std::filesystem::path& root) {
  auto found = std::make_shared<std::vector<session::LostWork>>();
  mScan = std::make_unique<Job>([found, root](Progress&) { *found = session::findLostWork(root); }, nullptr);
  connect(mScan.get(), &Job::finished, this, [this, found](bool, const QString& error) {
    mScan.release()->deleteLater();
    if (!error.isEmpty()) mParts.messages.showError(error);
    mBar.offer(std::move(*found));
  });
  mScan->start();
}

bool LostWork::restore() {
  while (mBar.current() && !mBar.current()->isReadable) mBar.next();
  const session::LostWork* work = mBar.current();
  if (!work) return false;
  mLoads.openLost(work->folder, QString::fromStdString(work->scenePath.empty() ? work->title : work->scenePath));
  return true;
}

void LostWork::askDiscard() {
  const session::LostWork* work = mBar.current();
  if (!work) return;
  QMessageBox box(QMessageBox::Warning, tr("Discard unsaved work"),
                  tr("Delete the unsaved work of %1 for good?")
                      .arg(QString::fromStdString(work->isReadable ? work->title : work->folder.string())),
                  QMessageBox::Discard | QMessageBox::Cancel, &mParts.window);
  box.button(QMessageBox::Discard)->setText(tr("&Delete"));
  box.setDefaultButton(QMessageBox::Cancel);
  if (box.exec() != QMessageBox::Discard) return;
  try {
    session::WorkClaim(work->folder).remove();
  } catch (const std::exception& error) {
    mParts.messages.showError(inWords(error.what()));
  }
  mBar.next();
}

}  // namespace velum::gui
