#include "io/images/TextStandIn.h"

#include <cstddef>

namespace velum::io {

namespace {

/// Bytes of a text that may be kept. Crosses of more are found among all that is written.
constexpr std::size_t kShortText = 512;
/// Bytes that a library writes together with a text: a line in front of it, zeros behind it.
constexpr std::size_t kAroundText = 64;

}  // namespace

TextStandIn::TextStandIn(std::string_view text)
    : mText(text), mShown(text.size() > kShortText ? std::string(text.size(), 'x') : mText), mIsPut(mShown == mText) {}

std::string_view TextStandIn::put(std::string_view piece) {
  if (mShown == mText || piece.size() < mShown.size() || piece.size() > mShown.size() + kAroundText) return piece;
  std::size_t at = piece.find(mShown);
  if (at == piece.npos) return piece;
  mIsPut = true;
  mChanged = piece;
  return mChanged.replace(at, mText.size(), mText);
}

}  // namespace velum::io
