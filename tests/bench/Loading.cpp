#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>

#include "Child.h"
#include "Data.h"
#include "Sections.h"
#include "velum/io/ReadVolume.h"
#include "velum/io/Sample.h"
#include "velum/io/WriteVolume.h"

namespace velum::bench {

namespace {

namespace fs = std::filesystem;

/// A MetaImage without compression: header and voxels in one file.
void writeMha(const Volume& volume, const fs::path& path) {
  glm::dvec3 spacing = spacingMm(volume);
  std::ofstream out(path, std::ios::binary);
  out << fmt::format(
      "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\nDimSize = {} {} {}\n"
      "ElementSpacing = {} {} {}\nElementType = {}\nElementDataFile = LOCAL\n",
      volume.dims.x, volume.dims.y, volume.dims.z, spacing.x, spacing.y, spacing.z,
      volume.type == SampleType::UInt8 ? "MET_UCHAR" : "MET_SHORT");
  out.write(reinterpret_cast<const char*>(volume.voxels.data()), std::streamsize(frameBytes(volume)));
}

struct Cost {
  double ms = 0, peakMb = 0;
};

/// Median time of fresh processes, and their peak less what a process has that reads nothing.
Cost costOf(const std::string& reader, const fs::path& path, int turns, double idleMb) {
  std::vector<double> times, peaks;
  for (int turn = 0; turn < turns; ++turn) {
    auto child = runChild({"read", reader, path.string()});
    if (child.figures.is_null()) return {};
    times.push_back(child.figures["ms"]);
    peaks.push_back(child.peakMb - idleMb);
  }
  return {median(times), median(peaks)};
}

}  // namespace

nlohmann::json childRead(const std::string& reader, const std::string& path) {
  auto start = std::chrono::steady_clock::now();
  std::size_t bytes = 0;
  if (reader == "velum") {
    Progress progress;
    bytes = io::readVolume({path}, progress).voxels.size();
  } else if (reader == "itk") {
    bytes = readWithItk(path);
  } else if (reader == "vtk") {
    bytes = readWithVtk(path);
  }
  double ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  return {{"ms", ms}, {"megabytes", double(bytes) / 1048576.0}};
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
  double idleMb = runChild({"read", "none", "-"}).peakMb, voxelMb = double(frameBytes(volume)) / 1048576.0;
  int turns = options.quick ? 1 : 5;
  std::vector<std::vector<std::string>> rows;
  for (const Job& job : kJobs) {
    fs::path path = folder / job.file;
    if (path.extension() == ".mha")
      writeMha(volume, path);
    else
      io::writeVolume(volume, path, progress);
    Cost ours = costOf("velum", path, turns, idleMb), other = costOf(job.other, path, turns, idleMb);
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
                  "Ours also finds the range of the values, which the others leave to whoever asks. Peak: above a "
                  "process that reads "
                  "nothing, in multiples of the voxels.",
                  voxelMb, turns));
  report.table({"format", "against", "its time, ms", "Velum, ms", "ratio (less is better)", "its peak", "Velum's peak"},
               rows);
}

}  // namespace velum::bench
