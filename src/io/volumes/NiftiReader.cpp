#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "io/read/ByteSource.h"
#include "io/read/FileBytes.h"
#include "io/read/FileNames.h"
#include "io/read/HeaderFields.h"
#include "io/read/Payload.h"
#include "io/read/Placement.h"
#include "io/volumes/NiftiHeader.h"
#include "io/volumes/Readers.h"

namespace velum::io {

namespace {

void parseVersion1(const HeaderFields& f, NiftiHeader& h) {
  for (std::size_t i = 0; i < 8; ++i) {
    h.dim[i] = f.at<std::int16_t>(40 + 2 * i);
    h.pixdim[i] = f.at<float>(76 + 4 * i);
  }
  h.intent = f.at<std::int16_t>(68);
  h.datatype = f.at<std::int16_t>(70);
  h.dataOffset = f.at<float>(108);
  h.slope = f.at<float>(112);
  h.intercept = f.at<float>(116);
  h.units = f.at<std::uint8_t>(123);
  if (!h.hasOrientation) return;
  h.qformCode = f.at<std::int16_t>(252);
  h.sformCode = f.at<std::int16_t>(254);
  for (std::size_t i = 0; i < 3; ++i) {
    h.quaternion[int(i)] = f.at<float>(256 + 4 * i);
    h.qoffset[int(i)] = f.at<float>(268 + 4 * i);
    for (std::size_t c = 0; c < 4; ++c) h.sform[c][i] = f.at<float>(280 + 16 * i + 4 * c);
  }
}

void parseVersion2(const HeaderFields& f, NiftiHeader& h) {
  for (std::size_t i = 0; i < 8; ++i) {
    h.dim[i] = f.at<std::int64_t>(16 + 8 * i);
    h.pixdim[i] = f.at<double>(104 + 8 * i);
  }
  h.datatype = f.at<std::int16_t>(12);
  h.dataOffset = double(f.at<std::int64_t>(168));
  h.slope = f.at<double>(176);
  h.intercept = f.at<double>(184);
  h.qformCode = f.at<std::int32_t>(344);
  h.sformCode = f.at<std::int32_t>(348);
  for (std::size_t i = 0; i < 3; ++i) {
    h.quaternion[int(i)] = f.at<double>(352 + 8 * i);
    h.qoffset[int(i)] = f.at<double>(376 + 8 * i);
    for (std::size_t c = 0; c < 4; ++c) h.sform[c][i] = f.at<double>(400 + 32 * i + 8 * c);
  }
  h.units = f.at<std::int32_t>(500);
  h.intent = f.at<std::int32_t>(504);
}

Path imageOf(const Path& header) {
  auto image = fileBeside(header, {".img", ".img.gz", ".IMG"});
  if (!image) refuse(header, "is one half of a pair, and its .img file is missing");
  return *image;
}

Path headerOf(const Path& file) {
  std::string extension = lowerExtension(file);
  if (extension != ".img" && extension != ".img.gz") return file;
  auto header = fileBeside(file, {".hdr"});
  if (!header) refuse(file, "is one half of a pair, and its .hdr file is missing");
  return *header;
}

struct NiftiType {
  int code;
  StoredType type;
  int channels;
};
constexpr NiftiType kTypes[] = {
    {2, StoredType::UInt8, 1},    {4, StoredType::Int16, 1},     {8, StoredType::Int32, 1},
    {16, StoredType::Float32, 1}, {64, StoredType::Float64, 1},  {128, StoredType::UInt8, 3},
    {256, StoredType::Int8, 1},   {512, StoredType::UInt16, 1},  {768, StoredType::UInt32, 1},
    {1024, StoredType::Int64, 1}, {1280, StoredType::UInt64, 1}, {2304, StoredType::UInt8, 4},
};

const NiftiType& typeOf(const NiftiHeader& h) {
  for (const NiftiType& type : kTypes)
    if (type.code == h.datatype) return type;
  bool known = h.datatype == 1 || h.datatype == 32 || h.datatype == 1536 || h.datatype == 1792 || h.datatype == 2048;
  refuse(h.file, fmt::format("voxels of NIfTI data type {} are not {}", h.datatype, known ? "supported" : "known"));
}

Layout layoutOf(const NiftiHeader& h) {
  if (h.dim[0] < 1 || h.dim[0] > 7) refuse(h.file, fmt::format("{} dimensions are not possible", h.dim[0]));
  auto size = [&](int axis) { return axis <= h.dim[0] ? h.dim[std::size_t(axis)] : 1; };
  const NiftiType& type = typeOf(h);
  Layout layout;
  layout.dims = {size(1), size(2), size(3)};
  layout.timeSteps = size(4);
  layout.channels = size(5) * type.channels;
  layout.channelOrder = size(5) > 1 ? ChannelOrder::Volumes : ChannelOrder::Together;
  layout.type = type.type;
  layout.bigEndian = h.bigEndian;
  if (size(6) != 1 || size(7) != 1) refuse(h.file, "has more than five dimensions, which is not supported");
  if (size(5) > 1 && type.channels > 1) refuse(h.file, "has colour vectors, which are not supported");
  if (size(5) < 1 || size(5) > 4096) refuse(h.file, fmt::format("{} samples per voxel are not possible", size(5)));
  return layout;
}

/// Method 2 of the NIfTI standard: rotation by quaternion, spacing from pixdim, handedness from pixdim[0].
glm::dmat3 qformColumns(const NiftiHeader& h) {
  double b = h.quaternion.x, c = h.quaternion.y, d = h.quaternion.z;
  double rest = 1.0 - (b * b + c * c + d * d);
  double a = rest > 0 ? std::sqrt(rest) : 0.0;
  if (rest < 1e-7) {  // a half turn, written with rounding: normalise
    double length = std::sqrt(b * b + c * c + d * d);
    a = 0.0;
    if (length > 0) b /= length, c /= length, d /= length;
  }
  glm::dmat3 m(a * a + b * b - c * c - d * d, 2 * (b * c + a * d), 2 * (b * d - a * c),   // first column
               2 * (b * c - a * d), a * a + c * c - b * b - d * d, 2 * (c * d + a * b),   //
               2 * (b * d + a * c), 2 * (c * d - a * b), a * a + d * d - c * c - b * b);  //
  double handed = h.pixdim[0] < 0 ? -1.0 : 1.0;
  return {m[0] * h.pixdim[1], m[1] * h.pixdim[2], m[2] * h.pixdim[3] * handed};
}

double mmPerUnit(const NiftiHeader& h) {
  switch (h.units & 7) {
    case 1:
      return 1e3;  // metre
    case 3:
      return 1e-3;  // micrometre
    default:
      return 1.0;
  }
}

double secondsPerUnit(const NiftiHeader& h) {
  switch (h.units & 56) {
    case 8:
      return 1.0;
    case 16:
      return 1e-3;
    case 24:
      return 1e-6;
    default:
      return 0.0;
  }
}

/// NIfTI's world is right-anterior-superior; ours is left-posterior-superior.
void place(Volume& v, const NiftiHeader& h) {
  const glm::dmat3 lpsFromRas(-1, 0, 0, 0, -1, 0, 0, 0, 1);
  double mm = mmPerUnit(h);
  glm::dvec3 spacing(std::abs(h.pixdim[1]), std::abs(h.pixdim[2]), std::abs(h.pixdim[3]));
  glm::dmat3 sform(h.sform[0], h.sform[1], h.sform[2]);
  v.isSpacingKnown = !h.saysNoSpacing;
  // The unit matrix is what programs write that know of no scanner.
  bool isUnit = h.sformCode > 0 && sform == glm::dmat3(1.0) && h.sform[3] == glm::dvec3(0.0);
  v.isOrientationKnown = (h.sformCode > 0 || h.qformCode > 0) && !h.saysUnknown && !isUnit;
  if (h.sformCode > 0 && isInvertible(sform))
    return placeInWorld(v, lpsFromRas * sform * mm, lpsFromRas * h.sform[3] * mm, spacing * mm);
  if (h.sformCode > 0) v.warnings.push_back("the file's sform matrix is singular and was left out");
  if (h.qformCode > 0 && isInvertible(qformColumns(h)))
    return placeInWorld(v, lpsFromRas * qformColumns(h) * mm, lpsFromRas * h.qoffset * mm, spacing * mm);
  // Without a form, voxel axes are taken as right, anterior, superior, as all readers do.
  v.isOrientationKnown = false;
  for (int i = 0; i < 3; ++i)
    if (!std::isfinite(spacing[i]) || spacing[i] <= 0) {
      spacing[i] = 1.0;
      v.isSpacingKnown = false;
    }
  v.warnings.push_back(kNoAxes);
  placeInWorld(v, lpsFromRas * glm::dmat3(spacing.x, 0, 0, 0, spacing.y, 0, 0, 0, spacing.z) * mm, glm::dvec3(0.0),
               spacing * mm);
}

}  // namespace

NiftiHeader readNiftiHeader(const Path& file) {
  NiftiHeader h;
  h.file = headerOf(file);
  std::string bytes = readHead(h.file, 540);
  if (sizeOfFile(h.file) == 0) refuse(h.file, "is empty");
  if (bytes.size() < 348) refuse(h.file, "is too short for a NIfTI header");
  HeaderFields f{bytes, false};
  auto claimed = f.at<std::int32_t>(0);
  f.swap = claimed == int(__builtin_bswap32(348)) || claimed == int(__builtin_bswap32(540));
  h.bigEndian = f.swap != (std::endian::native == std::endian::big);
  claimed = f.at<std::int32_t>(0);

  bool isVersion2 = claimed == 540 && bytes.size() >= 540;
  std::string_view magic(bytes.data() + (isVersion2 ? 4 : 344), 3);
  bool isSingle = magic == (isVersion2 ? "n+2" : "n+1");
  bool isPair = magic == (isVersion2 ? "ni2" : "ni1");
  h.hasOrientation = isSingle || isPair;
  bool isAnalyze = !h.hasOrientation && claimed == 348 && lowerExtension(h.file).starts_with(".hdr");
  if (claimed != 348 && !isVersion2) refuse(h.file, "is not a NIfTI file");
  if (!h.hasOrientation && !isAnalyze) refuse(h.file, fmt::format("has no NIfTI magic, but {}", inQuotes(magic)));
  isVersion2 ? parseVersion2(f, h) : parseVersion1(f, h);
  h.headerBytes = isVersion2 ? 540 : 348;
  std::string_view description = std::string_view(bytes).substr(isVersion2 ? 240 : 148, 80);
  h.saysUnknown = description.find(kOrientationUnknown) != std::string_view::npos;
  h.saysNoSpacing = description.find(kSpacingUnknown) != std::string_view::npos;
  h.image = isSingle ? h.file : imageOf(h.file);
  double lowest = isSingle ? double(h.headerBytes) : 0.0;
  if (isAnalyze && h.dataOffset < 0) h.dataOffset = 0;
  if (isSingle && h.dataOffset == 0) h.dataOffset = double(h.headerBytes + 4);
  if (!(h.dataOffset >= lowest && h.dataOffset < 1e15))
    refuse(h.file, fmt::format("the data cannot start at byte {}", h.dataOffset));
  return h;
}

std::vector<std::string> readNiftiExtensions(const NiftiHeader& h) {
  std::vector<std::string> texts;
  // Extensions stand between the header and the voxels of a single file, or at the end of a .hdr.
  std::uint64_t end = h.image == h.file ? std::uint64_t(h.dataOffset) : sizeOfFile(h.file);
  if (end <= h.headerBytes + 12 || end > (16u << 20)) return texts;
  std::string bytes = readHead(h.file, end);
  std::size_t at = h.headerBytes;
  if (bytes.size() < at + 12 || bytes[at] == 0) return texts;
  for (at += 4; at + 8 <= bytes.size();) {
    HeaderFields f{bytes, h.bigEndian != (std::endian::native == std::endian::big)};
    auto size = f.at<std::int32_t>(at);
    if (size < 16 || std::size_t(size) > bytes.size() - at) break;
    texts.push_back(bytes.substr(at + 8, std::size_t(size) - 8));
    at += std::size_t(size);
  }
  return texts;
}

UnreadVolume describeNifti(const scene::Source& source) {
  NiftiHeader h = readNiftiHeader(source.path);
  Payload part{h.image, 0, 0, Packing::Raw};
  bool isPacked = isGzip(h.image);
  part.packing = isPacked ? Packing::Deflate : Packing::Raw;
  (isPacked ? part.skip : part.offset) = std::uint64_t(h.dataOffset);
  UnreadVolume unread = promiseSamples(layoutOf(h), {part}, h.file);
  Volume& v = unread.head;
  v.isColor = typeOf(h).channels > 1;
  if (!v.isColor && std::isfinite(h.slope) && std::isfinite(h.intercept) && h.slope != 0.0) {
    v.scale = h.slope;
    v.offset = h.intercept;
  }
  if (v.timeSteps > 1 && std::isfinite(h.pixdim[4])) v.timeStepSeconds = std::abs(h.pixdim[4]) * secondsPerUnit(h);
  place(v, h);
  return unread;
}

Volume readNifti(const scene::Source& source, Progress& progress) {
  return readSamples(describeNifti(source), progress);
}

}  // namespace velum::io
