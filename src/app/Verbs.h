#pragma once
#include "app/Common.h"

/// The verbs of velum-batch, one file each. Each function adds its verb's options to `verb` and returns the function
/// that does the verb's work.
namespace velum::app {

Run registerInfo(CLI::App& verb);
Run registerRender(CLI::App& verb);
Run registerFilm(CLI::App& verb);
Run registerMembrane(CLI::App& verb);
Run registerGrow(CLI::App& verb);
Run registerCount(CLI::App& verb);
Run registerEach(CLI::App& verb);
Run registerMeasure(CLI::App& verb);
Run registerBench(CLI::App& verb);
Run registerCompare(CLI::App& verb);
Run registerSample(CLI::App& verb);
Run registerConvert(CLI::App& verb);
Run registerRecover(CLI::App& verb);
Run registerRunScript(CLI::App& verb);
Run registerHelp(CLI::App& verb);
Run registerView(CLI::App& verb);
Run registerCompletion(CLI::App& verb);

}  // namespace velum::app
