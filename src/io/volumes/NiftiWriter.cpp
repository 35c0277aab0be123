#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "NiftiHeader.h"
#include "Writers.h"
#include "read/ByteSink.h"
#include "read/FileNames.h"

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

glm::dmat4 rasFromVoxel(const Volume& v) {
  return glm::dmat4(-1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1) * worldFromVoxelIn(LengthUnit::Millimetre, v);
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
  int datatype, bits, intent, formCode, qformCode;
  std::int64_t dataOffset;
  double slope, intercept;
  glm::dmat4 ras;
  Rotation rotation;
  std::string_view description;
};

Content contentOf(const Volume& v, std::size_t extensionBytes, bool isVersion2, bool isLabels) {
  Content c{};
  bool planar = isPlanar(v);
  std::int64_t sizes[] = {
      planar ? 5 : v.timeSteps > 1 ? 4 : 3, v.dims.x, v.dims.y, v.dims.z, v.timeSteps, planar ? v.channels : 1, 1, 1};
  std::copy(std::begin(sizes), std::end(sizes), c.dim);
  c.ras = rasFromVoxel(v);
  c.rotation = rotationOf(c.ras);
  glm::dvec3 spacing = spacingOf(v) * unitsPer(v.lengthUnit, LengthUnit::Millimetre);
  double lengths[] = {c.rotation.handed, spacing.x, spacing.y, spacing.z, v.timeStepSeconds, 1, 1, 1};
  std::copy(std::begin(lengths), std::end(lengths), c.pixdim);
  c.datatype = dataTypeOf(v);
  c.bits = int(sampleSize(v.type)) * 8 * (planar ? 1 : v.channels);
  c.intent = isLabels ? kIntentLabel : planar ? kIntentVector : 0;
  // Code 1: scanner coordinates. Code 0, "nobody knows", would lose the matrix with it, so the description says that.
  c.formCode = v.isOrientationKnown ? 1 : 2;
  c.description = v.isOrientationKnown ? std::string_view() : kOrientationUnknown;
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
  h.put<std::uint8_t>(123, 2 | 8);  // mm, s
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
  h.put<std::int32_t>(500, 2 | 8);
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

}  // namespace

void writeNiftiWith(const Volume& v, ReplaceFile& file, const LabelExtras& extras, Progress& progress) {
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
}

void writeNifti(const Volume& volume, ReplaceFile& file, Progress& progress) {
  writeNiftiWith(volume, file, {}, progress);
}

}  // namespace velum::io
