#pragma once
#include <string>
#include <string_view>

namespace velum::io {

/// Stands for a text while a library writes it. OpenImageIO keeps every text that it is given for as long as the
/// program runs, which are ten thousand scenes in a long film: of a long text it gets as many crosses, whose lengths
/// are few, and what it writes gets the text in their place. The file is the same to the byte.
class TextStandIn {
 public:
  explicit TextStandIn(std::string_view text);
  /// What the library gets: crosses, or a short text itself.
  const std::string& shown() const { return mShown; }
  /// A piece of the file as it is to be written. @param piece  what the library writes at once; it writes a text at
  /// once
  /// @return valid until the next call
  std::string_view put(std::string_view piece);
  /// The text is in the file.
  bool isPut() const { return mIsPut; }

 private:
  std::string mText, mShown, mChanged;
  bool mIsPut;
};

}  // namespace velum::io
