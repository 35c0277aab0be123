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

/// A bar that shows how many instances of a type, or pixels of a structure, are left, and the handle on the bar with
/// which a hand sets that number ([VE] 7.2). While the handle is held the bar shows an estimate of how many are seen:
/// as large a share of those left as before the hold (expectedCounts()). One hold is one undo step of the document.
class Bar {
 public:
  /// Which number a handle sets: how many are left by cuts, or how many of those are seen.
  enum class Handle { Left, Seen };

  /// The thing (a type or a structure) whose handle a hand takes hold of.
  struct Hold {
    std::string label;  ///< name of the undo step
    Handle handle = Handle::Left;
    Counts start;             ///< what the bar shows when the handle is taken
    std::uint64_t total = 0;  ///< instances or pixels of the thing
    /// Gives the scene in which `left` are left, by its cuts, the looks of its types and the numbers that are held.
    std::function<Solved(double left)> solve;
  };
  /// A number of instances or pixels that are to be seen: only drawn pictures can tell which numbers of the cuts lead
  /// there.
  struct Wish {
    std::string label;
    std::vector<int> cuts;
    std::uint64_t seen = 0;
  };

  /// @param document  must outlive the bar
  explicit Bar(Document& document) : mDocument(document) {}

  void take(Hold hold);
  bool isHeld() const { return bool(mHeld); }
  /// Moves the handle. @param count  how many are to be left, or seen, as the handle says  @return what was reached, in
  /// words; empty when no handle is held
  std::string moveTo(double count);
  /// What the bar shows for the hold that goes on, or for the last one.
  const Counts& now() const { return mNow; }
  /// True when the handle has been moved since it was taken.
  bool isMoved() const { return mHeld && mHeld->isMoved; }
  /// Ends the hold and its undo step. After a moved Handle::Seen it returns the wish instead, which pictures must still
  /// meet; the undo step then stays open until Document::endMerge().
  std::optional<Wish> letGo();
  /// Ends the hold and puts cuts, looks and numbers of types back as they were before the handle was taken.
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
