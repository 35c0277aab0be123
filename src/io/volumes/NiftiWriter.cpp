#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "io/read/ByteSink.h"
#include "io/read/FileNames.h"
#include "io/read/Losses.h"
#include "io/volumes/NiftiHeader.h"
#include "io/volumes/Writers.h"

namespace velum::io {

namespace {

constexpr std::size_t kPiece = 1 << 20;
constexpr int kIntentLabel = 1002, kIntentVector = 1007;

/// The bytes of a header, filled field by field. Machine byte order is legal and is what we write.
struct HeaderBytes {
  std::string bytes;
  template <class T>
  void put(std::size_t offset, T value) {
    std::memcpy(bytes.data() + offset, &value, sizeof(T));
  }
};

int dataTypeOf(const Volume& v) {
  if (v.isColor && v.type == SampleType::UInt8 && v.channels == 3) return 128;
  if (v.isColor && v.type == SampleType::UInt8 && v.channels == 4) return 2304;
  constexpr int kCodes[] = {2, 256, 512, 4, 768, 8, 16, 64};
  return kCodes[static_cast<int>(v.type)];
}

bool isPlanar(const Volume& v) { return v.channels > 1 && dataTypeOf(v) != 128 && dataTypeOf(v) != 2304; }

/// NIfTI's codes of length, and how many of its units a millimetre has. It knows no angstrom: micrometres are nearest.
struct LengthCode {
  int code;
  double perMm;
};

LengthCode lengthCodeOf(const Volume& v) {
  constexpr LengthCode kUnknown{0, 1}, kMillimetre{2, 1}, kMicrometre{3, 1e3};
  return v.lengthUnit == LengthUnit::Angstrom ? kMicrometre : v.isSpacingKnown ? kMillimetre : kUnknown;
}

/// In the file's unit of length.
glm::dmat4 rasFromVoxel(const Volume& v) {
  double scale = lengthCodeOf(v).perMm;
  return glm::dmat4(-scale, 0, 0, 0, 0, -scale, 0, 0, 0, 0, scale, 0, 0, 0, 0, 1) *
         worldFromVoxelIn(LengthUnit::Millimetre, v);
}

/// Quaternion (b, c, d) of a rotation, and the handedness that pixdim[0] holds.
struct Rotation {
  glm::dvec3 bcd{0.0};
  double handed = 1.0;
  bool isExact = false;  ///< The axes are at right angles, so that the quaternion says it all.
};

Rotation rotationOf(const glm::dmat4& ras) {
  glm::dmat3 m(glm::normalize(glm::dvec3(ras[0])), glm::normalize(glm::dvec3(ras[1])),
               glm::normalize(glm::dvec3(ras[2])));
  Rotation r;
  r.isExact = std::abs(glm::dot(m[0], m[1])) + std::abs(glm::dot(m[0], m[2])) + std::abs(glm::dot(m[1], m[2])) < 1e-5;
  if (glm::determinant(m) < 0) {
    r.handed = -1.0;
    m[2] = -m[2];
  }
  // m[c][r]; the largest of the four squares keeps the division safe.
  double a2 = 1 + m[0][0] + m[1][1] + m[2][2], b2 = 1 + m[0][0] - m[1][1] - m[2][2];
  double c2 = 1 - m[0][0] + m[1][1] - m[2][2], d2 = 1 - m[0][0] - m[1][1] + m[2][2];
  double a;
  if (a2 >= std::max({b2, c2, d2})) {
    a = 0.5 * std::sqrt(a2);
    r.bcd = glm::dvec3(m[1][2] - m[2][1], m[2][0] - m[0][2], m[0][1] - m[1][0]) / (4 * a);
  } else if (b2 >= std::max(c2, d2)) {
    double b = 0.5 * std::sqrt(b2);
    a = (m[1][2] - m[2][1]) / (4 * b);
    r.bcd = {b, (m[0][1] + m[1][0]) / (4 * b), (m[0][2] + m[2][0]) / (4 * b)};
  } else if (c2 >= d2) {
    double c = 0.5 * std::sqrt(c2);
    a = (m[2][0] - m[0][2]) / (4 * c);
    r.bcd = {(m[0][1] + m[1][0]) / (4 * c), c, (m[1][2] + m[2][1]) / (4 * c)};
  } else {
    double d = 0.5 * std::sqrt(d2);
    a = (m[0][1] - m[1][0]) / (4 * d);
    r.bcd = {(m[0][2] + m[2][0]) / (4 * d), (m[1][2] + m[2][1]) / (4 * d), d};
  }
  if (a < 0) r.bcd = -r.bcd;
  return r;
}

/// What both versions of the header hold.
struct Content {
  std::int64_t dim[8];
  double pixdim[8];
  int datatype, bits, intent, formCode, qformCode, units;
  std::int64_t dataOffset;
  double slope, intercept;
  glm::dmat4 ras;
  Rotation rotation;
  std::string description;
};

Content contentOf(const Volume& v, std::size_t extensionBytes, bool isVersion2, bool isLabels) {
  Content c{};
  bool planar = isPlanar(v);
  std::int64_t sizes[] = {
      planar ? 5 : v.timeSteps > 1 ? 4 : 3, v.dims.x, v.dims.y, v.dims.z, v.timeSteps, planar ? v.channels : 1, 1, 1};
  std::copy(std::begin(sizes), std::end(sizes), c.dim);
  c.ras = rasFromVoxel(v);
  c.rotation = rotationOf(c.ras);
  LengthCode length = lengthCodeOf(v);
  glm::dvec3 spacing = spacingOf(v) * (unitsPer(v.lengthUnit, LengthUnit::Millimetre) * length.perMm);
  double lengths[] = {c.rotation.handed, spacing.x, spacing.y, spacing.z, v.timeStepSeconds, 1, 1, 1};
  std::copy(std::begin(lengths), std::end(lengths), c.pixdim);
  c.datatype = dataTypeOf(v);
  c.bits = int(sampleSize(v.type)) * 8 * (planar ? 1 : v.channels);
  c.intent = isLabels ? kIntentLabel : planar ? kIntentVector : 0;
  // Code 1: scanner coordinates. Code 0, "nobody knows", would lose the matrix with it, so the description says that.
  c.formCode = v.isOrientationKnown ? 1 : 2;
  if (!v.isOrientationKnown) c.description = kOrientationUnknown;
  if (!v.isSpacingKnown) c.description += (c.description.empty() ? "" : "; ") + std::string(kSpacingUnknown);
  constexpr int kSeconds = 8;
  c.units = length.code | kSeconds;
  c.qformCode = c.rotation.isExact ? c.formCode : 0;
  c.dataOffset = std::int64_t((isVersion2 ? 544 : 352) + extensionBytes);
  c.slope = v.scale;
  c.intercept = v.offset;
  return c;
}

std::string headerVersion1(const Content& c) {
  HeaderBytes h{std::string(352, '\0')};
  h.put<std::int32_t>(0, 348);
  for (std::size_t i = 0; i < 8; ++i) {
    h.put(40 + 2 * i, std::int16_t(c.dim[i]));
    h.put(76 + 4 * i, float(c.pixdim[i]));
  }
  h.put(68, std::int16_t(c.intent));
  h.put(70, std::int16_t(c.datatype));
  h.put(72, std::int16_t(c.bits));
  h.put(108, float(c.dataOffset));
  h.put(112, float(c.slope));
  h.put(116, float(c.intercept));
  h.put(123, std::uint8_t(c.units));
  h.put(252, std::int16_t(c.qformCode));
  h.put(254, std::int16_t(c.formCode));
  for (std::size_t i = 0; i < 3; ++i) {
    h.put(256 + 4 * i, float(c.rotation.bcd[int(i)]));
    h.put(268 + 4 * i, float(c.ras[3][int(i)]));
    for (std::size_t k = 0; k < 4; ++k) h.put(280 + 16 * i + 4 * k, float(c.ras[int(k)][int(i)]));
  }
  c.description.copy(h.bytes.data() + 148, 79);
  std::memcpy(h.bytes.data() + 344, "n+1", 3);
  return h.bytes;
}

std::string headerVersion2(const Content& c) {
  HeaderBytes h{std::string(544, '\0')};
  h.put<std::int32_t>(0, 540);
  std::memcpy(h.bytes.data() + 4, "n+2\0\r\n\032\n", 8);
  h.put(12, std::int16_t(c.datatype));
  h.put(14, std::int16_t(c.bits));
  for (std::size_t i = 0; i < 8; ++i) {
    h.put(16 + 8 * i, c.dim[i]);
    h.put(104 + 8 * i, c.pixdim[i]);
  }
  h.put(168, c.dataOffset);
  h.put(176, c.slope);
  h.put(184, c.intercept);
  h.put(344, std::int32_t(c.qformCode));
  h.put(348, std::int32_t(c.formCode));
  for (std::size_t i = 0; i < 3; ++i) {
    h.put(352 + 8 * i, c.rotation.bcd[int(i)]);
    h.put(376 + 8 * i, c.ras[3][int(i)]);
    for (std::size_t k = 0; k < 4; ++k) h.put(400 + 32 * i + 8 * k, c.ras[int(k)][int(i)]);
  }
  c.description.copy(h.bytes.data() + 240, 79);
  h.put(500, std::int32_t(c.units));
  h.put(504, std::int32_t(c.intent));
  return h.bytes;
}

/// An extension block: size, code 0 (unknown), text, padded to 16 bytes.
std::string extensionBlock(const std::string& text) {
  if (text.empty()) return {};
  std::size_t size = (text.size() + 8 + 1 + 15) / 16 * 16;
  HeaderBytes block{std::string(size, '\0')};
  block.put(0, std::int32_t(size));
  std::memcpy(block.bytes.data() + 8, text.data(), text.size());
  return block.bytes;
}

void writePlanar(const Volume& v, ByteSink& sink, Progress& progress) {
  std::size_t sample = sampleSize(v.type), count = v.voxels.size() / sample / std::size_t(v.channels);
  std::vector<std::byte> piece;
  for (std::size_t c = 0; c < std::size_t(v.channels); ++c)
    for (std::size_t at = 0; at < count; at += kPiece) {
      std::size_t now = std::min(kPiece, count - at);
      piece.resize(now * sample);
      for (std::size_t i = 0; i < now; ++i)
        std::memcpy(piece.data() + i * sample, v.voxels.data() + ((at + i) * std::size_t(v.channels) + c) * sample,
                    sample);
      sink.write(piece);
      progress.report((double(c) + double(at) / double(count)) / v.channels, "Writing NIfTI");
    }
}

/// How far floats put a corner of the grid off, in voxels.
double misplacedBy(const Volume& v, const glm::dmat4& ras) {
  glm::dmat4 stored = glm::dmat4(glm::mat4(ras)), exact = glm::inverse(ras);
  double worst = 0;
  for (int corner = 0; corner < 8; ++corner) {
    glm::dvec4 voxel((corner & 1) * (v.dims.x - 1), (corner >> 1 & 1) * (v.dims.y - 1), (corner >> 2) * (v.dims.z - 1),
                     1);
    worst = std::max(worst, glm::length(glm::dvec3(exact * (stored * voxel) - voxel)));
  }
  return worst;
}

/// How far scale and offset as floats put a value off.
double misscaledBy(const Volume& v) {
  double most = std::max(std::abs(v.range.x - v.offset), std::abs(v.range.y - v.offset)) / std::abs(v.scale);
  return most * std::abs(double(float(v.scale)) - v.scale) + std::abs(double(float(v.offset)) - v.offset);
}

std::vector<std::string> lossesOf(const Volume& v, const Content& content, bool isVersion2, const Path& path) {
  constexpr double kSmallShare = 0.01;  // of a voxel: seen by nobody
  Losses losses;
  losses.say(isNameLost(v, path), "the name {} is left out: NIfTI has no place for it", inQuotes(v.name));
  losses.say(!v.unit.empty(), "the unit of values, {}, is left out: NIfTI has no place for it", inQuotes(v.unit));
  losses.say(v.modality != Modality::Unknown, "that it is {} is left out: NIfTI has no place for it",
             enumName(v.modality));
  losses.say(!v.channelNames.empty(), "the names of channels are left out: NIfTI has no place for them");
  losses.say(v.isColor && isPlanar(v), "colours are left as {} values of a voxel: NIfTI has colours of 8 bits only",
             v.channels);
  losses.say(v.lengthUnit == LengthUnit::Angstrom, "lengths are written in um: NIfTI knows no angstrom");
  double misplaced = isVersion2 ? 0 : misplacedBy(v, content.ras), misscaled = isVersion2 ? 0 : misscaledBy(v);
  losses.say(misplaced > kSmallShare, "places are kept as floats, which puts voxels off by {:.2g} of their size",
             misplaced);
  losses.say(misscaled > 0, "scale and offset are kept as floats, which changes values by up to {:.2g}", misscaled);
  return losses.take();
}

}  // namespace

std::vector<std::string> writeNiftiWith(const Volume& v, ReplaceFile& file, const LabelExtras& extras,
                                        Progress& progress) {
  const Path& path = file.target();
  std::string extension = lowerExtension(path);
  if (extension != ".nii" && extension != ".nii.gz") refuse(path, "NIfTI is written as .nii or .nii.gz");
  std::string block = extensionBlock(extras.niftiExtension);
  int largest = std::max({v.dims.x, v.dims.y, v.dims.z, v.timeSteps, v.channels});
  // Version 1 holds sizes in 16 bits, and the matrix and scale in floats; 2 only where the sizes need it, for few
  // programs read it.
  bool isVersion2 = largest > 32767;
  Content content = contentOf(v, block.size(), isVersion2, !extras.niftiExtension.empty());
  std::string header = isVersion2 ? headerVersion2(content) : headerVersion1(content);
  if (!block.empty()) header[header.size() - 4] = 1;  // extensions follow

  ByteSink sink(file);
  if (extension == ".nii.gz") sink.startGzip();
  sink.write(header);
  sink.write(block);
  if (isPlanar(v)) {
    writePlanar(v, sink, progress);
  } else {
    auto bytes = std::as_bytes(std::span(v.voxels));
    for (std::size_t at = 0; at < bytes.size(); at += kPiece) {
      sink.write(bytes.subspan(at, std::min(kPiece, bytes.size() - at)));
      progress.report(double(at) / double(bytes.size()), "Writing " + path.filename().string());
    }
  }
  sink.finish();
  return lossesOf(v, content, isVersion2, path);
}

std::vector<std::string> writeNifti(const Volume& volume, ReplaceFile& file, Progress& progress) {
  return writeNiftiWith(volume, file, {}, progress);
}

}  // namespace velum::io
