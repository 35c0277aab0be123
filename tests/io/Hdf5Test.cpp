#include <gtest/gtest.h>

#include <cstdlib>

#include "Damage.h"
#include "Hdf5Files.h"
#include "core/Parallel.h"
#include "io/stores/OpenStore.h"

namespace velum::io {
namespace {

namespace fs = std::filesystem;

/// An image of one level and nothing but voxels.
void writeOneLevel(const fs::path& path, Hdf5Data data, bool isNewest = false) {
  Hdf5Out out(path, isNewest);
  out.group("s00");
  out.table("s00/resolutions", {1, 1, 1});
  out.attribute("s00", "dataType", data.type, false);
  data.name = "t00000/s00/0/cells";
  out.data(data);
}

void expectWritten(const Volume& v, const Hdf5Data& data) {
  ASSERT_EQ(v.dims, glm::ivec3(data.shape[2], data.shape[1], data.shape[0]));
  forEach(data.shape, [&](const Sizes& at) {
    ASSERT_EQ(valueAt(v, {int(at[2]), int(at[1]), int(at[0])}), data.value(at)) << at[0] << at[1] << at[2];
  });
}

TEST(Hdf5, EveryTypeAndFilterGivesWhatWasWritten) {
  TempFolder folder;
  const std::vector<std::vector<std::string>> kFilters = {
      {},       {"gzip"},  {"shuffle"},           {"shuffle", "gzip"}, {"lz4"}, {"shuffle", "lz4"},
      {"zstd"}, {"blosc"}, {"gzip", "fletcher32"}};
  for (const char* type :
       {"uint8", "int8", "uint16", "int16", "uint32", "int32", "uint64", "int64", "float32", "float64"})
    for (const auto& filters : kFilters)
      for (bool isBigEndian : {false, true}) {
        SCOPED_TRACE(std::string(type) + " " + (filters.empty() ? "" : filters.back()));
        Hdf5Data data = hdf5Ramp("");
        data.type = type;
        data.filters = filters;
        data.isBigEndian = isBigEndian;
        bool isSigned = type[0] != 'u';
        data.value = [=](const Sizes& i) {
          double value = double((i[0] * 42 + i[1] * 7 + i[2]) % 128);
          return isSigned && i[2] % 2 ? -value : value;
        };
        writeOneLevel(folder / "a.h5", data);
        expectWritten(read(folder / "a.h5"), data);
      }
}

TEST(Hdf5, DatasetsInOnePieceAndOfTheNewestLayoutAreRead) {
  TempFolder folder;
  Hdf5Data data = hdf5Ramp("");
  writeOneLevel(folder / "new.h5", data, true);
  expectWritten(read(folder / "new.h5"), data);
  data.chunk.clear();
  data.shape = {70, 6, 7};
  writeOneLevel(folder / "whole.h5", data);
  expectWritten(read(folder / "whole.h5"), data);
}

TEST(Hdf5, ChunksThatFiltersLeftAsTheyWereAreRead) {
  TempFolder folder;
  Hdf5Data data = hdf5Ramp("");
  data.filters = {"shuffle", "gzip"};
  data.skipsFilters = true;
  writeOneLevel(folder / "a.h5", data);
  expectWritten(read(folder / "a.h5"), data);
}

TEST(Hdf5, MissingChunksAreZero) {
  TempFolder folder;
  Hdf5Data data = hdf5Ramp("");
  auto value = data.value;
  data.isThere = [](const Sizes& index) { return index[2] != 1; };
  data.filters = {"gzip"};
  writeOneLevel(folder / "a.h5", data);
  data.value = [&](const Sizes& at) { return at[2] < 4 ? value(at) : 0.0; };
  expectWritten(read(folder / "a.h5"), data);
}

TEST(Hdf5, ChunksAreFoundAmongManyByAllCoresAtOnce) {
  TempFolder folder;
  Hdf5Data data = hdf5Ramp("");
  data.shape = {64, 64, 64};
  data.chunk = {4, 4, 4};
  data.value = [](const Sizes& i) { return double(i[0] * 4096 + i[1] * 64 + i[2]); };
  data.type = "uint32";
  data.filters = {"shuffle", "gzip"};
  for (bool isNewest : {false, true}) {
    writeOneLevel(folder / "a.h5", data, isNewest);
    expectWritten(read(folder / "a.h5"), data);
  }
}

TEST(Hdf5, AFileThatIsCutShortOrDamagedIsReadOrRefusedInOneLine) {
  TempFolder folder;
  Hdf5Data data = hdf5Ramp("");
  data.filters = {"shuffle", "gzip"};
  fs::path path = folder / "a.h5";
  writeOneLevel(path, data);
  std::string good = bytesOf(path);
  for (std::size_t size = 0; size < good.size(); size += 1 + good.size() / 32) {
    writeText(path, good.substr(0, size));
    EXPECT_NE(refusalOf(path), "") << "cut to " << size;
  }
  // What the library itself reads is its own affair; here a chunk is damaged.
  std::size_t chunk = good.find("\x78\x5e");
  if (chunk == good.npos) chunk = good.find("\x78\x9c");
  ASSERT_NE(chunk, good.npos);
  std::string bad = good;
  for (std::size_t i = 2; i < 12; ++i) bad[chunk + i] = char(bad[chunk + i] ^ 0x5a);
  writeText(path, bad);
  EXPECT_NE(refusalOf(path), "");
}

TEST(Hdf5, WhatIsNoImageIsNamed) {
  TempFolder folder;
  {
    Hdf5Out out(folder / "other.h5");
    out.data(hdf5Ramp("some/thing"));
  }
  EXPECT_NE(refusalOf(folder / "other.h5").find("no kind that is read here"), std::string::npos);
  Hdf5Data data = hdf5Ramp("");
  data.shape = {5, 6};
  data.chunk = {2, 3};
  data.value = [](const Sizes&) { return 1.0; };
  writeOneLevel(folder / "flat.h5", data);
  EXPECT_NE(refusalOf(folder / "flat.h5").find("2 axes"), std::string::npos);
  writeText(folder / "a.h5", "no HDF5");
  EXPECT_NE(refusalOf(folder / "a.h5"), "");
}

TEST(Hdf5Oracle, H5pyWritesWhatIsReadHere) {
  if (std::system("/usr/bin/python3 -c 'import h5py' 2>/dev/null") != 0) GTEST_SKIP() << "install python3-h5py";
  TempFolder folder;
  writeText(folder / "make.py", R"(
import sys, numpy, h5py
root = sys.argv[1]
a = (numpy.arange(11 * 13 * 17).reshape(11, 13, 17) * 37 % 65521).astype('<u2')
a.tofile(root + '/plain')
ways = {'raw': {}, 'gzip': {'compression': 'gzip'}, 'shuffle': {'compression': 'gzip', 'shuffle': True},
        'check': {'compression': 'gzip', 'fletcher32': True}, 'szip-or-less': {'scaleoffset': 0}}
for name, way in ways.items():
    for libver in ('earliest', 'latest'):
        with h5py.File('%s/%s-%s.h5' % (root, name, libver), 'w', libver=libver) as f:
            f['s00/resolutions'] = numpy.ones((1, 3))
            f['s00'].attrs['dataType'] = 'uint16'
            f.create_dataset('t00000/s00/0/cells', data=a, chunks=(4, 5, 6), **way)
)");
  std::string line = "/usr/bin/python3 '" + (folder / "make.py").string() + "' '" + folder.path().string() + "'";
  ASSERT_EQ(std::system(line.c_str()), 0);
  std::string plain = bytesOf(folder / "plain");
  int tried = 0;
  for (const auto& entry : fs::directory_iterator(folder.path())) {
    if (entry.path().extension() != ".h5") continue;
    Volume v = read(entry.path());
    EXPECT_EQ(v.dims, glm::ivec3(17, 13, 11));
    EXPECT_TRUE(v.voxels.size() == plain.size() && std::memcmp(v.voxels.data(), plain.data(), plain.size()) == 0)
        << entry.path();
    ++tried;
  }
  EXPECT_EQ(tried, 10);
}

}  // namespace
}  // namespace velum::io
