#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "io/read/ByteSource.h"
#include "io/read/HeaderFields.h"
#include "io/read/Payload.h"
#include "io/read/Placement.h"
#include "io/volumes/Readers.h"

namespace velum::io {

namespace {

constexpr std::int32_t kImodStamp = 1146047817;

/// The machine stamp is often wrong; the axis order, 1 to 3 in any order, is not.
bool needsSwap(std::string_view bytes) {
  HeaderFields f{bytes, false};
  auto sane = [&](std::int32_t axis) { return axis >= 1 && axis <= 3; };
  if (sane(f.at<std::int32_t>(64))) return false;
  f.swap = true;
  if (sane(f.at<std::int32_t>(64))) return true;
  return static_cast<unsigned char>(bytes[212]) == 0x11;
}

Layout layoutOf(const HeaderFields& f, const Path& file) {
  Layout layout;
  layout.dims = {f.at<std::int32_t>(0), f.at<std::int32_t>(4), f.at<std::int32_t>(8)};
  layout.bigEndian = f.swap != (std::endian::native == std::endian::big);
  auto mode = f.at<std::int32_t>(12);
  // IMOD wrote unsigned bytes for mode 0 before the standard said signed, and flags when it does not.
  bool unsignedBytes = f.at<std::int32_t>(152) == kImodStamp && !(f.at<std::int32_t>(156) & 1);
  switch (mode) {
    case 0:
      layout.type = unsignedBytes ? StoredType::UInt8 : StoredType::Int8;
      break;
    case 1:
      layout.type = StoredType::Int16;
      break;
    case 2:
      layout.type = StoredType::Float32;
      break;
    case 6:
      layout.type = StoredType::UInt16;
      break;
    default:
      refuse(file, fmt::format("MRC mode {} is not supported; 0, 1, 2 and 6 are", mode));
  }
  return layout;
}

/// Cell lengths in angstrom over sampling give the spacing; mapc, mapr, maps say which cell axis each array axis is.
void place(Volume& v, const HeaderFields& f) {
  glm::dvec3 spacing(1.0), origin(0.0);
  bool known = true;
  for (int i = 0; i < 3; ++i) {
    double cell = f.at<float>(40 + 4 * std::size_t(i)), samples = f.at<std::int32_t>(28 + 4 * std::size_t(i));
    double angstrom = samples > 0 ? cell / samples : 0.0;
    known = known && std::isfinite(angstrom) && angstrom > 0;
    spacing[i] = angstrom;
    double start = f.at<float>(196 + 4 * std::size_t(i));
    if (std::isfinite(start)) origin[i] = start;
  }
  if (!known) {
    v.isSpacingKnown = false;
    spacing = glm::dvec3(1.0);
  }
  glm::dmat3 columns(0.0);
  for (int i = 0; i < 3; ++i) {
    int told = f.at<std::int32_t>(64 + 4 * std::size_t(i));  // 1..3, or nothing of use
    int axis = told >= 1 && told <= 3 ? told - 1 : i;
    columns[i][axis] = spacing[axis];
  }
  if (!isInvertible(columns)) columns = glm::dmat3(spacing.x, 0, 0, 0, spacing.y, 0, 0, 0, spacing.z);
  v.lengthUnit = LengthUnit::Angstrom;
  v.isOrientationKnown = false;
  placeInWorld(v, columns, origin, spacing);
}

}  // namespace

/// MRC and CCP4 maps, modes 0, 1, 2 and 6. The cell is in angstrom, and so is the world.
UnreadVolume describeMrc(const scene::Source& source) {
  Path file = source.path;
  std::string bytes = readHead(file, 1024);
  if (bytes.size() < 1024) refuse(file, "is too short for an MRC header");
  HeaderFields f{bytes, needsSwap(bytes)};
  auto extended = f.at<std::int32_t>(92);
  if (extended < 0) refuse(file, fmt::format("an extended header of {} bytes is not possible", extended));
  Payload part;
  part.file = file;
  bool isPacked = isGzip(file);
  part.packing = isPacked ? Packing::Deflate : Packing::Raw;
  (isPacked ? part.skip : part.offset) = 1024 + std::uint64_t(extended);
  UnreadVolume unread = promiseSamples(layoutOf(f, file), {part}, file);
  Volume& v = unread.head;
  v.modality = Modality::Microscopy;
  place(v, f);
  return unread;
}

Volume readMrc(const scene::Source& source, Progress& progress) { return readSamples(describeMrc(source), progress); }

}  // namespace velum::io
