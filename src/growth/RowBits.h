#pragma once
#include <bit>
#include <cstddef>
#include <cstdint>

/// Rows of voxels as bits, 64 a word: voxel x is bit x % 64 of word x / 64. Bits behind a row's end are 0.
namespace velum::growth {

using Word = std::uint64_t;
constexpr int kWordBits = 64;

/// Words of a row, from `first` to before `end`.
struct WordSpan {
  int first = 0, end = 0;
};

inline int wordsOf(int width) { return (width + kWordBits - 1) / kWordBits; }
inline bool bitAt(const Word* row, int x) { return row[x / kWordBits] >> (x % kWordBits) & 1; }
inline void setBit(Word* row, int x) { row[x / kWordBits] |= Word(1) << (x % kWordBits); }
inline void clearBit(Word* row, int x) { row[x / kWordBits] &= ~(Word(1) << (x % kWordBits)); }

/// The bits of word `w` that lie from `first` to before `end`.
inline Word spanBits(int w, int first, int end) {
  int low = first - w * kWordBits, high = end - w * kWordBits;
  if (high <= 0 || low >= kWordBits || low >= high) return 0;
  Word bits = low > 0 ? ~Word(0) << low : ~Word(0);
  return high < kWordBits ? bits & ~(~Word(0) << high) : bits;
}

/// How many bits of a word are set. Plain x86-64 has no instruction that counts bits, and the library's function is
/// slower than this one.
inline int countBits(Word w) {
  w -= w >> 1 & 0x5555555555555555u;
  w = (w & 0x3333333333333333u) + (w >> 2 & 0x3333333333333333u);
  return int(((w + (w >> 4)) & 0x0f0f0f0f0f0f0f0fu) * 0x0101010101010101u >> 56);
}

/// 64 bytes of 0 or 1 as the bits of a word: eight bytes at a time, by a product that moves each of them to its bit in
/// the highest byte.
inline Word packBytes(const std::uint8_t* bytes) {
  Word word = 0;
  for (int i = 0; i < 8; ++i) {
    Word eight = 0;
    for (int k = 0; k < 8; ++k) eight |= Word(bytes[8 * i + k]) << (8 * k);  // one load
    word |= (eight * 0x0102040810204080u >> 56) << (8 * i);
  }
  return word;
}

/// Fills runs of `open` upwards: from each bit of `from` to the end of the run that holds it. @param from  bits of open
/// @param carry  in: 1 when a filled run goes on from the word below; out: 1 when one goes on into the word above
inline Word fillUp(Word open, Word from, Word& carry) {
  // Added to its run, a bit turns all bits from its own to the run's end.
  Word sum = open + from, over = sum < open;
  sum += carry;
  carry = over | Word(sum < carry);
  return (open & (open ^ sum)) | from;
}

/// Fills runs of `open` downwards: from each bit of `from` to the start of the run that holds it.
inline Word fillDown(Word open, Word from) {
  if (((from >> 1) & open & ~from) == 0) return from;
  Word filled = from;
  filled |= open & (filled >> 1), open &= open >> 1;
  filled |= open & (filled >> 2), open &= open >> 2;
  filled |= open & (filled >> 4), open &= open >> 4;
  filled |= open & (filled >> 8), open &= open >> 8;
  filled |= open & (filled >> 16), open &= open >> 16;
  return filled | (open & (filled >> 32));
}

}  // namespace velum::growth
