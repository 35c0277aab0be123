#include "vector/Description.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <fstream>

#include "core/Error.h"
#include "vector/Png.h"

namespace velum::vector {

namespace {

constexpr std::string_view kSvgBegin = "<velum:scene", kSvgEnd = "</velum:scene";
constexpr std::size_t kPiece = 1u << 20, kAround = 4096;  // bytes; the second of a PDF's dictionary
constexpr std::size_t kLongestBase64 = kLongestDescription / 3 * 4 + kLongestDescription / 50;  // with ends of lines

/// A part of a file that moves on to its end.
class Window {
 public:
  explicit Window(const std::filesystem::path& path) : mPath(path), mFile(path, std::ios::binary) {
    if (!mFile) refuse("the file cannot be read");
  }
  [[noreturn]] void refuse(std::string_view why) const { throw InputError(fmt::format("{}: {}", mPath.string(), why)); }
  /// Adds the next piece. @return false at the end of the file
  bool extend() {
    std::size_t before = mText.size();
    mText.resize(before + kPiece);
    mFile.read(mText.data() + before, std::streamsize(kPiece));
    mText.resize(before + std::size_t(mFile.gcount()));
    return mText.size() > before;
  }
  /// Moves to the first place of a word; a little of what is before it stays. @return its place in text()
  std::size_t find(std::string_view word) {
    for (std::size_t from = 0;;) {
      if (std::size_t at = mText.find(word, from); at != std::string::npos) return at;
      if (mText.size() > kAround) mText.erase(0, mText.size() - kAround);
      from = mText.size() - std::min(mText.size(), word.size());
      if (!extend()) return std::string::npos;
    }
  }
  /// The first place of a word from one on, which is no farther than so many bytes. @throw InputError without one
  std::size_t expect(std::string_view word, std::size_t from, std::size_t most) {
    for (std::size_t at = from; at < from + most;) {
      if (std::size_t found = mText.find(word, at); found < from + most) return found;
      at = std::max(from, mText.size() - std::min(mText.size(), word.size()));
      if (!extend()) refuse("the scene inside it is damaged: it ends early");
    }
    refuse("the scene inside it is damaged, or too long");
  }
  const std::string& text() const { return mText; }

 private:
  std::filesystem::path mPath;
  std::ifstream mFile;
  std::string mText;
};

/// Bytes of text (RFC 4648), whatever white space is in it. @return false for any other text
bool decodeBase64(std::string_view text, std::string& bytes) {
  std::uint32_t bits = 0;
  int count = 0;
  for (char c : text) {
    int digit = c >= 'A' && c <= 'Z'   ? c - 'A'
                : c >= 'a' && c <= 'z' ? c - 'a' + 26
                : c >= '0' && c <= '9' ? c - '0' + 52
                : c == '+'             ? 62
                : c == '/'             ? 63
                                       : -1;
    if (c == '=' || c == ' ' || c == '\n' || c == '\r' || c == '\t') continue;
    if (digit < 0) return false;
    bits = bits << 6 | std::uint32_t(digit);
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes += char(bits >> count & 255u);
  }
  return true;
}

std::string readSvg(Window& file) {
  std::size_t begin = file.find(kSvgBegin);
  if (begin == std::string::npos) return {};
  std::size_t from = file.expect(">", begin, kAround) + 1;
  std::size_t end = file.expect(kSvgEnd, from, kLongestBase64);
  std::string bytes;
  if (!decodeBase64(std::string_view(file.text()).substr(from, end - from), bytes))
    file.refuse("the scene inside it is damaged");
  if (bytes.size() > kLongestDescription) file.refuse("the scene inside it is too long");
  return bytes;
}

/// Unpacks what lies in a file from a place on. @throw InputError
std::string unpacked(Window& file, std::size_t from) {
  struct Stream : z_stream {
    Stream() : z_stream{} { inflateInit(this); }
    ~Stream() { inflateEnd(this); }
  } stream;
  std::string bytes;
  std::array<char, 1u << 16> piece;
  for (int answer = Z_OK; answer != Z_STREAM_END;) {
    if (from == file.text().size() && !file.extend()) file.refuse("the scene inside it is damaged: it ends early");
    // Text that grows lies elsewhere.
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(file.text().data() + from));
    stream.avail_in = uInt(std::min(file.text().size() - from, kPiece));
    const uInt given = stream.avail_in;
    stream.next_out = reinterpret_cast<Bytef*>(piece.data());
    stream.avail_out = uInt(piece.size());
    answer = inflate(&stream, Z_NO_FLUSH);
    if (answer != Z_OK && answer != Z_STREAM_END) file.refuse("the scene inside it is damaged");
    from += given - stream.avail_in;
    if (from > kLongestDescription) file.refuse("the scene inside it is too long");
    bytes.append(piece.data(), piece.size() - stream.avail_out);
    if (bytes.size() > kLongestDescription) file.refuse("the scene inside it is too long");
  }
  return bytes;
}

std::string readPdf(Window& file) {
  std::size_t name = file.find(kPdfDescription);
  if (name == std::string::npos) return {};
  std::size_t from = file.expect("stream", name, kAround) + std::string_view("stream").size();
  file.expect("\n", from, 2);
  std::size_t object = file.text().rfind("obj", name);
  std::string_view dictionary = std::string_view(file.text()).substr(object == std::string::npos ? 0 : object);
  bool isPacked = dictionary.substr(0, dictionary.find("stream")).find("/FlateDecode") != std::string_view::npos;
  from = file.text().find('\n', from) + 1;
  if (isPacked) return unpacked(file, from);
  // No line of JSON begins so.
  std::size_t end = file.expect("\nendstream", from, kLongestDescription);
  return file.text().substr(from, end - from);
}

}  // namespace

void expectDescription(std::string_view text) {
  if (text.size() > kLongestDescription)
    throw InputError(fmt::format("{} MiB of scene are too much for a drawing", text.size() >> 20));
}

std::string svgDescription(std::string_view text) {
  std::string lines, whole = base64Of(std::string(text));
  for (std::size_t at = 0; at < whole.size(); at += 120) lines += whole.substr(at, 120) + '\n';
  return fmt::format("{} xmlns:velum=\"urn:velum\" type=\"application/json\" encoding=\"base64\">\n{}{}>", kSvgBegin,
                     lines, kSvgEnd);
}

std::string readDescription(const std::filesystem::path& path) {
  Window file(path);
  file.extend();
  return file.text().starts_with("%PDF-") ? readPdf(file) : readSvg(file);
}

}  // namespace velum::vector
