#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/Counts.h"
#include "session/bar/Dial.h"
#include "session/document/Document.h"

namespace velum::session {

/// A bar that shows how much of a thing is left, and the handle on it that a hand holds to set that ([VE] 7.2): of the
/// instances of a type, or of the pixels of a structure. What is seen while the handle is held is as much as what was
/// seen before lets expect. A hold is one step of the document.
class Bar {
 public:
  /// What a handle sets: how much is left, or how much of it is seen.
  enum class Handle { Left, Seen };

  /// What is taken hold of.
  struct Hold {
    std::string label;  ///< of the step
    Handle handle = Handle::Left;
    Counts start;             ///< what the bar shows
    std::uint64_t total = 0;  ///< of the thing
    /// The scene, cuts set and types shown, in which so much is left.
    std::function<Solved(double left)> solve;
  };
  /// What only pictures find: so much is to be seen, by the numbers of some cuts.
  struct Wish {
    std::string label;
    std::vector<int> cuts;
    std::uint64_t seen = 0;
  };

  /// @param document  outlives it
  explicit Bar(Document& document) : mDocument(document) {}

  void take(Hold hold);
  bool isHeld() const { return bool(mHeld); }
  /// @param count  of what the handle sets  @return what it has come to, in words
  std::string moveTo(double count);
  /// What it has come to; of the handle that is held, or was last.
  const Counts& now() const { return mNow; }
  /// It has been moved since it was taken.
  bool isMoved() const { return mHeld && mHeld->isMoved; }
  /// The step is done, but where what is seen has to be found: then it goes on, until Document::endMerge().
  std::optional<Wish> letGo();
  /// All is as it was before it was taken.
  void giveUp();

 private:
  struct Held {
    Hold hold;
    scene::Scene before;
    Wish wish;
    bool isMoved = false;
  };
  void put(const std::string& label, const scene::Scene& from);

  Document& mDocument;
  std::unique_ptr<Held> mHeld;
  Counts mNow;
};

}  // namespace velum::session
