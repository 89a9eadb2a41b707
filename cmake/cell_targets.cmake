# A library of common/NAME, called from its folder: target cell_NAME.
function(cell_add_common name)
  cmake_parse_arguments(arg "" "" "SOURCES;LINK;PRIVATE" ${ARGN})
  add_library(cell_${name} STATIC ${arg_SOURCES})
  target_include_directories(cell_${name} PUBLIC ${PROJECT_SOURCE_DIR})
  target_link_libraries(cell_${name}
    PUBLIC ${arg_LINK} PRIVATE ${arg_PRIVATE} cell_warnings)
endfunction()

# A service NAME, called from its folder, is a library cell_NAME and an
# executable NAME whose only source is main.cc.
function(cell_add_service name)
  cmake_parse_arguments(arg "" "" "SOURCES;LINK;PRIVATE" ${ARGN})
  add_library(cell_${name} STATIC ${arg_SOURCES})
  target_include_directories(cell_${name} PUBLIC ${PROJECT_SOURCE_DIR})
  target_link_libraries(cell_${name}
    PUBLIC cell_bus cell_config cell_lcmtypes ${arg_LINK}
    PRIVATE ${arg_PRIVATE} cell_warnings)
  add_executable(${name} main.cc)
  target_link_libraries(${name} PRIVATE cell_${name} cell_node cell_warnings)
  install(TARGETS ${name} DESTINATION ${CMAKE_INSTALL_LIBEXECDIR}/cell)
endfunction()
