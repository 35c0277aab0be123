#include "io/Plugins.h"

namespace velum::io {

extern "C" {
extern const GdcmPlugin velumPlugin;
const GdcmPlugin velumPlugin{
    .readDicom = plugin::readDicom,
    .readRtStruct = plugin::readRtStruct,
    .readDicomSeg = plugin::readDicomSeg,
    .writeDicomSeg = plugin::writeDicomSeg,
    .holdsDicom = plugin::holdsDicom,
    .labelsWithoutImages = plugin::labelsWithoutImages,
    .isDicomIndex = plugin::isDicomIndex,
    .isDicomSeg = plugin::isDicomSeg,
    .isRtStruct = plugin::isRtStruct,
    .listSeries = plugin::listSeries,
    .readSeriesImage = plugin::readSeriesImage,
};
}

}  // namespace velum::io
