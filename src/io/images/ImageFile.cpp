#include "io/images/ImageFile.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <functional>

#include "core/Color.h"
#include "core/Error.h"
#include "core/ImageChannels.h"
#include "core/ReplaceFile.h"
#include "io/Plugins.h"
#include "io/images/ExrHeader.h"
#include "io/images/ImageFormat.h"
#include "io/images/PngChunks.h"
#include "io/images/TextStandIn.h"
#include "io/read/ByteSource.h"
#include "io/read/SinkStream.h"
#include "io/read/StderrQuiet.h"
#include "io/read/TiffPages.h"

namespace velum::io {

namespace {

using Path = std::filesystem::path;
constexpr const char* kDescriptionKey = "velum:scene";
/// TIFF has no named texts, so ours stands in ImageDescription behind this line.
constexpr int kMaxSide = 65535;

void check(const Image& image, const Path& path) {
  bool sane = image.width > 0 && image.height > 0 && image.width <= kMaxSide && image.height <= kMaxSide &&
              !image.channels.empty();
  std::size_t samples =
      std::size_t(std::max(0, image.width)) * std::size_t(std::max(0, image.height)) * image.channels.size();
  if (!sane || image.pixels.size() != samples)
    throw InputError(fmt::format("{}: cannot write a picture of {} x {} pixels with {} channels and {} samples",
                                 path.string(), image.width, image.height, image.channels.size(), image.pixels.size()));
}

/// What an 8-bit format can hold: R, G, B and A where there, else a single channel as grey.
Image displayChannels(const Image& image, const Path& path) {
  if (image.channels.size() == 1) return image;
  std::vector<std::string> names;
  for (const char* name : {"R", "G", "B", "A"})
    if (channelIndex(image, name) >= 0) names.push_back(name);
  if (names.size() < 3 || names[2] != "B")
    throw InputError(fmt::format("{}: the picture has no channels R, G and B; write it as .exr", path.string()));
  return channelsOf(image, names);
}

/// All samples by wholeSample().
template <class T>
std::vector<std::byte> quantized(const std::vector<float>& pixels) {
  std::vector<std::byte> out(pixels.size() * sizeof(T));
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    T whole = wholeSample<T>(pixels[i]);
    std::memcpy(&out[i * sizeof(T)], &whole, sizeof(T));
  }
  return out;
}

OIIO::TypeDesc sampleType(bool isFloat, int bits) {
  return isFloat ? OIIO::TypeDesc::FLOAT : bits == 16 ? OIIO::TypeDesc::UINT16 : OIIO::TypeDesc::UINT8;
}

/// Turns display-referred straight colour into OpenEXR's linear premultiplied one, or back: of the picture, and of each
/// of its layers that has colour ("inlay.R" ...).
void convertColor(Image& image, bool toLinear) {
  for (const ColorChannels& of : colorsOf(image))
    for (std::size_t at = 0; at < image.pixels.size(); at += image.channels.size()) {
      float a = of.alpha < 0 ? 1.0f : image.pixels[at + std::size_t(of.alpha)];
      for (std::size_t c : of.color) {
        float& v = image.pixels[at + c];
        if (toLinear)
          v = linearFromSrgb(v) * a;
        else
          v = srgbFromLinear(a > 0.0f ? v / a : v);
      }
    }
}

/// Everything in the file follows from the picture: no clock, no program version.
OIIO::ImageSpec specFor(const Image& image, const std::string& format, OIIO::TypeDesc type,
                        const std::string& description, double dpi) {
  OIIO::ImageSpec spec(image.width, image.height, int(image.channels.size()), type);
  spec.channelnames = image.channels;
  spec.alpha_channel = int(channelIndex(image, "A"));
  spec.z_channel = int(channelIndex(image, "Z"));
  spec.attribute("oiio:UnassociatedAlpha", 1);
  // Without this the writers of TIFF and OpenEXR put the clock there; PNG leaves an absent date out.
  if (format != "png") spec.attribute("DateTime", "");
  if (format == "png") spec.attribute("oiio:ColorSpace", "sRGB");
  if (format == "openexr") spec.attribute("compression", "zip");
  if (dpi > 0) {
    spec.attribute("XResolution", float(dpi));
    spec.attribute("YResolution", float(dpi));
    spec.attribute("ResolutionUnit", "in");
  }
  if (description.empty() || format == "png") return spec;
  if (format == "tiff")
    spec.attribute("ImageDescription", std::string(kTiffScenePrefix) + description);
  else
    spec.attribute(kDescriptionKey, description);
  return spec;
}

/// What the library writes goes to our file, which remembers what the disk refused: the library's close may not.
class SinkProxy : public OIIO::Filesystem::IOProxy {
 public:
  /// @param text  stands in for a text that is to be in the file
  SinkProxy(ReplaceFile& file, TextStandIn& text)
      : IOProxy(file.target().string(), Write), mStream(file), mText(text) {}

  const char* proxytype() const override { return "velum"; }
  size_t write(const void* bytes, size_t count) override {
    size_t written = pwrite(bytes, count, m_pos);
    m_pos += std::int64_t(written);
    return written;
  }
  size_t pwrite(const void* bytes, size_t count, std::int64_t offset) override {
    std::string_view piece = mText.put({static_cast<const char*>(bytes), count});
    mStream.seekp(offset);
    mStream.write(piece.data(), std::streamsize(count));
    mSize = std::max(mSize, offset + std::int64_t(count));
    return mStream.good() ? count : 0;
  }
  size_t size() const override { return size_t(mSize); }

 private:
  SinkStream mStream;
  TextStandIn& mText;
  std::int64_t mSize = 0;
};

void encode(OIIO::ImageOutput& out, const std::string& name, const OIIO::ImageSpec& spec, const void* pixels,
            const std::function<void()>& throwIfRefused) {
  bool done = out.open(name, spec) && out.write_image(spec.format, pixels);
  done = out.close() && done;
  // The library says in many lines what the disk says in one.
  throwIfRefused();
  if (!done) throw InputError(fmt::format("{}: cannot be written ({})", name, out.geterror()));
}

/// A PNG file in memory. The library does not get the description, see TextStandIn.
std::vector<unsigned char> pngOf(OIIO::ImageOutput& out, const std::string& name, const OIIO::ImageSpec& spec,
                                 const void* pixels, const std::string& description) {
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput memory(bytes);
  out.set_ioproxy(&memory);
  encode(out, name, spec, pixels, [] {});
  if (!description.empty()) addPngText(bytes, kDescriptionKey, description);
  return bytes;
}

void writePng(const std::vector<unsigned char>& png, const Path& path) {
  if (path == "-") {
    if (std::fwrite(png.data(), 1, png.size(), stdout) != png.size() || std::fflush(stdout) != 0)
      throw InputError("-: the picture cannot be written to the standard output");
    return;
  }
  ReplaceFile file(path);
  SinkStream(file).write(reinterpret_cast<const char*>(png.data()), std::streamsize(png.size()));
  file.throwIfRefused();
  file.commit();
}

/// OpenImageIO's name of the format that a file is in. Told nothing, the library offers the bytes to readers of thirty
/// formats that nobody asked for. @throw InputError when it is none of ours
std::string formatInside(const Path& path) {
  if (!std::filesystem::is_regular_file(path))
    throw InputError(fmt::format("{}: there is no such picture", path.string()));
  std::string head = readHead(path, 4);
  if (head == "\x89PNG") {
    if (!isSoundPng(FileBytes(path))) throw InputError(fmt::format("{}: is cut short or damaged", path.string()));
    return "png";
  }
  if (head == "\x76\x2f\x31\x01") {
    if (!isSoundExr(FileBytes(path))) throw InputError(fmt::format("{}: its header is damaged", path.string()));
    return "openexr";
  }
  if (head.starts_with("II") || head.starts_with("MM")) return "tiff";
  throw InputError(fmt::format("{}: is no picture in PNG, TIFF or OpenEXR; convert it to one of these", path.string()));
}

std::unique_ptr<OIIO::ImageInput> openPicture(const Path& path) {
  auto in = OIIO::ImageInput::create(formatInside(path));
  OIIO::ImageSpec config, found;
  config.attribute("oiio:UnassociatedAlpha", 1);
  if (!in || !in->open(path.string(), found, config))
    throw InputError(
        fmt::format("{}: cannot be read as a picture ({})", path.string(), in ? in->geterror() : OIIO::geterror()));
  const auto& spec = in->spec();
  if (spec.width < 1 || spec.height < 1 || spec.width > kMaxSide || spec.height > kMaxSide || spec.nchannels < 1 ||
      spec.nchannels > 1024)
    throw InputError(fmt::format("{}: a picture of {} x {} x {} is not read", path.string(), spec.width, spec.height,
                                 spec.nchannels));
  // Deflate makes at most 1032 bytes of one, so a larger claim is not true.
  if (double(spec.image_bytes()) > 1100.0 * double(std::filesystem::file_size(path)) + 1e6)
    throw InputError(fmt::format("{}: the header promises more pixels than the file can hold", path.string()));
  return in;
}

/// The library reads a TIFF that was cut short without a word.
void refuseTruncatedTiff(const Path& path) {
  std::ifstream file(path, std::ios::binary);
  auto pages = scanTiff(file, path.string(), 1);
  if (!pages.pages[0].isDataInside) throw InputError(fmt::format("{}: the picture is cut short", path.string()));
}

}  // namespace

void plugin::writeImage(const Image& image, const Path& path, const std::string& description, double dpi,
                        const std::vector<ImageAttribute>& attributes, int bits) {
  check(image, path);
  std::string format = imageFormatOf(path);
  auto out = OIIO::ImageOutput::create(format);
  if (!out) throw InputError(fmt::format("{}: this OpenImageIO cannot write {}", path.string(), format));

  // Choose what the format holds: TIFF has whole numbers until there is more than colour in the picture.
  Image shown = format == "openexr" ? image : format == "png" ? displayChannels(image, path) : image;
  bool isColorOnly = std::all_of(shown.channels.begin(), shown.channels.end(), [&](const std::string& name) {
    return shown.channels.size() == 1 || name == "R" || name == "G" || name == "B" || name == "A";
  });
  bool isFloat = format == "openexr" || (format == "tiff" && !isColorOnly);
  if (format == "tiff" && !isFloat) shown = displayChannels(image, path);
  if (format == "openexr") convertColor(shown, true);
  auto whole = isFloat      ? std::vector<std::byte>{}
               : bits == 16 ? quantized<std::uint16_t>(shown.pixels)
                            : quantized<std::uint8_t>(shown.pixels);
  const void* pixels = isFloat ? static_cast<const void*>(shown.pixels.data()) : whole.data();
  TextStandIn text(description);
  auto spec = specFor(shown, format, sampleType(isFloat, bits), text.shown(), dpi);

  if (format == "openexr")
    for (const ImageAttribute& attribute : attributes) spec.attribute(attribute.name, attribute.value);

  if (format == "png") return writePng(pngOf(*out, path.string(), spec, pixels, description), path);
  ReplaceFile file(path);
  {
    SinkProxy proxy(file, text);
    out->set_ioproxy(&proxy);
    encode(*out, path.string(), spec, pixels, [&] { file.throwIfRefused(); });
    if (!text.isPut()) throw InputError(fmt::format("{}: this OpenImageIO keeps the scene out of it", path.string()));
  }
  file.commit();
}

Image plugin::readImage(const Path& path) {
  StderrQuiet quiet;
  auto in = openPicture(path);
  const auto& spec = in->spec();
  if (std::string_view(in->format_name()) == "tiff") refuseTruncatedTiff(path);
  Image image{spec.width, spec.height, spec.channelnames, {}};
  image.pixels.resize(std::size_t(spec.width) * std::size_t(spec.height) * std::size_t(spec.nchannels));
  auto read = [&](OIIO::TypeDesc type, void* to) {
    if (!in->read_image(0, 0, 0, spec.nchannels, type, to))
      throw InputError(fmt::format("{}: the picture is damaged ({})", path.string(), in->geterror()));
  };
  if (spec.format == OIIO::TypeDesc::UINT8) {
    // Divided here and not by the library, which multiplies by 1/255 and so misses the value that was written by a
    // hair.
    std::vector<std::uint8_t> bytes(image.pixels.size());
    read(OIIO::TypeDesc::UINT8, bytes.data());
    std::transform(bytes.begin(), bytes.end(), image.pixels.begin(), [](std::uint8_t v) { return float(v) / 255.0f; });
  } else {
    read(OIIO::TypeDesc::FLOAT, image.pixels.data());
  }
  if (std::string_view(in->format_name()) == "openexr") convertColor(image, false);
  return image;
}

std::string plugin::readImageDescription(const Path& path) {
  StderrQuiet quiet;
  auto in = openPicture(path);
  if (std::string_view(in->format_name()) != "tiff")
    return std::string(in->spec().get_string_attribute(kDescriptionKey));
  std::ifstream file(path, std::ios::binary);
  std::string text = scanTiff(file, path.string(), 1).description;
  return text.starts_with(kTiffScenePrefix) ? text.substr(kTiffScenePrefix.size()) : std::string{};
}

}  // namespace velum::io
