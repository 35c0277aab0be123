#pragma once
#include <string>

#include "gpu/GpuError.h"

/// Mesa's software driver, where it stands in for a driver that offers too little.
namespace velum::gpu {

/// What is said where it does. @param tooOld  what TooOld says
std::string softwareInstead(const std::string& tooOld);
/// Says so as a warning, once in a process.
void warnOfSoftware(const std::string& tooOld);
/// What is said where nothing stands in. @param otherwise  why Mesa's software driver does not; may be empty
std::string nothingInstead(const std::string& tooOld, const std::string& otherwise);

/// Starts the program once more, in this process, with Mesa's software driver: where windows draw the driver is the
/// system's choice, which is made once in a process. Does not return. @param arguments  as main() got them; ends with
/// null @throw GpuError where that has been done already, or cannot be; it says both
[[noreturn]] void startOnSoftware(const TooOld& error, char* const* arguments);
/// Why the program was started once more, as TooOld says it; empty: it was not.
std::string softwareReason();

}  // namespace velum::gpu
