# What is compiled for newer processors stays apart: else the linker could take its version of a shared
# function for the whole program, which would then stop on older processors.
#   cmake -DNM=nm -DOBJECTS=FILES -P check_instructions.cmake
list(FILTER OBJECTS INCLUDE REGEX "products_avx2")
if(NOT OBJECTS)
  message(FATAL_ERROR "no object file of products_avx2.cpp")
endif()
execute_process(COMMAND ${NM} -C ${OBJECTS} OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "[^\n]* [VWu] [^\n]*" shared "${symbols}")
list(FILTER shared EXCLUDE REGEX "EigenAvx2|DW\\.ref")
if(shared)
  list(JOIN shared "\n" shared)
  message(FATAL_ERROR "compiled for newer processors, and shared with other files:\n${shared}")
endif()
