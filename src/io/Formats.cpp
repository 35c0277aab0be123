#include "velum/io/Formats.h"

#include "formats/Readers.h"

namespace velum::io {

namespace {
constexpr Format kFormats[] = {
    {"DICOM", ".dcm .ima .dicom DICOMDIR", true, false},
    {"NIfTI", ".nii .nii.gz .hdr .img", true, true},
    {"NRRD", ".nrrd .nhdr", true, true},
    {"MetaImage", ".mha .mhd", true, false},
    {"MRC", ".mrc .map .rec .ccp4", true, false},
    {"VTK image data", ".vti", true, true},
    {"VTK legacy structured points", ".vtk", true, false},
    {"SEG-Y", ".sgy .segy", true, false},
    {"TIFF", ".tif .tiff", true, false},
    {"OpenVDB", ".vdb", true, true},
    {"Raw", ".raw .bin .img .den", true, false},
};
}  // namespace

std::span<const Format> formats() { return kFormats; }

}  // namespace velum::io
