// How much of what it protects the membrane keeps whole, by kinds of data, ways to protect, sizes and directions.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <optional>
#include <sstream>

#include "Data.h"
#include "Frames.h"
#include "Sections.h"
#include "io/labels/ReadLabels.h"
#include "io/phantoms/Sample.h"
#include "io/volumes/ReadVolume.h"
#include "session/membrane/DefaultField.h"
#include "session/membrane/MembraneEdit.h"
#include "session/membrane/Membranes.h"

namespace velum::bench {

namespace {

/// Fewer pairs than this make no ratio.
constexpr std::int64_t kLeastPairs = 30;

/// What is done to data before a sheet meets it.
enum class Form { AsItIs, Resampled, Slab };
constexpr int kLongEdge = 512, kSlabSlices = 20;

/// One kind of data, and the values that are protected by hand or clicked on. Labels have none.
struct Member {
  const char* family;
  const char* source;  ///< a phantom, or a file of VELUM_TEST_DATA/volumes
  double low, high;
  Form form = Form::AsItIs;
  int phantomSize = -1;  ///< voxels along the longest edge, 0 for its own; -1 for a file
};
constexpr Member kMembers[] = {
    {"noisy fibres", "fibres", 1250, 65536, Form::AsItIs, 0},
    {"vessels at 512", "vessels", 700, 2000, Form::AsItIs, kLongEdge},
    {"trunk at 512", "torso", 250, 1000, Form::AsItIs, kLongEdge},
    {"thin slabs", "vessels", 700, 2000, Form::Slab, 160},
    {"thin slabs", "ct_heart_aorta_cta.nii.gz", 200, 4000, Form::Slab},
    {"thin slabs", "ct_abdomen_3mm.nii.gz", 200, 4000, Form::Slab},
    {"over 300 voxels", "ct_thorax_lidc0314_dicom.zip", 200, 4000},
    {"over 300 voxels", "frogtissue.mhd", 0, 0},
    {"over 300 voxels", "ct_mouse_head_35um_labels.seg.nrrd", 0, 0},
    {"axons", "micro_axons_120.tif", 2500, 65536},
    {"resampled to 512", "xa_aneurism.vti", 60, 256, Form::Resampled},
    {"resampled to 512", "ct_heart_aorta_cta.nii.gz", 200, 4000, Form::Resampled},
    {"resampled to 512", "ct_head_avm_angio.nii.gz", 100, 1000, Form::Resampled},
    {"resampled to 512", "ct_iguana_head.nii.gz", 110, 256, Form::Resampled},
};

/// A folder in place of an archive, unpacked; it is in the way of nobody and left behind.
std::filesystem::path unpacked(const std::filesystem::path& archive) {
  auto folder = std::filesystem::temp_directory_path() / ("velum-bench-" + archive.stem().string());
  if (!std::filesystem::exists(folder)) {
    std::string command = fmt::format("python3 -m zipfile -e '{}' '{}'", archive.string(), folder.string());
    if (std::system(command.c_str()) != 0) throw InputError(archive.string() + " cannot be unpacked");
  }
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) return entry.path();
  throw InputError(archive.string() + " holds nothing");
}

/// The middle slices along z.
Volume slabOf(Volume volume) {
  int first = std::max(0, (volume.dims.z - kSlabSlices) / 2);
  std::size_t slice = timeStepBytes(volume) / std::size_t(volume.dims.z);
  volume.dims.z = std::min(kSlabSlices, volume.dims.z);
  Bytes voxels(slice * std::size_t(volume.dims.z));
  std::copy_n(volume.voxels.begin() + std::ptrdiff_t(slice) * first, voxels.size(), voxels.begin());
  volume.voxels = std::move(voxels);
  volume.worldFromVoxel[3] += volume.worldFromVoxel[2] * double(first);
  return volume;
}

Volume resampled(const Volume& volume) {
  int longest = std::max(volume.dims.x, std::max(volume.dims.y, volume.dims.z));
  return resample(volume, glm::max(glm::ivec3(1), volume.dims * kLongEdge / longest));
}

bool isLabels(const Member& member) { return member.high <= member.low; }

scene::Scene sceneOf(const Member& member) {
  Progress progress;
  scene::Scene scene;
  if (member.phantomSize >= 0) {
    Volume volume = io::makeSample(member.source, member.phantomSize, progress).volume;
    scene.volume.data = Shared<Volume>(member.form == Form::Slab ? slabOf(std::move(volume)) : std::move(volume));
    return scene;
  }
  auto path = std::filesystem::path(std::getenv("VELUM_TEST_DATA")) / "volumes" / member.source;
  scene::Source source;
  source.path = (path.extension() == ".zip" ? unpacked(path) : path).string();
  if (isLabels(member)) {
    scene.labels.data = Shared<LabelVolume>(io::readLabels(source, progress));
    return scene;
  }
  Volume volume = io::readVolume(source, progress);
  if (member.form == Form::Slab) volume = slabOf(std::move(volume));
  if (member.form == Form::Resampled) volume = resampled(volume);
  scene.volume.data = Shared<Volume>(std::move(volume));
  return scene;
}

/// The structure nearest to the middle of a label map.
int middleStructure(const LabelVolume& labels) {
  glm::ivec3 middle = labels.dims() / 2;
  for (int radius = 0; radius < middle.x; ++radius)
    for (glm::ivec3 step : {glm::ivec3(radius, 0, 0), glm::ivec3(0, radius, 0), glm::ivec3(0, 0, radius)})
      for (glm::ivec3 at : {middle + step, middle - step})
        if (labels.at(at)) return labels.at(at);
  return 1;
}

enum class Way { Click, Value, Default };
constexpr const char* kWays[] = {"click", "value", "default"};

/// Protects as a user would. @return false where there is nothing to do it with
bool protect(const Member& member, const scene::Scene& scene, Way way, scene::Membrane& membrane) {
  if (way == Way::Default) {
    membrane.field = session::defaultField(scene);
    return true;
  }
  if (isLabels(member)) {
    if (way == Way::Click)
      session::protectStructure(membrane, middleStructure(*scene.labels.data));
    else
      for (int id : scene.labels.data->idsInUse()) session::protectStructure(membrane, id);
    return true;
  }
  if (way == Way::Value) {
    session::protectValues(membrane, member.low, member.high);
    return true;
  }
  auto click = clickPlace(*scene.volume.data, member.low, member.high);
  return click && session::protectTissue(membrane, scene.volume, *click).has_value();
}

struct Plane {
  std::string family, data, way;
  std::size_t direction = 0;
  int place = 0;
  glm::ivec3 voxels{0};
  std::int64_t pairs = 0;  ///< that the flat plane cuts; fewer than kLeastPairs: the rest is not measured
  double ratio = 0, limit = 0;
};

glm::ivec3 voxelsOf(const scene::Scene& scene) {
  return scene.volume.data ? scene.volume.data->dims : scene.labels.data->dims();
}

/// The goal with its slack: at most 1 where it is met.
double inMedian(const Plane& p) { return p.ratio / (1.25 * p.limit + 0.02); }
double inNineOfTen(const Plane& p) { return p.ratio / (1.6 * p.limit + 0.05); }

double quantileOf(const std::vector<Plane>& planes, double (*figure)(const Plane&), double share) {
  std::vector<double> values;
  for (const auto& plane : planes) values.push_back(figure(plane));
  std::sort(values.begin(), values.end());
  return values.empty() ? 0.0 : values[std::size_t(std::ceil(share * double(values.size() - 1)))];
}

/// Along the axes and two directions that no axis of the data runs along.
std::vector<glm::dvec3> directionsOf(const scene::Scene& scene) {
  glm::dmat4 worldFromVoxel =
      scene.volume.data ? scene.volume.data->worldFromVoxel : scene.labels.data->worldFromVoxel();
  std::vector<glm::dvec3> out;
  for (glm::dvec3 d : {glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1), glm::dvec3(1, 0.6, 0.35),
                       glm::dvec3(-0.3, 0.5, 1)}) {
    glm::dvec3 world(0.0);
    for (int axis = 0; axis < 3; ++axis) world += d[axis] * glm::normalize(glm::dvec3(worldFromVoxel[axis]));
    out.push_back(glm::normalize(world));
  }
  return out;
}

/// What says which plane it is, as a file of planes begins its lines.
std::string keyOf(const Member& member, Way way, std::size_t direction, int place) {
  return fmt::format("{},{},{},{},{}", member.family, member.source, kWays[int(way)], direction, place);
}

/// The planes of a file, by their key: measured before, and not again.
class KnownPlanes {
 public:
  explicit KnownPlanes(std::string path) : mPath(std::move(path)) {
    std::ifstream in(mPath);
    for (std::string line; std::getline(in, line);) {
      Plane p;
      std::istringstream words(line);
      auto next = [&](char end = ',') {
        std::string word;
        std::getline(words, word, end);
        return word;
      };
      auto number = [&] { return std::atof(next().c_str()); };
      p.family = next(), p.data = next(), p.way = next();
      std::string direction = next(), place = next();
      if (direction.empty() || !std::isdigit(static_cast<unsigned char>(direction[0]))) continue;
      p.direction = std::size_t(std::atoi(direction.c_str()));
      p.place = std::atoi(place.c_str());
      for (int axis = 0; axis < 3; ++axis) p.voxels[axis] = int(number());
      p.pairs = std::int64_t(number());
      p.ratio = number(), p.limit = number();
      mPlanes[fmt::format("{},{},{},{},{}", p.family, p.data, p.way, p.direction, p.place)] = p;
    }
  }
  const Plane* find(const std::string& key) const {
    auto found = mPlanes.find(key);
    return found == mPlanes.end() ? nullptr : &found->second;
  }
  void add(const std::string& key, const Plane& p) {
    mPlanes[key] = p;
    if (mPath.empty()) return;
    bool isNew = !std::filesystem::exists(mPath);
    std::ofstream out(mPath, std::ios::app);
    if (isNew) out << "data,source,protected by,direction,place,x,y,z,pairs,ratio,limit\n";
    out << fmt::format("{},{},{},{},{},{:.4f},{:.4f}\n", key, p.voxels.x, p.voxels.y, p.voxels.z, p.pairs, p.ratio,
                       p.limit);
    if (!out.flush()) throw InputError(fmt::format("{} cannot be written", mPath));
  }

 private:
  std::string mPath;
  std::map<std::string, Plane> mPlanes;
};

constexpr std::size_t kDirections = 5;
constexpr int kPositions = 10;

/// Its data is made when the first plane asks for it.
class Sweep {
 public:
  explicit Sweep(const Member& member) : mMember(member) {}

  Plane measure(Way way, std::size_t direction, int place) {
    if (!mScene) mScene = sceneOf(mMember);
    scene::Scene& scene = *mScene;
    Progress progress;
    Plane plane{mMember.family, mMember.source, kWays[int(way)], direction, place, voxelsOf(scene)};
    scene.cuts = {membraneAcross(scene, directionsOf(scene)[direction], (place + 1.0) / (kPositions + 1))};
    if (!protect(mMember, scene, way, *scene.cuts[0].membrane)) return plane;
    auto settled = session::settleMembranes(scene, {true, true}, progress);
    const auto& report = settled[0];
    plane.pairs = report.kept->cutAreaPlane;
    plane.ratio = report.kept->ratio;
    plane.limit = report.limit->figure.ratio;
    fmt::print(stderr, "{}: {} pairs, ratio {:.3f} limit {:.3f} {:6.0f} ms{}\n", keyOf(mMember, way, direction, place),
               plane.pairs, plane.ratio, plane.limit, report.totalMs,
               plane.pairs < kLeastPairs  ? ""
               : inNineOfTen(plane) > 1.0 ? "  FAR"
               : inMedian(plane) > 1.0    ? "  over"
                                          : "");
    return plane;
  }

 private:
  const Member& mMember;
  std::optional<scene::Scene> mScene;
};

void sweep(const Member& member, const Options& options, KnownPlanes& known, std::vector<Plane>& planes) {
  Sweep data(member);
  for (Way way : {Way::Click, Way::Value, Way::Default})
    for (std::size_t d = 0; d < kDirections; ++d)
      for (int i = options.quick ? 4 : options.tune ? 1 : 0; i < kPositions; i += options.quick ? 10 : 2) {
        std::string key = keyOf(member, way, d, i);
        if (!known.find(key)) known.add(key, data.measure(way, d, i));
        const Plane& plane = *known.find(key);
        if (plane.pairs >= kLeastPairs) planes.push_back(plane);
      }
}

/// From the smallest data to the largest.
std::string sizesOf(const std::vector<Plane>& planes) {
  auto count = [](const Plane& p) { return std::int64_t(p.voxels.x) * p.voxels.y * p.voxels.z; };
  auto [least, most] = std::minmax_element(planes.begin(), planes.end(),
                                           [&](const auto& a, const auto& b) { return count(a) < count(b); });
  auto text = [](glm::ivec3 n) { return fmt::format("{} x {} x {}", n.x, n.y, n.z); };
  if (least == planes.end()) return "";
  return least->voxels == most->voxels ? text(most->voxels) : text(least->voxels) + " to " + text(most->voxels);
}

std::vector<std::string> rowOf(const std::string& family, const std::vector<Plane>& planes) {
  auto ratio = [](const Plane& p) { return p.ratio; };
  auto limit = [](const Plane& p) { return p.limit; };
  auto number = [](double value) { return fmt::format("{:.2f}", value); };
  return {family,
          sizesOf(planes),
          std::to_string(planes.size()),
          number(quantileOf(planes, ratio, 0.5)),
          number(quantileOf(planes, limit, 0.5)),
          number(quantileOf(planes, inMedian, 0.5)),
          number(quantileOf(planes, inNineOfTen, 0.9)),
          number(quantileOf(planes, inNineOfTen, 1.0)),
          number(quantileOf(planes, ratio, 1.0))};
}

}  // namespace

void measureFamilies(const Options& options, Report& report) {
  report.section("families", "What the membrane keeps whole, by kinds of data");
  sharedContext().makeCurrent();
  KnownPlanes known(options.planes);
  std::vector<std::string> order;
  std::vector<Plane> all;
  for (const Member& member : kMembers) {
    if (member.phantomSize < 0 && !std::getenv("VELUM_TEST_DATA")) continue;
    if (fmt::format("{}: {}", member.family, member.source).find(options.match) == std::string::npos) continue;
    sweep(member, options, known, all);
    if (std::find(order.begin(), order.end(), member.family) == order.end()) order.push_back(member.family);
  }
  std::vector<std::vector<std::string>> rows;
  for (const auto& family : order) {
    std::vector<Plane> planes;
    std::copy_if(all.begin(), all.end(), std::back_inserter(planes), [&](const auto& p) { return p.family == family; });
    rows.push_back(rowOf(family, planes));
    report.figure("family/" + family, {{"median", quantileOf(planes, inMedian, 0.5)},
                                       {"nineInTen", quantileOf(planes, inNineOfTen, 0.9)},
                                       {"worst", quantileOf(planes, inNineOfTen, 1.0)}});
  }
  report.note(
      "Protected by a click on the material nearest to the middle, by its values, and by what a new membrane protects; "
      "frames across the three axes and two oblique directions, at five places of ten (with --tune the five others, on "
      "which constants may be chosen). Ratio: pairs of protected voxels cut by the sheet / by the plane; limit: the "
      "least there is. Median goal: ratio / (1.25 limit + 0.02) in the median; nine in ten: ratio / (1.6 limit + "
      "0.05). Both are met up to 1. Each plane is in PERFORMANCE.families.csv.");
  report.table({"data", "voxels", "planes", "ratio", "limit", "median goal", "nine in ten", "worst", "largest ratio"},
               rows);
}

}  // namespace velum::bench
