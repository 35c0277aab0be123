#include "io/labels/DicomSegWriter.h"

#include <fmt/format.h>
#include <gdcmUIDGenerator.h>
#include <gdcmWriter.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <sstream>

#include "core/SayCount.h"
#include "io/Plugins.h"
#include "io/labels/DicomCodes.h"
#include "io/labels/DicomColor.h"
#include "io/labels/DicomElements.h"
#include "io/labels/LabelTables.h"
#include "io/read/Losses.h"
#include "io/read/Refuse.h"

namespace velum::io {

namespace {

using gdcm::DataSet;
using gdcm::Tag;
using gdcm::VR;

constexpr std::size_t kLongestLabel = 64;  ///< Of a segment, characters.
const char* const kSegmentationClass = "1.2.840.10008.5.1.4.1.1.66.4";

/// Of the one length that most have, so that the same labels take as many bytes each time.
std::string newUid() {
  constexpr std::size_t kLength = 64;
  std::string uid;
  do uid = gdcm::UIDGenerator().Generate();
  while (uid.size() != kLength);
  return uid;
}

/// Without what parts values of a text, and no longer than fits: whole characters of UTF-8.
std::string labelText(const std::string& name) {
  std::string text;
  std::size_t characters = 0;
  for (char c : name) {
    bool isStart = (static_cast<unsigned char>(c) & 0xc0) != 0x80;
    if (isStart && ++characters > kLongestLabel) break;
    text += c == '\\' ? '/' : static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  }
  return text;
}

DataSet codeItem(const DicomCode& code) {
  DataSet item;
  putText(item, Tag(0x0008, 0x0100), VR::SH, std::string(code.value));
  putText(item, Tag(0x0008, 0x0102), VR::SH, "SCT");
  putText(item, Tag(0x0008, 0x0104), VR::LO, std::string(code.meaning));
  return item;
}

DataSet segmentItem(const LabelInfo& label, int number) {
  DataSet item;
  SegmentCodes codes = segmentCodesOf(label.name);
  DicomLab lab = dicomLabFromSrgb(label.color);
  putItem(item, Tag(0x0062, 0x0003), codeItem(codes.category));
  putWord(item, Tag(0x0062, 0x0004), number);
  putText(item, Tag(0x0062, 0x0005), VR::LO, labelText(label.name));
  putText(item, Tag(0x0062, 0x0008), VR::CS, "SEMIAUTOMATIC");
  putText(item, Tag(0x0062, 0x0009), VR::LO, "Velum");
  putNumbers(item, Tag(0x0062, 0x000d), VR::US, {lab[0], lab[1], lab[2]});
  putItem(item, Tag(0x0062, 0x000f), codeItem(codes.type));
  putText(item, Tag(0x0062, 0x0020), VR::UT, trackingIdOf(label.id));
  putText(item, Tag(0x0062, 0x0021), VR::UI, newUid());
  return item;
}

/// What every DICOM object says of itself, the patient, who is nobody, and the study.
void putModules(DataSet& set, const std::string& name) {
  std::time_t now = std::time(nullptr);
  std::tm utc{};
  ::gmtime_r(&now, &utc);
  char date[9], time[7];
  std::strftime(date, sizeof date, "%Y%m%d", &utc);
  std::strftime(time, sizeof time, "%H%M%S", &utc);
  putText(set, Tag(0x0008, 0x0005), VR::CS, "ISO_IR 192");
  putText(set, Tag(0x0008, 0x0008), VR::CS, "DERIVED\\PRIMARY");
  putText(set, Tag(0x0008, 0x0016), VR::UI, kSegmentationClass);
  putText(set, Tag(0x0008, 0x0018), VR::UI, newUid());
  putText(set, Tag(0x0008, 0x0023), VR::DA, date);
  putText(set, Tag(0x0008, 0x0033), VR::TM, time);
  putText(set, Tag(0x0008, 0x0060), VR::CS, "SEG");
  putText(set, Tag(0x0008, 0x0070), VR::LO, "Velum");
  putText(set, Tag(0x0008, 0x103e), VR::LO, labelText(name));
  putText(set, Tag(0x0008, 0x1090), VR::LO, "Velum");
  putText(set, Tag(0x0018, 0x1000), VR::LO, "0");
  putText(set, Tag(0x0018, 0x1020), VR::LO, "0.1");
  for (auto [tag, vr] : {std::pair(Tag(0x0008, 0x0020), VR(VR::DA)),
                         {Tag(0x0008, 0x0030), VR(VR::TM)},
                         {Tag(0x0008, 0x0050), VR(VR::SH)},
                         {Tag(0x0008, 0x0090), VR(VR::PN)},
                         {Tag(0x0010, 0x0010), VR(VR::PN)},
                         {Tag(0x0010, 0x0020), VR(VR::LO)},
                         {Tag(0x0010, 0x0030), VR(VR::DA)},
                         {Tag(0x0010, 0x0040), VR(VR::CS)},
                         {Tag(0x0020, 0x0010), VR(VR::SH)},
                         {Tag(0x0020, 0x1040), VR(VR::LO)},
                         {Tag(0x0070, 0x0081), VR(VR::LO)},
                         {Tag(0x0070, 0x0084), VR(VR::PN)}})
    putText(set, tag, vr, "");
  for (Tag tag : {Tag(0x0020, 0x000d), Tag(0x0020, 0x000e), Tag(0x0020, 0x0052)}) putText(set, tag, VR::UI, newUid());
  putText(set, Tag(0x0020, 0x0011), VR::IS, "1");
  putText(set, Tag(0x0020, 0x0013), VR::IS, "1");
}

void putPixelModule(DataSet& set, glm::ivec3 dims, std::size_t frames) {
  putText(set, Tag(0x0028, 0x0004), VR::CS, "MONOCHROME2");
  putText(set, Tag(0x0028, 0x0008), VR::IS, fmt::format("{}", frames));
  putWord(set, Tag(0x0028, 0x0002), 1);
  putWord(set, Tag(0x0028, 0x0010), dims.y);
  putWord(set, Tag(0x0028, 0x0011), dims.x);
  putWord(set, Tag(0x0028, 0x0100), 1);
  putWord(set, Tag(0x0028, 0x0101), 1);
  putWord(set, Tag(0x0028, 0x0102), 0);
  putWord(set, Tag(0x0028, 0x0103), 0);
  putText(set, Tag(0x0028, 0x2110), VR::CS, "00");
  putText(set, Tag(0x0062, 0x0001), VR::CS, "BINARY");
  putText(set, Tag(0x0070, 0x0080), VR::CS, "VELUM");
}

/// Frames are told apart by their plane, then by their segment.
void putDimensions(DataSet& set) {
  std::string uid = newUid();
  DataSet organization;
  putText(organization, Tag(0x0020, 0x9164), VR::UI, uid);
  putItem(set, Tag(0x0020, 0x9221), organization);
  Sequence indices;
  struct Row {
    Tag group, value;
    const char* name;
  };
  for (const Row& row : {Row{Tag(0x0020, 0x9113), Tag(0x0020, 0x0032), "Image Position Patient"},
                         Row{Tag(0x0062, 0x000a), Tag(0x0062, 0x000b), "Referenced Segment Number"}}) {
    DataSet item;
    putText(item, Tag(0x0020, 0x9164), VR::UI, uid);
    putNumbers(item, Tag(0x0020, 0x9165), VR::AT, {row.value.GetGroup(), row.value.GetElement()});
    putNumbers(item, Tag(0x0020, 0x9167), VR::AT, {row.group.GetGroup(), row.group.GetElement()});
    putText(item, Tag(0x0020, 0x9421), VR::LO, row.name);
    indices.add(item);
  }
  indices.putInto(set, Tag(0x0020, 0x9222));
}

void putSharedGroups(DataSet& set, const glm::dmat3& axes) {
  glm::dvec3 spacing(glm::length(axes[0]), glm::length(axes[1]), glm::length(axes[2]));
  DataSet measures, orientation, shared;
  putText(measures, Tag(0x0018, 0x0050), VR::DS, decimal(spacing.z));
  putText(measures, Tag(0x0018, 0x0088), VR::DS, decimal(spacing.z));
  putText(measures, Tag(0x0028, 0x0030), VR::DS, decimal(spacing.y) + "\\" + decimal(spacing.x));
  putText(orientation, Tag(0x0020, 0x0037), VR::DS,
          decimals(axes[0] / spacing.x) + "\\" + decimals(axes[1] / spacing.y));
  putItem(shared, Tag(0x0020, 0x9116), orientation);
  putItem(shared, Tag(0x0028, 0x9110), measures);
  putItem(set, Tag(0x5200, 0x9229), shared);
}

DataSet frameItem(const glm::dvec3& position, int plane, int segment) {
  DataSet content, place, number, frame;
  putNumbers(content, Tag(0x0020, 0x9157), VR::UL, {std::uint32_t(plane + 1), std::uint32_t(segment)});
  putText(place, Tag(0x0020, 0x0032), VR::DS, decimals(position));
  putWord(number, Tag(0x0062, 0x000b), segment);
  putItem(frame, Tag(0x0020, 0x9111), content);
  putItem(frame, Tag(0x0020, 0x9113), place);
  putItem(frame, Tag(0x0062, 0x000a), number);
  return frame;
}

/// Voxels of a bit each, over all frames without gaps, lowest bit first.
class Bits {
 public:
  void add(bool bit) {
    if (mCount % 8 == 0) mBytes.push_back(0);
    if (bit) mBytes.back() = char(mBytes.back() | 1 << (mCount % 8));
    ++mCount;
  }
  std::size_t byteCount() const { return mBytes.size(); }
  std::vector<char> take() {
    if (mBytes.size() % 2) mBytes.push_back(0);
    return std::move(mBytes);
  }

 private:
  std::vector<char> mBytes;
  std::size_t mCount = 0;
};

/// The frames as they come, plane by plane.
struct Frames {
  Sequence groups;
  Bits bits;
  std::size_t count = 0;
};

/// @param segmentOf  by id; 0: none
Frames collectFrames(const LabelVolume& labels, const std::vector<std::uint16_t>& segmentOf, const Path& path,
                     Progress& progress) {
  Frames frames;
  glm::ivec3 dims = labels.dims();
  std::vector<std::uint16_t> plane(std::size_t(dims.x) * std::size_t(dims.y)), found;
  for (int z = 0; z < dims.z; ++z) {
    labels.read({0, 0, z}, {dims.x, dims.y, 1}, plane);
    found = {1};  // the first segment has every plane
    for (std::uint16_t& id : plane) {
      id = segmentOf[id];
      if (id != 0 && id != found.back()) found.push_back(id);
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    glm::dvec3 position(labels.worldFromVoxel() * glm::dvec4(0, 0, z, 1));
    for (std::uint16_t segment : found) {
      frames.groups.add(frameItem(position, z, segment));
      for (std::uint16_t id : plane) frames.bits.add(id == segment);
      ++frames.count;
    }
    if (frames.bits.byteCount() > std::numeric_limits<std::uint32_t>::max() - 2)
      refuse(path, "the segments do not fit into one DICOM file; write fewer structures");
    progress.report(0.8 * double(z + 1) / dims.z, "Writing segments");
  }
  return frames;
}

void checkGrid(const LabelVolume& labels, const Path& path) {
  if (labels.lengthUnit() != LengthUnit::Millimetre) refuse(path, "DICOM holds lengths of patients, in millimetres");
  glm::dmat3 m(labels.worldFromVoxel());
  constexpr double kSkew = 1e-4;  // seen by nobody: a tenth of a voxel in a thousand
  for (int i = 0; i < 3; ++i)
    if (std::abs(glm::dot(glm::normalize(m[i]), glm::normalize(m[(i + 1) % 3]))) > kSkew)
      refuse(path, "the axes of the labels are not at right angles, as those of DICOM are; write .seg.nrrd or .nii.gz");
  if (labels.dims().x > 65535 || labels.dims().y > 65535) refuse(path, "DICOM has no planes that large");
}

}  // namespace

std::vector<std::string> plugin::writeDicomSeg(const LabelVolume& labels, ReplaceFile& file, Progress& progress) {
  const Path& path = file.target();
  checkGrid(labels, path);
  // Number the structures that have voxels.
  auto used = labels.idsInUse();
  std::vector<std::uint16_t> segmentOf(65536, 0);
  std::uint16_t count = 0;
  std::size_t cut = 0, transparent = 0;
  Sequence segments;
  for (const LabelInfo& label : completeTable(labels.table, used)) {
    if (!std::binary_search(used.begin(), used.end(), label.id)) continue;
    segmentOf[label.id] = ++count;
    segments.add(segmentItem(label, count));
    cut += labelText(label.name) != label.name;
    transparent += label.opacity != 1.0f;
  }
  if (count == 0) refuse(path, "nothing is labelled, and DICOM has no segmentation of nothing");
  Frames frames = collectFrames(labels, segmentOf, path, progress);

  gdcm::Writer writer;
  DataSet& set = writer.GetFile().GetDataSet();
  putModules(set, labels.name);
  putPixelModule(set, labels.dims(), frames.count);
  putDimensions(set);
  putSharedGroups(set, glm::dmat3(labels.worldFromVoxel()));
  segments.putInto(set, Tag(0x0062, 0x0002));
  frames.groups.putInto(set, Tag(0x5200, 0x9230));
  std::vector<char> bits = frames.bits.take();
  put(set, Tag(0x7fe0, 0x0010), VR::OB, bits.data(), bits.size());
  writer.GetFile().GetHeader().SetDataSetTransferSyntax(gdcm::TransferSyntax::ExplicitVRLittleEndian);
  progress.report(0.9, "Writing " + path.filename().string());
  // Into memory: GDCM asserts that its stream takes all, which a full disk does not.
  std::ostringstream stream;
  writer.SetStream(stream);
  if (!writer.Write()) refuse(path, "the DICOM segmentation cannot be written");
  file.write(stream.view());
  Losses losses;
  losses.say(cut > 0, "{}",
             sayCount(cut, "{} name of a structure is changed: DICOM has {} characters for it, and no backslash",
                      "{} names of structures are changed: DICOM has {} characters for them, and no backslash",
                      kLongestLabel));
  losses.say(transparent > 0, "opacities are left out: DICOM has no place for them");
  return losses.take();
}

}  // namespace velum::io
