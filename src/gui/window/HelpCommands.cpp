#include "gui/window/HelpCommands.h"

#include <QMessageBox>

#include "gui/window/CommandFinder.h"
#include "gui/window/HelpWindow.h"

namespace velum::gui {

HelpCommands::HelpCommands(const WindowParts& parts) : Room(parts) {
  QMenu* menu = parts.menu(MenuId::Help);
  parts.actions.add(menu, "help.guide", tr("User &guide"), tr("Read the guide; no network is needed"),
                    [this] { showGuide(); });
  parts.actions.add(menu, "help.find", tr("&Find a command..."),
                    tr("Find a command, preset, structure or number by a few letters"), [this] {
                      auto runLine = [this](const QString& line) {
                        mParts.jobs.run(session::parseCall(line.toStdString()));
                      };
                      CommandFinder(findAll(mParts), &mParts.window, runLine).exec();
                    });
  menu->addSeparator();
  parts.actions.add(menu, "help.about", tr("&About Velum"), tr("Say what Velum is"), [this] { showAbout(); });
}

void HelpCommands::showGuide() {
  if (!mGuide) mGuide = new HelpWindow(&mParts.window);
  mGuide->show();
  mGuide->raise();
  mGuide->activateWindow();
}

void HelpCommands::showAbout() {
  QMessageBox::about(&mParts.window, tr("About Velum"),
                     tr("<h3>Velum %1</h3><p>Volumes, cut open the way illustrators do.</p>"
                        "<p><b>Not a medical device.</b> Do not use it for diagnosis or treatment.</p>")
                         .arg(VELUM_VERSION));
}

}  // namespace velum::gui
