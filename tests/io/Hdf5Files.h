#pragma once
#include <hdf5.h>

#include "ZarrFiles.h"

/// Writes HDF5 by the library: what the readers are held against.
namespace velum::io {

/// The filter 32004 as its description says: blocks, one that grows is stored as it is.
inline std::string packedByHdf5Lz4(const std::string& bytes, std::size_t block) {
  std::string out = bytesOfNumber(std::uint64_t(bytes.size()), true) + bytesOfNumber(std::uint32_t(block), true);
  for (std::size_t at = 0; at < bytes.size(); at += block) {
    std::string piece = bytes.substr(at, block), packed = packedBy("lz4", piece, 1).substr(4);
    if (packed.size() >= piece.size()) packed = piece;
    out += bytesOfNumber(std::uint32_t(packed.size()), true) + packed;
  }
  return out;
}

/// The first bytes of all samples, then the second ones.
inline std::string shuffled(const std::string& bytes, std::size_t sample) {
  std::string out;
  for (std::size_t part = 0; part < sample; ++part)
    for (std::size_t i = part; i < bytes.size(); i += sample) out += bytes[i];
  return out;
}

/// A dataset that is to be written. Lists begin with z.
struct Hdf5Data {
  std::string name;
  Sizes shape, chunk;  ///< no chunk: in one piece
  std::string type = "uint16";
  bool isBigEndian = false;
  std::vector<std::string> filters;  ///< "shuffle", "gzip", "lz4", "fletcher32", "zstd", "blosc"
  std::function<double(const Sizes&)> value;
  std::function<bool(const Sizes&)> isThere = [](auto&) { return true; };  ///< a chunk, by its index
  bool skipsFilters = false;                                               ///< the first chunk is stored as it is
};

/// A file that is being written.
class Hdf5Out {
 public:
  explicit Hdf5Out(const std::filesystem::path& path, bool isNewest = false) {
    hid_t access = ::H5Pcreate(H5P_FILE_ACCESS);
    if (isNewest) ::H5Pset_libver_bounds(access, H5F_LIBVER_LATEST, H5F_LIBVER_LATEST);
    mFile = ::H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access);
    ::H5Pclose(access);
  }
  ~Hdf5Out() { ::H5Fclose(mFile); }

  void group(const std::string& name) {
    hid_t links = ::H5Pcreate(H5P_LINK_CREATE);
    ::H5Pset_create_intermediate_group(links, 1);
    ::H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // that it is there already is no error
    if (hid_t made = ::H5Gcreate2(mFile, name.c_str(), links, H5P_DEFAULT, H5P_DEFAULT); made >= 0) ::H5Gclose(made);
    ::H5Pclose(links);
  }
  /// An attribute, a string of its length, or, as Imaris writes it, an array of letters.
  void attribute(const std::string& object, const std::string& name, const std::string& text, bool isLetters) {
    hsize_t count = text.size();
    hid_t type = ::H5Tcopy(H5T_C_S1);
    if (!isLetters) ::H5Tset_size(type, text.size());
    hid_t space = isLetters ? ::H5Screate_simple(1, &count, nullptr) : ::H5Screate(H5S_SCALAR);
    hid_t made =
        ::H5Acreate_by_name(mFile, object.c_str(), name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    ::H5Awrite(made, type, text.data());
    ::H5Aclose(made);
    ::H5Sclose(space);
    ::H5Tclose(type);
  }
  /// A table of rows of three.
  void table(const std::string& name, const std::vector<double>& numbers) {
    hsize_t sizes[2] = {numbers.size() / 3, 3};
    hid_t space = ::H5Screate_simple(2, sizes, nullptr);
    hid_t made = ::H5Dcreate2(mFile, name.c_str(), H5T_IEEE_F64LE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    ::H5Dwrite(made, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data());
    ::H5Dclose(made);
    ::H5Sclose(space);
  }
  void link(const std::string& name, const std::string& file, const std::string& object) {
    ::H5Lcreate_external(file.c_str(), object.c_str(), mFile, name.c_str(), H5P_DEFAULT, H5P_DEFAULT);
  }
  void data(const Hdf5Data& data);

 private:
  static hid_t typeOf(const Hdf5Data& data) {
    int bytes = int(sampleBytes(data.type, 0, false).size());
    hid_t types[] = {H5T_STD_U8LE, H5T_STD_U16LE, H5T_STD_U32LE, H5T_STD_U64LE};
    hid_t signedTypes[] = {H5T_STD_I8LE, H5T_STD_I16LE, H5T_STD_I32LE, H5T_STD_I64LE};
    int log = bytes == 1 ? 0 : bytes == 2 ? 1 : bytes == 4 ? 2 : 3;
    hid_t type = ::H5Tcopy(data.type[0] == 'f'   ? bytes == 4 ? H5T_IEEE_F32LE : H5T_IEEE_F64LE
                           : data.type[0] == 'i' ? signedTypes[log]
                                                 : types[log]);
    if (data.isBigEndian) ::H5Tset_order(type, H5T_ORDER_BE);
    return type;
  }
  hid_t mFile;
};

inline void Hdf5Out::data(const Hdf5Data& data) {
  if (std::size_t slash = data.name.rfind('/'); slash != data.name.npos) group(data.name.substr(0, slash));
  std::vector<hsize_t> shape(data.shape.begin(), data.shape.end()), chunk(data.chunk.begin(), data.chunk.end());
  hid_t how = ::H5Pcreate(H5P_DATASET_CREATE), space = ::H5Screate_simple(int(shape.size()), shape.data(), nullptr);
  hid_t type = typeOf(data);
  bool isByLibrary = chunk.empty();
  if (!chunk.empty()) ::H5Pset_chunk(how, int(chunk.size()), chunk.data());
  for (const std::string& filter : data.filters) {
    if (filter == "shuffle") ::H5Pset_shuffle(how);
    if (filter == "gzip") ::H5Pset_deflate(how, 6);
    if (filter == "fletcher32") ::H5Pset_fletcher32(how), isByLibrary = true;
    int others = filter == "lz4" ? 32004 : filter == "zstd" ? 32015 : filter == "blosc" ? 32001 : 0;
    if (others) ::H5Pset_filter(how, others, H5Z_FLAG_OPTIONAL, 0, nullptr);
  }
  hid_t made = ::H5Dcreate2(mFile, data.name.c_str(), type, space, H5P_DEFAULT, how, H5P_DEFAULT);
  std::size_t sample = sampleBytes(data.type, 0, false).size();
  if (isByLibrary) {
    std::string bytes;
    forEach(data.shape, [&](const Sizes& at) { bytes += sampleBytes(data.type, data.value(at), data.isBigEndian); });
    ::H5Dwrite(made, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data());
  } else {
    forEach(divided(data.shape, data.chunk), [&](const Sizes& index) {
      if (!data.isThere(index)) return;
      std::string bytes;
      std::vector<hsize_t> origin;
      for (std::size_t i = 0; i < index.size(); ++i) origin.push_back(index[i] * data.chunk[i]);
      forEach(data.chunk, [&](const Sizes& at) {
        Sizes place;
        bool isInside = true;
        for (std::size_t i = 0; i < at.size(); ++i) {
          place.push_back(origin[i] + at[i]);
          isInside = isInside && place[i] < data.shape[i];
        }
        bytes += sampleBytes(data.type, isInside ? data.value(place) : 77, data.isBigEndian);
      });
      bool isSkipped = data.skipsFilters && index == Sizes(index.size(), 0);
      for (const std::string& filter : isSkipped ? std::vector<std::string>() : data.filters) {
        if (filter == "shuffle") bytes = shuffled(bytes, sample);
        if (filter == "lz4") bytes = packedByHdf5Lz4(bytes, 40);
        if (filter == "gzip") bytes = packedBy("zlib", bytes, 1);
        if (filter == "zstd" || filter == "blosc") bytes = packedBy(filter, bytes, int(sample));
      }
      ::H5Dwrite_chunk(made, H5P_DEFAULT, isSkipped ? ~0u : 0u, origin.data(), bytes.size(), bytes.data());
    });
  }
  ::H5Dclose(made);
  ::H5Tclose(type);
  ::H5Sclose(space);
  ::H5Pclose(how);
}

/// A dataset of z, y, x whose values are the numbers of its samples, and 1000 for each `more`.
inline Hdf5Data hdf5Ramp(const std::string& name, int more = 0) {
  Hdf5Data data;
  data.name = name;
  data.shape = {5, 6, 7};
  data.chunk = {2, 3, 4};
  data.value = [more](const Sizes& i) { return double(more * 1000) + double(i[0] * 42 + i[1] * 7 + i[2]); };
  return data;
}

/// An image of BigDataViewer: time points 0 and 1, setups 0 and 1, levels 1 and 2 x 2 x 1.
/// @param change  of each dataset before it is written
inline void writeBdv(
    const std::filesystem::path& path, const std::function<void(Hdf5Data&)>& change = [](auto&) {}) {
  Hdf5Out out(path);
  for (int setup = 0; setup < 2; ++setup) {
    std::string group = "s0" + std::to_string(setup);
    out.group(group);
    out.table(group + "/resolutions", {1, 1, 1, 2, 2, 1});
    out.table(group + "/subdivisions", {4, 3, 2, 4, 3, 2});
    for (int time = 0; time < 2; ++time)
      for (int level = 0; level < 2; ++level) {
        Hdf5Data data = hdf5Ramp("t0000" + std::to_string(time) + "/" + group + "/" + std::to_string(level) + "/cells",
                                 time * 10 + setup);
        if (level == 1) data.shape = {5, 3, 3}, data.chunk = {2, 3, 3};
        data.type = "int16";
        data.filters = {"gzip"};
        change(data);
        if (!data.shape.empty()) out.data(data);
      }
  }
}

/// Its XML. @param second  attributes of the second setup @param registrations  of (time point, setup): lists of twelve
/// numbers
inline void writeSpimData(const std::filesystem::path& path, const std::string& format, const std::string& voxels,
                          const std::string& second, const std::string& registrations) {
  std::string xml =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<SpimData version=\"0.2\">\n<BasePath "
      "type=\"relative\">.</BasePath>\n<SequenceDescription>\n<ImageLoader format=\"bdv." +
      format + "\"><" + format + " type=\"relative\">" + voxels + "</" + format + "></ImageLoader>\n<ViewSetups>\n";
  for (int setup = 0; setup < 2; ++setup)
    xml += "<ViewSetup><id>" + std::to_string(setup) +
           "</id><size>7 6 5</size><voxelSize><unit>\xc2\xb5m</unit><size>0.5 0.5 2.0</size></voxelSize><attributes>" +
           (setup == 0 ? "<channel>0</channel><tile>0</tile>" : second) + "</attributes></ViewSetup>\n";
  xml +=
      "<Attributes "
      "name=\"channel\"><Channel><id>0</id><name>GFP</name></Channel><Channel><id>1</id><name>RFP</name></Channel></"
      "Attributes>\n</ViewSetups>\n<Timepoints "
      "type=\"pattern\"><integerpattern>0-1</integerpattern></Timepoints>\n</"
      "SequenceDescription>\n<ViewRegistrations>\n" +
      registrations + "</ViewRegistrations>\n</SpimData>\n";
  writeBytes(path, xml);
}

inline std::string registration(int time, int setup, const std::vector<std::string>& affines) {
  std::string xml =
      "<ViewRegistration timepoint=\"" + std::to_string(time) + "\" setup=\"" + std::to_string(setup) + "\">";
  for (const std::string& affine : affines)
    xml += "<ViewTransform type=\"affine\"><affine>" + affine + "</affine></ViewTransform>";
  return xml + "</ViewRegistration>\n";
}

/// An image of Imaris: two time points, two channels, two levels, packed as `filters` say. Arrays are padded to chunks.
inline void writeImaris(
    const std::filesystem::path& path, const std::vector<std::string>& filters,
    const std::function<void(Hdf5Data&)>& change = [](auto&) {}) {
  Hdf5Out out(path);
  std::string info = "DataSetInfo";
  auto letters = [&](const std::string& group, const std::string& name, const std::string& text) {
    out.group(group);
    out.attribute(group, name, text, true);
  };
  const char* low[] = {"10", "20", "30"};
  const char* high[] = {"13.5", "23", "40"};
  for (int axis = 0; axis < 3; ++axis) {
    letters(info + "/Image", "ExtMin" + std::to_string(axis), low[axis]);
    letters(info + "/Image", "ExtMax" + std::to_string(axis), high[axis]);
    letters(info + "/Image", std::string(1, "XYZ"[axis]), std::to_string(7 - axis));
  }
  letters(info + "/Image", "Unit", "um");
  letters(info + "/TimeInfo", "DatasetTimePoints", "2");
  letters(info + "/TimeInfo", "TimePoint1", "2021-03-01 23:59:50.000");
  letters(info + "/TimeInfo", "TimePoint2", "2021-03-02 00:00:20.500");
  for (int channel = 0; channel < 2; ++channel) {
    std::string group = info + "/Channel " + std::to_string(channel);
    letters(group, "Color", channel == 0 ? "1.000 0.000 0.000" : "0.000 1.000 0.500");
    letters(group, "ColorRange", "5.000 200.000");
    letters(group, "Name", channel == 0 ? "nuclei" : "(name not specified)");
    for (int level = 0; level < 2; ++level)
      for (int time = 0; time < 2; ++time) {
        std::string to = "DataSet/ResolutionLevel " + std::to_string(level) + "/TimePoint " + std::to_string(time) +
                         "/Channel " + std::to_string(channel);
        out.group(to);
        const int sizes[2][3] = {{7, 6, 5}, {3, 3, 5}};
        for (int axis = 0; axis < 3; ++axis)
          out.attribute(to, std::string("ImageSize") + "XYZ"[axis], std::to_string(sizes[level][axis]), true);
        Hdf5Data data = hdf5Ramp(to + "/Data", time * 10 + channel);
        data.shape = level == 0 ? Sizes{6, 6, 8} : Sizes{6, 3, 4};
        data.filters = filters;
        change(data);
        if (!data.shape.empty()) out.data(data);
      }
  }
}

}  // namespace velum::io
