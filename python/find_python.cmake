# Whether the Python module is built. Debian's pybind11 and NumPy go with Debian's Python: another one that comes first
# in the path (pyenv, conda) would not find them. -DPython_EXECUTABLE=… chooses another.
if(NOT Python_EXECUTABLE AND EXISTS /usr/bin/python3)
  set(Python_EXECUTABLE /usr/bin/python3 CACHE FILEPATH "The Python that the module is built for")
endif()
find_package(Python 3.9 COMPONENTS Interpreter Development.Module QUIET)
set(PYBIND11_FINDPYTHON ON)
find_package(pybind11 2.10 QUIET)
# With a sanitizer the interpreter would have to be instrumented, too. Where it cannot be built nothing is remembered, so
# that it is built once the packages are there.
if(Python_Development.Module_FOUND AND pybind11_FOUND AND NOT HANDLEBODY_SANITIZE)
  option(HANDLEBODY_PYTHON "Build the Python module (pybind11-dev, python3-dev)" ON)
elseif(HANDLEBODY_PYTHON)
  message(FATAL_ERROR "HANDLEBODY_PYTHON needs pybind11-dev and python3-dev, and no sanitizer.")
else()
  set(HANDLEBODY_PYTHON OFF)
endif()
# For libraries that become part of the module, or of a shared library of somebody who has installed the engine. Without
# the second option GCC would not inline across functions of a file, as somebody might put another in their place.
function(handlebody_for_module target)
  set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  target_compile_options(${target} PRIVATE -fno-semantic-interposition)
endfunction()
