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

/// What a journal may hold at most: so much a reader takes in, and no writer writes more.
inline constexpr std::size_t kMostJournalBytes = 128u << 20;
inline constexpr std::size_t kMostJournalLines = 200'000;

/// What is known of one change.
struct ChangeLine {
  std::int64_t number = 0;  ///< counts the lines of a session, from 1
  double seconds = 0;       ///< since the session began
  std::string label;        ///< what was done: "Move cut"
  std::string title;        ///< name of what is open
  std::string path;         ///< file of the scene; empty: not saved yet
  std::string patch;        ///< JSON: a list of add, replace and remove as in RFC 6902; of "" it is the whole scene
};

/// One line, with its end. It carries a check sum.
std::string encodeLine(const ChangeLine& line);
/// The counterpart; nothing for a line that is damaged or half written.
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

  /// Becomes that scene. @return the patch from what it was; empty when nothing has changed
  std::string follow(const Scene& scene);
  /// The patch that makes it out of nothing.
  std::string wholePatch() const;
  /// @throw InputError for a patch that is none, or does not fit; the mirror is of no use after it
  void apply(std::string_view patch);
  /// As toJson() writes it, in another order of the fields.
  std::string text() const;

 private:
  struct Data;
  std::unique_ptr<Data> mData;
};

/// What a journal comes to.
struct Replayed {
  Scene scene;          ///< after the last change that could be read; payloads are empty
  ChangeLine last;      ///< that change, without its patch
  bool isWhole = true;  ///< false: something at the end, or an autosave, could not be read
};

/// Reads as far as the text is sound: a line that is half written, damaged or does not fit ends it.
/// @param autosave  the scene's text where the journal began; needed only when the journal's own first line, which
///                  holds that scene too, cannot be read
/// @return nothing when no scene can be made of either
std::optional<Replayed> replay(std::string_view autosave, std::string_view journal);

}  // namespace velum::scene
