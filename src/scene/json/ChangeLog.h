#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "scene/Scene.h"

/// The text form of a scene's changes, one JSON line each: what a journal is made of. No file is touched here.
namespace velum::scene {

/// The largest journal: readers take no more, and writers write no more.
inline constexpr std::size_t kMostJournalBytes = 128u << 20;
inline constexpr std::size_t kMostJournalLines = 200'000;

/// One change of a scene.
struct ChangeLine {
  std::int64_t number = 0;  ///< counts the lines of a session, from 1
  double seconds = 0;       ///< since the session began
  std::string label;        ///< what was done: "Move cut"
  std::string title;        ///< name of what is open
  std::string path;         ///< file of the scene; empty: not saved yet
  std::string patch;  ///< JSON: a list of add, replace and remove as in RFC 6902; the path "" means the whole scene
};

/// A change as one line of text with its line end. The line carries a checksum.
std::string encodeLine(const ChangeLine& line);
/// The change in a line; nothing for a line that is damaged or half written.
std::optional<ChangeLine> decodeLine(std::string_view line);

/// A scene's JSON that follows change by change. Begins as an empty object. One thread at a time.
class SceneMirror {
 public:
  SceneMirror();
  /// Begins with a scene's text. @throw InputError when it is no JSON object
  explicit SceneMirror(std::string_view sceneText);
  ~SceneMirror();
  SceneMirror(SceneMirror&&) noexcept;
  SceneMirror& operator=(SceneMirror&&) noexcept;

  /// Takes over the state of a scene. @return the patch from the mirror's state before; empty when nothing has changed
  std::string follow(const Scene& scene);
  /// The patch that makes the mirror's scene out of nothing.
  std::string wholePatch() const;
  /// @throw InputError for a patch that is damaged or does not fit; after that the mirror must not be used any more
  void apply(std::string_view patch);
  /// The scene's text as toJson() writes it, but with the fields in another order.
  std::string text() const;

 private:
  struct Data;
  std::unique_ptr<Data> mData;
};

/// The result of replaying a journal.
struct Replayed {
  Scene scene;          ///< after the last change that could be read; payloads are empty
  ChangeLine last;      ///< that change, without its patch
  bool isWhole = true;  ///< false: something at the end, or an autosave, could not be read
};

/// Replays a journal up to the first line that is half written, damaged or does not fit.
/// @param autosave  the scene's text where the journal began; needed only when the journal's own first line, which
/// holds
///                  that scene too, cannot be read
/// @return nothing when neither gives a scene
std::optional<Replayed> replay(std::string_view autosave, std::string_view journal);

}  // namespace velum::scene
