#include <fmt/format.h>

#include "core/Error.h"
#include "core/Text.h"
#include "session/film/FilmKeys.h"
#include "session/film/ReadyFilms.h"

namespace velum::session {

void addTitle(scene::Scene& scene, FilmSpan span, const std::string& text, double fade, scene::CaptionPlace place) {
  if (trimmed(text).empty()) throw ArgumentError("a title needs words");
  FilmKeys keys(scene, span);
  scene::Caption caption;
  caption.text = text;
  caption.place = place;
  int id = scene::addCaption(scene.lettering.captions, std::move(caption));
  std::string path = fmt::format("lettering.captions[#{}].opacity", id);
  double end = span.start + span.seconds;
  fade = std::min(fade, 0.5 * span.seconds);
  scene::Ease ease = fade > 0.0 ? scene::Ease::Both : scene::Ease::Hold;
  if (span.start > 0.0 || fade > 0.0) keys.set(path, fade > 0.0 ? span.start : 0.0, "0", ease);
  keys.set(path, span.start + fade, "1", ease);
  if (fade > 0.0) keys.set(path, end - fade, "1", ease);
  keys.set(path, end, "0", ease);
}

}  // namespace velum::session
