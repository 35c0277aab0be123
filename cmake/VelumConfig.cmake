# find_package(Velum): the target Velum::velum, whose headers are velum/*.h. docs/example is a program that uses it.
include(CMakeFindDependencyMacro)
find_dependency(glm)
include("${CMAKE_CURRENT_LIST_DIR}/VelumTargets.cmake")
