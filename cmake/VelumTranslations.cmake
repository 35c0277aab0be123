# velum_translations(<target> languages ...): the window's words in other languages, of translations/velum_<language>.ts,
# compiled into the program as :/velum/translations/velum_<language>.qm; beside them Qt's own words of dialogs, where Qt's
# translations are on this machine. Q_INIT_RESOURCE(translations) makes them known.
function(velum_translations target)
  set(folder "${CMAKE_CURRENT_BINARY_DIR}/translations")
  set(files "")
  set(commands "")
  set(sources "")
  foreach(language ${ARGN})
    set(ts "${PROJECT_SOURCE_DIR}/translations/velum_${language}.ts")
    list(APPEND sources "${ts}")
    list(APPEND commands COMMAND Qt6::lrelease -silent "${ts}" -qm "${folder}/velum_${language}.qm")
    string(APPEND files "<file>velum_${language}.qm</file>")
    set(own "${QT6_INSTALL_PREFIX}/${QT6_INSTALL_TRANSLATIONS}/qtbase_${language}.qm")
    if(EXISTS "${own}")
      string(APPEND files "<file alias=\"qtbase_${language}.qm\">${own}</file>")
    else()
      message(STATUS "Qt's own words are not embedded in the language ${language}: ${own} is missing")
    endif()
  endforeach()
  file(CONFIGURE OUTPUT "${folder}/translations.qrc"
    CONTENT "<RCC><qresource prefix=\"/velum/translations\">${files}</qresource></RCC>\n")
  add_custom_command(OUTPUT "${folder}/qrc_translations.cpp" ${commands}
    COMMAND Qt6::rcc --name translations "${folder}/translations.qrc" -o "${folder}/qrc_translations.cpp"
    DEPENDS ${sources} "${folder}/translations.qrc" VERBATIM)
  target_sources(${target} PRIVATE "${folder}/qrc_translations.cpp")
  set_source_files_properties("${folder}/qrc_translations.cpp" PROPERTIES SKIP_AUTOGEN ON SKIP_UNITY_BUILD_INCLUSION ON
    SKIP_PRECOMPILE_HEADERS ON)
endfunction()
