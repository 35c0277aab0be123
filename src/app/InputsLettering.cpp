#include <fmt/format.h>

#include <utility>

#include "app/Inputs.h"
#include "session/command/DocumentCommands.h"
#include "session/command/LetteringCommands.h"
#include "session/command/MarkCommands.h"

namespace velum::app {

void addLettering(CLI::App& verb, LetteringOptions& lettering) {
  verb.add_flag("--legend", lettering.legend,
                "colours and names of a model's types and of structures over the picture (lettering.legend)");
  verb.add_flag("--scale-bar", lettering.scaleBar, "a bar that says how long things are (lettering.scaleBar)");
  verb.add_flag("--time-stamp", lettering.timeStamp, "the time of the time step (lettering.timeStamp)");
  verb.add_flag("--names", lettering.names,
                "names of the structures and types that are seen, beside the picture, with leaders (lettering.names)");
  verb.add_option("--style", lettering.style, "how lettering looks: screen, journal, atlas, blackboard, poster");
  verb.add_option("--page-width", lettering.pageWidth,
                  "width of the printed picture, mm: letters and lines have their points there (lettering.pageWidth)")
      ->check(CLI::Range(1.0, 5000.0));
  verb.add_option("--caption", lettering.captions,
                  "words over the picture, below; may be repeated (lettering.captions, whose fields say more)")
      ->allow_extra_args(false);
}

void writeOver(session::Session& session, const LetteringOptions& lettering) {
  for (auto [isOn, field] : {std::pair(lettering.legend, "lettering.legend"),
                             {lettering.scaleBar, "lettering.scaleBar"},
                             {lettering.timeStamp, "lettering.timeStamp"},
                             {lettering.names, "lettering.names"}})
    if (isOn) app::run(session, session::SetField{field, "true"});
  if (!lettering.style.empty())
    app::run(session, session::ChooseLetteringStyle{lettering.style}, {{"no style", "--style: no style"}});
  if (lettering.pageWidth > 0.0)
    app::run(session, session::SetField{"lettering.pageWidth", fmt::format("{}", lettering.pageWidth)});
  for (const std::string& text : lettering.captions) app::run(session, session::AddCaption{text});
}

}  // namespace velum::app
