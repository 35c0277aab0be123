#include <cstdlib>
#include <string_view>

#include "core/Error.h"
#include "scene/json/ChangeLog.h"
#include "scene/json/Json.h"

/// A text is a journal as far as it is sound: what is read of it is a scene that can be written and read again. The
/// check sums keep a fuzzer out, so each line is tried as a patch, too.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace velum;
  std::string_view text(reinterpret_cast<const char*>(data), size);
  auto found = scene::replay(text, text);
  if (found && !(scene::fromJson(scene::toJson(found->scene)) == found->scene)) std::abort();
  std::string journal;
  scene::SceneMirror mirror;
  scene::ChangeLine line{1, 0.0, "begin", "", "", mirror.follow(scene::Scene{})};
  journal += scene::encodeLine(line);
  for (std::string_view rest = text; !rest.empty();) {
    std::size_t end = rest.find('\n');
    line.patch = rest.substr(0, end);
    ++line.number;
    journal += scene::encodeLine(line);
    rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + 1);
  }
  // The first line is sound, so that there is always something.
  if (!scene::replay("", journal)) std::abort();
  return 0;
}
