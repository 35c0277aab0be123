#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>

#include "Child.h"
#include "Data.h"
#include "Sections.h"
#include "io/phantoms/Sample.h"
#include "io/volumes/ReadVolume.h"
#include "io/volumes/WriteVolume.h"

namespace velum::bench {

namespace {

namespace fs = std::filesystem;

/// A MetaImage without compression: header and voxels in one file.
void writeMha(const Volume& volume, const fs::path& path) {
  glm::dvec3 spacing = spacingOf(volume);
  std::ofstream out(path, std::ios::binary);
  out << fmt::format(
      "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\nDimSize = {} {} {}\n"
      "ElementSpacing = {} {} {}\nElementType = {}\nElementDataFile = LOCAL\n",
      volume.dims.x, volume.dims.y, volume.dims.z, spacing.x, spacing.y, spacing.z,
      volume.type == SampleType::UInt8 ? "MET_UCHAR" : "MET_SHORT");
  out.write(reinterpret_cast<const char*>(volume.voxels.data()), std::streamsize(timeStepBytes(volume)));
}

struct Cost {
  double ms = 0, peakMb = 0;
};

/// Medians over fresh processes.
Cost costOf(const std::string& reader, const fs::path& path, int turns) {
  std::vector<double> times, peaks;
  for (int turn = 0; turn < turns; ++turn) {
    auto child = runChild({"read", reader, path.string()});
    if (child.is_null()) return {};
    times.push_back(child["ms"]);
    peaks.push_back(child["peakMb"]);
  }
  return {median(times), median(peaks)};
}

/// A line of /proc/self/status in megabytes. The largest size that wait4() tells of a child includes what it was before
/// it became this program, so the child asks for itself.
double statusMb(std::string_view key) {
  std::ifstream in("/proc/self/status");
  for (std::string line; std::getline(in, line);)
    if (line.starts_with(key)) return std::stod(line.substr(key.size() + 1)) / 1024.0;
  return 0.0;
}

}  // namespace

nlohmann::json childRead(const std::string& reader, const std::string& path) {
  double beforeMb = statusMb("VmRSS");
  auto start = std::chrono::steady_clock::now();
  if (reader == "velum") {
    Progress progress;
    io::readVolume({path}, progress);
  } else if (reader == "itk") {
    readWithItk(path);
  } else if (reader == "vtk") {
    readWithVtk(path);
  }
  double ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  return {{"ms", ms}, {"peakMb", statusMb("VmHWM") - beforeMb}};
}

void measureLoading(const Options& options, Report& report) {
  report.section("loading", "Loading");
  fs::path folder = fs::temp_directory_path() / fmt::format("velum-bench-files-{}", getpid());
  fs::create_directories(folder);
  Volume volume = makeCube("torso", options.quick ? 128 : 256);
  struct Job {
    const char* file;
    const char* other;
  };
  constexpr Job kJobs[] = {
      {"trunk.nrrd", "itk"}, {"trunk.nii.gz", "itk"}, {"trunk.nii", "itk"}, {"trunk.mha", "itk"}, {"trunk.vti", "vtk"}};
  Progress progress;
  double voxelMb = double(timeStepBytes(volume)) / 1048576.0;
  int turns = options.quick ? 1 : 5;
  std::vector<std::vector<std::string>> rows;
  for (const Job& job : kJobs) {
    fs::path path = folder / job.file;
    if (path.extension() == ".mha")
      writeMha(volume, path);
    else
      io::writeVolume(volume, path, progress);
    Cost ours = costOf("velum", path, turns), other = costOf(job.other, path, turns);
    std::string name = job.file + 6;
    rows.push_back({fmt::format("{} ({:.0f} MB)", name, double(fs::file_size(path)) / 1048576.0),
                    job.other == std::string("itk") ? "ITK" : "VTK", formatMs(other.ms), formatMs(ours.ms),
                    fmt::format("{:.2f}", ours.ms / other.ms), fmt::format("{:.2f}", other.peakMb / voxelMb),
                    fmt::format("{:.2f}", ours.peakMb / voxelMb)});
    report.figure(name, {{"otherMs", other.ms},
                         {"oursMs", ours.ms},
                         {"otherPeakMb", other.peakMb},
                         {"oursPeakMb", ours.peakMb},
                         {"voxelMb", voxelMb}});
    fs::remove(path);
  }
  fs::remove_all(folder);
  report.note(
      fmt::format("Files of ours, {:.0f} MB of int16 voxels, in the page cache; each reading in a process of its own, "
                  "median of {}. "
                  "Ours also finds the range of the values, which the others leave to whoever asks. Peak: growth "
                  "of the process, in multiples of the voxels.",
                  voxelMb, turns));
  report.table({"format", "against", "its time, ms", "Velum, ms", "ratio (less is better)", "its peak", "Velum's peak"},
               rows);
}

}  // namespace velum::bench
