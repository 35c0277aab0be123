#include "io/volumes/DicomPet.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>

#include "io/volumes/DicomTags.h"

namespace velum::io {

namespace {

using gdcm::DataSet;
using gdcm::Tag;

constexpr double kDayS = 86400;

/// Days since 1970 of "YYYYMMDD" or the old "YYYY.MM.DD".
std::optional<double> dayOf(std::string text) {
  std::erase(text, '.');
  if (text.size() < 8) return std::nullopt;
  auto year = numberIn(text.substr(0, 4)), month = numberIn(text.substr(4, 2)), day = numberIn(text.substr(6, 2));
  if (!year || !month || !day || *year < 0 || *month < 0 || *day < 0) return std::nullopt;
  std::chrono::year_month_day date{std::chrono::year(int(*year)), std::chrono::month(unsigned(*month)),
                                   std::chrono::day(unsigned(*day))};
  if (!date.ok()) return std::nullopt;
  return double(std::chrono::sys_days(date).time_since_epoch().count());
}

/// Seconds of "HHMMSS.FFFFFF", whose end may lack, or the old "HH:MM:SS".
std::optional<double> secondsOf(std::string text) {
  std::erase(text, ':');
  if (text.size() < 2) return std::nullopt;
  auto part = [&](std::size_t at, std::size_t length) -> std::optional<double> {
    return at < text.size() ? numberIn(text.substr(at, length)) : 0.0;
  };
  auto hours = part(0, 2), minutes = part(2, 2), seconds = part(4, std::string::npos);
  if (!hours || !minutes || !seconds) return std::nullopt;
  return *hours * 3600 + *minutes * 60 + *seconds;
}

std::optional<double> timeOf(const std::string& date, const std::string& time) {
  auto day = dayOf(date), seconds = secondsOf(time);
  if (!day || !seconds) return std::nullopt;
  return *day * kDayS + *seconds;
}

/// "YYYYMMDDHHMMSS.FFFFFF&ZZXX": the zone is that of the other times.
std::optional<double> timeOf(const std::string& dateTime) {
  std::string text = dateTime.substr(0, dateTime.find_first_of("+-"));
  if (text.size() < 10) return std::nullopt;
  return timeOf(text.substr(0, 8), text.substr(8));
}

bool isPositive(double value) { return value > 0 && std::isfinite(value); }

/// When the scan began, to which values corrected for decay belong.
std::optional<double> scanTimeOf(std::span<const DicomPet* const> files) {
  const DicomPet& any = *files.front();
  const DicomPet* earliest = nullptr;
  for (const DicomPet* file : files)
    if (file->acquisitionTime && (!earliest || *file->acquisitionTime < *earliest->acquisitionTime)) earliest = file;
  if (!earliest) return std::nullopt;
  if (any.seriesTime && *any.seriesTime <= *earliest->acquisitionTime) return any.seriesTime;
  // The series was made after the scan. GE says when that was; others say where in the scan a frame counts.
  if (any.privateScanTime) return any.privateScanTime;
  if (!isPositive(earliest->frameReferenceS) || !isPositive(earliest->frameDurationS)) return earliest->acquisitionTime;
  double rate = std::log(2.0) / any.halfLifeS, decay = rate * earliest->frameDurationS;
  double meanRateTime = std::log(decay / -std::expm1(-decay)) / rate;
  return *earliest->acquisitionTime - earliest->frameReferenceS + meanRateTime;
}

}  // namespace

DicomPet petOf(const DataSet& set) {
  DicomPet pet;
  pet.units = textOf(set, Tag(0x0054, 0x1001));
  pet.decayCorrection = textOf(set, Tag(0x0054, 0x1102));
  std::string corrected = textOf(set, Tag(0x0028, 0x0051));
  pet.isCorrected = corrected.find("ATTN") != std::string::npos && corrected.find("DECY") != std::string::npos;
  std::string seriesDate = textOf(set, Tag(0x0008, 0x0021));
  pet.seriesTime = timeOf(seriesDate, textOf(set, Tag(0x0008, 0x0031)));
  pet.acquisitionTime = timeOf(textOf(set, Tag(0x0008, 0x0022)), textOf(set, Tag(0x0008, 0x0032)));
  if (textOf(set, Tag(0x0009, 0x0010)) == "GEMS_PETD_01")
    pet.privateScanTime = timeOf(textOf(set, Tag(0x0009, 0x100d)));
  pet.weightKg = numberOf(set, Tag(0x0010, 0x1030), 0);
  pet.frameReferenceS = numberOf(set, Tag(0x0054, 0x1300), 0) * 1e-3;
  pet.frameDurationS = numberOf(set, Tag(0x0018, 0x1242), 0) * 1e-3;
  auto drug = firstItem(set, Tag(0x0054, 0x0016));
  if (!drug) return pet;
  pet.doseBq = numberOf(*drug, Tag(0x0018, 0x1074), 0);
  pet.halfLifeS = numberOf(*drug, Tag(0x0018, 0x1075), 0);
  pet.injectionTime = timeOf(textOf(*drug, Tag(0x0018, 0x1078)));
  if (pet.injectionTime) return pet;
  pet.injectionTime = timeOf(seriesDate, textOf(*drug, Tag(0x0018, 0x1072)));
  // A time without a date may be of the evening before.
  auto scan = pet.acquisitionTime ? pet.acquisitionTime : pet.seriesTime;
  if (pet.injectionTime && scan && *pet.injectionTime > *scan) *pet.injectionTime -= kDayS;
  return pet;
}

Uptake uptakeOf(std::span<const DicomPet* const> files) {
  const DicomPet& pet = *files.front();
  if (pet.units != "BQML") return {};
  bool isAtStart = pet.decayCorrection == "START", isAtInjection = pet.decayCorrection == "ADMIN";
  std::string lacks;
  auto need = [&](bool has, const char* what) { lacks += has ? "" : (lacks.empty() ? "" : ", ") + std::string(what); };
  need(pet.isCorrected, "correction for attenuation and decay");
  need(isAtStart || isAtInjection, "decay correction to the scan's start or the injection");
  need(isPositive(pet.weightKg), "the patient's weight");
  need(isPositive(pet.doseBq), "the injected dose");
  need(isAtInjection || isPositive(pet.halfLifeS), "the half-life");
  need(isAtInjection || pet.injectionTime.has_value(), "the time of injection");
  auto scan = lacks.empty() && isAtStart ? scanTimeOf(files) : std::nullopt;
  if (lacks.empty()) need(isAtInjection || scan.has_value(), "the time of the scan");
  if (!lacks.empty()) return {0, "uptake values (SUV) cannot be had of these Bq/ml: the file lacks " + lacks};
  double minutes = scan ? (*scan - *pet.injectionTime) / 60 : 0;
  // Times that are shifted one by one, to hide who it was, make nonsense.
  if (minutes < 0 || minutes > 60 * 24)
    return {0, fmt::format("uptake values (SUV) cannot be had of these Bq/ml: the scan begins {:.0f} minutes after "
                           "injection",
                           minutes)};
  double dose = pet.doseBq * (scan ? std::exp2(-minutes * 60 / pet.halfLifeS) : 1.0);
  double factor = pet.weightKg * 1000 / dose;
  return {factor,
          fmt::format("values are SUVbw: the file's Bq/ml times {:.6g} ({:.4g} kg, {:.4g} MBq{})", factor, pet.weightKg,
                      pet.doseBq * 1e-6, scan ? fmt::format(" {:.1f} minutes before the scan", minutes) : "")};
}

}  // namespace velum::io
